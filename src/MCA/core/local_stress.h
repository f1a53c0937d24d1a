// SPDX-License-Identifier: GPL-2.0-or-later
/// \file local_stress.h
/// What automata show to criteria of local stress and of plastic work, which are off by default:
/// averaged stresses and plastic work, found between the passes of the kernel. Loops over the
/// automata of this rank; units as in kernel.h.
#ifndef MCA_LOCAL_STRESS_H
#define MCA_LOCAL_STRESS_H

#include "row_view.h"

namespace mca {

/// After the yield passes: what each automaton shows to the criteria of its contacts, the averaged
/// stress after the return p 1 + M (sigma - p 1) and the plastic work of the step (doc/laws.md,
/// Links). In the plane p is the mean stress, where flow keeps the volume that of the stresses in
/// the plane.
/// \param rows             their stresses and answers are read
/// \param keepsVolume      plasticity isochoric
/// \param kappa,kappaNext  equivalent plastic strain of this step and of the next [-]
/// \param local            rows.local.length values an automaton, written; a last column that is
///                         not used is left as it is
void showLocal(const RowView &rows, bool keepsVolume, int n, const int *type,
               const AutomatonLaw *laws, const double *kappa, const double *kappaNext,
               double *local);

} // namespace mca

#endif
