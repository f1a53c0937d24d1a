// SPDX-License-Identifier: GPL-2.0-or-later
/// \file kernel.h
/// The inner loops of MCA. Pairs are passed over three times, since yielding is decided on the
/// averaged stress of an automaton, which holds the mean stresses of its neighbours, and where
/// something flows a fourth time:
///   strain pass (pairs)      strains, sums of elastic normal strains
///   mean pass (automata)     mean stresses
///   stress pass (pairs)      elastic stresses of the contacts, averaged stress tensors
///   yield pass (automata)    stress intensities, radial returns
///   return pass (pairs)      what these returns take from the averaged stress tensors
///   second yield (automata)  the returns again, with what the neighbours' took
///   force pass (pairs)       stresses after the return, forces, the next state of the links
/// What viscous contacts change after that stands in viscous_contacts.h.
/// Between them LAMMPS adds up what several ranks hold of an automaton.
///
/// No LAMMPS type in here. The forces of a step are a pure function of positions, velocities and
/// the pair state `now`; what plasticity, fracture and linking change is written to `next`, which
/// becomes `now` at the beginning of the following step. Hence a run that continues from a restart
/// file recomputes the very same forces. Where nothing flows, breaks or links, which is most of a
/// sample, both states are equal and `next` is not touched.
///
/// Per-automaton arrays are rows, see rows.h. All quantities in one consistent set of units.
#ifndef MCA_KERNEL_H
#define MCA_KERNEL_H

#include "laws/automaton_law.h"
#include "laws/contact.h"
#include "rows.h"

#include <vector>

namespace mca {

/// Pairs are worked on in blocks of this length, whose temporary rows stay in the first-level
/// cache.
constexpr int blockLength = 128;

/// Most shear components of a pair: one in the plane, a vector in space.
constexpr int maxShears = 3;

/// State of the pairs that outlives a step, one value a pair. In the plane only the first component
/// of the shears exists.
struct PairState {
  double *kind;                  ///< link::worn, none, bulk or weld
  double *plastic;               ///< plastic offset of the normal strain [-]
  double *gamma[maxShears];      ///< elastic shear [-]
  double *gammaTotal[maxShears]; ///< shear since linking, not reduced by plasticity [-]; the first
                                 ///< of an unlinked contact: plastic work per volume while pressed
                                 ///< together, where a law needs it [stress]
};

/// What is known of all pairs of a block, so that most blocks take a short way.
struct Block {
  static constexpr int mixed = -1;
  int law;       ///< number of the law of all its pairs, or mixed
  bool bulk;     ///< all its pairs are bulk links
  bool pristine; ///< ... that never flowed: plastic is 0, and gammaTotal equals gamma, which alone
                 ///< is kept up to date
  bool breaks;   ///< one of them reaches the breaking strain in this step
  bool moves;    ///< the next state differs from the present one; only then is it held in `next`
  bool across;   ///< one of them meets over a periodic face; else placeI, placeJ equal i, j
};

/// The pair list; arrays have `n` values, row numbers three more, which repeat the last pair.
struct Pairs {
  int n;
  const int *i, *j;           ///< row numbers of the two automata
  const int *placeI, *placeJ; ///< rows of motion where they meet: of images, over a periodic face
  const int *law;             ///< number in the table of PairLaw
  PairState now, next;
  double *normal[3];  ///< unit normal from i to j [-]; two components in the plane
  double *eps;        ///< total normal strain r/d - 1 [-]
  double *separation; ///< normal velocity of j seen from i [length/time]; not of bulk blocks; of
                      ///< half a step ago, until viscous contacts are centred
  Block *blocks;      ///< of blockLength pairs each
};

/// Moves the shear on by one step and adds each contact's strain to both of its automata.
/// \param dt       the step [time]
/// \param moves    false keeps the state as it is (set-up); all else is the same to the last bit
/// \param laws     table of PairLaw
/// \param motion   rows.motion.length values an automaton
/// \param spin     angular velocity of each automaton [1/time]
/// \param strains  rows.strain.length values an automaton, added to
using StrainPass = void(const Pairs &, double dt, bool moves, const PairLaw *laws,
                        const double *motion, const double *spin, double *strains);

/// Mean stress of each automaton.
/// \param type      material number of each automaton, used to index laws
/// \param oneLaw    the materials of all automata are equal: laws[type[0]] serves all
/// \param response  rows.response.length values an automaton; the mean stress is written
using MeanPass = void(int n, const int *type, const AutomatonLaw *laws, bool oneLaw,
                      const double *strains, double *response);

/// Adds the elastic stress of each contact to the averaged stress of both of its automata.
/// \param stresses  rows.stress.length values an automaton, added to
using StressPass = void(const Pairs &, const PairLaw *laws, const double *response,
                        double *stresses);

/// Stress intensity and radial return of each automaton.
/// \param kappa      equivalent plastic strain [-]
/// \param kappaNext  the same at the beginning of the next step
/// \param response   the factor M is written
/// \return how many automata flow: without any, kappaNext equals kappa
using YieldPass = double(int n, const int *type, const AutomatonLaw *laws, bool oneLaw,
                         const double *strains, const double *stresses, const double *kappa,
                         double *kappaNext, double *response);

/// Adds what the radial returns take from the elastic stresses of bulk links to both of their
/// automata. Blocks in which no automaton flows are passed over.
/// \param taken  rows.stress.length values an automaton, added to; only the tensor is
using ReturnPass = void(const Pairs &, const PairLaw *laws, const double *response, double *taken);

/// The radial return of each automaton that flows, once more; see secondReturn().
/// \param taken  of the return pass
using SecondYieldPass = void(int n, const int *type, const AutomatonLaw *laws,
                             const double *stresses, const double *taken, const double *kappa,
                             double *kappaNext, double *response);

/// Stresses of the contacts, forces and torques on both automata, next state.
/// \param local   rows.local.length values an automaton, or nullptr where no law needs them
/// \param forces  rows.force.length values an automaton, added to
/// \return how many pairs change their kind
using ForcePass = double(const Pairs &, const PairLaw *laws, const double *response,
                         const double *local, double *forces);

/// The passes compiled for one instruction set.
struct Kernel {
  const char *name;
  int dimension;
  RowLayout rows;
  StrainPass *strain;
  MeanPass *mean;
  StressPass *stress;
  YieldPass *yield;
  ReturnPass *returns;
  SecondYieldPass *yieldAgain;
  ForcePass *force;
};

namespace baseline {
extern const Kernel plane, space;
}
namespace avx2 {
extern const Kernel plane, space;
}
namespace avx512 {
extern const Kernel plane, space;
}

/// The fastest kernel of this dimension that this processor runs.
const Kernel &bestKernel(int dimension);

/// All kernels of this dimension that this processor runs, the baseline first.
std::vector<const Kernel *> supportedKernels(int dimension);

} // namespace mca

#endif
