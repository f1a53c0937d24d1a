// SPDX-License-Identifier: GPL-2.0-or-later
// The passes, for the plane and for space. Compiled once for each instruction set; MCA_ISA names
// the set and its namespace. Everything a pass calls is inlined into it (see CMakeLists.txt), so no
// function compiled for a newer processor can be picked up by an older one.
//
// The physics stands in laws/. Here a block's pairs are gathered to columns, a loop applies the
// laws to each, and the results are added to both automata. Each loop exists once for each way that
// a block may go, with all that the way knows left out by the compiler.
#include "kernel.h"

#include "kernel_force.h"
#include "kernel_strain.h"
#include "kernel_stress.h"

namespace mca::MCA_ISA {
namespace {

template<class D>
constexpr Kernel kernelOf(const ViscousPasses *viscous, const Kernel *keepsVolume)
{
  Kernel k{};
  k.name = MCA_ISA_NAME;
  k.dimension = D::rows.dimension;
  k.rows = D::rows;
  k.strain = strainPass<D>;
  k.mean = meanPass<D>;
  k.stress = stressPass<D>;
  k.yield = yieldPass<D>;
  k.returns = returnPass<D>;
  k.yieldAgain = secondYieldPass<D>;
  k.force = forcePass<D>;
  k.viscous = viscous;
  k.keepsVolume = keepsVolume;
  return k;
}

constexpr Kernel planeIsochoric = kernelOf<PlaneIsochoric>(&planeIsochoricViscous, nullptr),
                 spaceIsochoric = kernelOf<SpaceIsochoric>(&spaceIsochoricViscous, nullptr);

} // namespace

extern const Kernel plane = kernelOf<Plane>(&planeViscous, &planeIsochoric);
extern const Kernel space = kernelOf<Space>(&spaceViscous, &spaceIsochoric);

} // namespace mca::MCA_ISA
