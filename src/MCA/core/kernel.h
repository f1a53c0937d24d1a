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
/// and passes over the viscous contacts, which are few (viscous_contacts.h).
/// Between them what automata answer goes to the ranks that have them as guests (exchange.h).
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
#include "pairs.h"
#include "rows.h"
#include "viscous_columns.h"

#include <vector>

namespace mca {

/// Moves the shear on by one step and adds each contact's strain to both of its automata. Pairs of
/// guests are computed from the guests' places and velocities, which LAMMPS's own communication has
/// brought.
/// \param dt       the step [time]
/// \param moves    false keeps the state as it is (set-up); all else is the same to the last bit
/// \param laws     table of PairLaw
/// \param motion   rows.motion.length values an automaton, also of images and guests
/// \param spin     angular velocity of each automaton about z, in space its third component
///                 [1/time]
/// \param strains  rows.strain.length values an automaton, added to
using StrainPass = void(const Pairs &, double dt, bool moves, const PairLaw *laws,
                        const double *motion, const double *spin, double *strains);

/// Mean stress of each automaton, sigma_mean = K w sum e.
/// \param n         own automata; what guests answer comes from their owners
/// \param type      material number of each automaton, used to index laws
/// \param oneLaw    the materials of all automata are equal: laws[type[0]] serves all
/// \param strains   of the strain pass
/// \param response  rows.response.length values an automaton; the mean stress is written, and the
///                  pressure against lack of room where the rows have one
/// \return how many automata have such a pressure, a whole number
using MeanPass = double(int n, const int *type, const AutomatonLaw *laws, bool oneLaw,
                        const double *strains, double *response);

/// Adds the elastic stress of each contact, before any return, to the averaged stress of both of
/// its automata, and its force to their forces.
/// \param response  the mean stresses of both automata are read, hence of guests, too
/// \param sums      rows.stress.length values an automaton, added to
using StressPass = void(const Pairs &, const PairLaw *laws, const double *response, double *sums);

/// Stress intensity and radial return of each automaton, radialReturn() of laws/plasticity.h; an
/// automaton without a contact that flows with it does not flow.
/// \param flowed     one of them flowed in the last evaluation, or there was none. Else all answers
///                   are those of automata that do not flow, and stay so where none does now
/// \param strains    the number of these contacts is read
/// \param stresses   the averaged stress is read
/// \param kappa      equivalent plastic strain [-]
/// \param kappaNext  the same at the beginning of the next step, written for all n where one flows
/// \param response   the factor M is written, and the centre where the rows have one
/// \return how many automata flow, a whole number: without any, all factors are 1
using YieldPass = double(int n, const int *type, const AutomatonLaw *laws, bool oneLaw, bool flowed,
                         const double *strains, const double *stresses, const double *kappa,
                         double *kappaNext, double *response);

/// Adds what the returns take from the elastic stresses of contacts that flow to both of their
/// automata. Blocks in which no automaton flows are passed over.
/// \param response  mean, factor and centre of both automata are read, hence of guests, too
/// \param taken     rows.taken.length values an automaton, added to: the tensor, and with isochoric
///                  in place of the sum `flowing` that of squares for strainOfWork(), less centre^2
using ReturnPass = void(const Pairs &, const PairLaw *laws, const double *response, double *taken);

/// The radial return of each automaton that flows, once more; see secondReturn(). The others, with
/// a factor of 1, keep all that they have.
/// \param taken      of the return pass, complete on these automata
/// \param kappaNext  written where an automaton flows
/// \param response   the factor M is read and written
using SecondYieldPass = void(int n, const int *type, const AutomatonLaw *laws,
                             const double *strains, const double *stresses, const double *taken,
                             const double *kappa, double *kappaNext, double *response);

/// Stresses of the contacts after returns, what these, viscosity and lack of room add to the
/// elastic forces and torques of both automata, next state. Next states are written of blocks in
/// which anything may change; Block::moves says where they differ from the present ones.
/// \param response  complete rows of both automata, hence of guests, too
/// \param returned  the return pass has found the pairs that flow
/// \param local     rows.local.length values an automaton, or nullptr where no law needs them
/// \param sums      of the stress pass, whose forces are added to
/// \return how many pairs change their kind, a whole number
using ForcePass = double(const Pairs &, const PairLaw *laws, const double *response, bool returned,
                         const double *local, double *sums);

/// The passes over viscous contacts; viscous_contacts.h says what each is for. Every instruction
/// set computes the same, to the last bit. Contacts `first` to `last - 1` are worked on.
struct ViscousPasses {
  /// \param numbers  of the viscous pairs in rising order, written: room for all pairs
  /// \return how many they are
  int (*find)(const Pairs &, int *numbers);
  /// Writes slip velocities of half a step ago, and `along` of the whole resistance to them.
  void (*slip)(const Pairs &, const ViscousColumns &, const ViscousStep &);
  /// Writes centred velocities, and `normal` and `along` of what they change.
  /// \param slips  false leaves `slip` and `along`
  void (*centre)(const Pairs &, const ViscousColumns &, int first, int last, bool slips,
                 const ViscousStep &);
  /// Adds `normal`, and `along` of all contacts, to both of their automata.
  /// \param sums  rows.stress.length values an automaton
  void (*addNormal)(const Pairs &, const ViscousColumns &, int first, int last, double *sums);
  void (*addAlong)(const Pairs &, const ViscousColumns &, double *sums);
};

/// The passes compiled for one instruction set and one dimension. All kernels of a dimension
/// compute the same, but for the last bits of sums and products that an instruction set contracts.
struct Kernel {
  /// The instruction set, as benchmarks and tests print it: baseline, avx2, avx512.
  const char *name;
  int dimension;
  /// Lengths and offsets of all rows that the passes are given.
  RowLayout rows;
  StrainPass *strain;
  MeanPass *mean;
  StressPass *stress;
  YieldPass *yield;
  ReturnPass *returns;
  SecondYieldPass *yieldAgain;
  ForcePass *force;
  const ViscousPasses *viscous;
  /// The passes of plasticity isochoric; nullptr in these themselves. Only rows of response may
  /// differ.
  const Kernel *keepsVolume;
};

namespace baseline {
extern const Kernel plane, space;
extern const ViscousPasses planeViscous, planeIsochoricViscous, spaceViscous, spaceIsochoricViscous;
} // namespace baseline
namespace avx2 {
extern const Kernel plane, space;
extern const ViscousPasses planeViscous, planeIsochoricViscous, spaceViscous, spaceIsochoricViscous;
} // namespace avx2
namespace avx512 {
extern const Kernel plane, space;
extern const ViscousPasses planeViscous, planeIsochoricViscous, spaceViscous, spaceIsochoricViscous;
} // namespace avx512

/// The fastest kernel of this dimension that this processor runs; it lives as long as the program.
/// \param dimension  2 or 3; all but 2 counts as space
const Kernel &bestKernel(int dimension);

/// All kernels of this dimension that this processor runs, the baseline first, the fastest last. On
/// processors other than x86-64 there is the baseline alone.
std::vector<const Kernel *> supportedKernels(int dimension);

} // namespace mca

#endif
