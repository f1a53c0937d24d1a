// SPDX-License-Identifier: GPL-2.0-or-later
/// \file further_laws.h
/// What laws that are off by default add between the passes of the kernel: flow across the plane
/// (plasticity j2), and the averaged stresses and plastic work that criteria of local stress and
/// of plastic work need. Loops over the automata of this rank; units as in kernel.h.
#ifndef MCA_FURTHER_LAWS_H
#define MCA_FURTHER_LAWS_H

#include "kernel.h"

namespace mca {

/// After the mean pass: adds K e_zz to the mean stresses.
/// \param elasticZ  elastic strain across the plane of each automaton [-]
void addElasticZ(int n, const int *type, const AutomatonLaw *laws, const double *elasticZ,
                 double *response);

/// After the yield pass: the elastic strain across the plane of the next step. An automaton without
/// a bulk link forgets it, as a contact forgets its plastic offset when it opens.
void flowElasticZ(int n, const int *type, const AutomatonLaw *laws, const double *strains,
                  const double *stresses, const double *response, const double *elasticZ,
                  double *elasticZNext);

/// After the yield pass: what each automaton shows to the criteria of its contacts.
/// \param local  rows.local.length values an automaton, written
void showLocal(const RowLayout &, int n, const int *type, const AutomatonLaw *laws,
               const double *stresses, const double *response, const double *kappa,
               const double *kappaNext, double *local);

} // namespace mca

#endif
