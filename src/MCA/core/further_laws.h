// SPDX-License-Identifier: GPL-2.0-or-later
/// \file further_laws.h
/// What laws that are off by default add between the passes of the kernel: flow across the plane
/// (plasticity j2), and the averaged stresses and plastic work that criteria of local stress and
/// of plastic work need. Loops over the automata of this rank; units as in kernel.h.
#ifndef MCA_FURTHER_LAWS_H
#define MCA_FURTHER_LAWS_H

#include "kernel.h"

namespace mca {

/// After the mean pass: adds K e_zz to the mean stresses (doc/laws.md, Plasticity). In the plane
/// only.
/// \param n         number of automata
/// \param type      number in `laws` of each of them
/// \param elasticZ  elastic strain across the plane of each automaton [-]
/// \param response  rows of planeRows.response; the mean stress is added to
void addElasticZ(int n, const int *type, const AutomatonLaw *laws, const double *elasticZ,
                 double *response);

/// After the yield passes, before the force pass: the elastic strain across the plane of the next
/// step, elasticZAfter() of laws/plane.h. An automaton without a bulk link forgets it, as a contact
/// forgets its plastic offset when it opens. In the plane only.
/// \param strains       rows of the strain pass; the number of bulk links is read
/// \param stresses      rows of the stress pass, before the return
/// \param response      rows with mean stress and final factor M
/// \param elasticZ      of this step [-]
/// \param elasticZNext  of the next one [-], written for all n
void flowElasticZ(int n, const int *type, const AutomatonLaw *laws, const double *strains,
                  const double *stresses, const double *response, const double *elasticZ,
                  double *elasticZNext);

/// After the yield passes: what each automaton shows to the criteria of its contacts, the averaged
/// stress after the return p 1 + M (sigma - p 1) and the plastic work of the step (doc/laws.md,
/// Links).
/// \param kappa,kappaNext  equivalent plastic strain of this step and of the next [-]
/// \param local            rows.local.length values an automaton, written; a last column that is
///                         not used is left as it is
void showLocal(const RowLayout &, int n, const int *type, const AutomatonLaw *laws,
               const double *stresses, const double *response, const double *kappa,
               const double *kappaNext, double *local);

} // namespace mca

#endif
