// SPDX-License-Identifier: GPL-2.0-or-later
/// \file further_laws.h
/// What laws that are off by default add between the passes of the kernel: the averaged stresses
/// and plastic work that criteria of local stress and of plastic work need. Loops over the automata
/// of this rank; units as in kernel.h.
#ifndef MCA_FURTHER_LAWS_H
#define MCA_FURTHER_LAWS_H

#include "kernel.h"

namespace mca {

/// After the yield passes: what each automaton shows to the criteria of its contacts, the averaged
/// stress after the return p 1 + M (sigma - p 1) and the plastic work of the step (doc/laws.md,
/// Links). In the plane p is the mean stress, where flow keeps the volume that of the stresses in
/// the plane.
/// \param keepsVolume      plasticity j2
/// \param kappa,kappaNext  equivalent plastic strain of this step and of the next [-]
/// \param local            rows.local.length values an automaton, written; a last column that is
///                         not used is left as it is
void showLocal(const RowLayout &, bool keepsVolume, int n, const int *type,
               const AutomatonLaw *laws, const double *stresses, const double *response,
               const double *kappa, const double *kappaNext, double *local);

} // namespace mca

#endif
