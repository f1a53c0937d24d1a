/// \file kernel.h
/// The inner loops of MCA: one pass over pairs for strains, one over automata for yielding, one
/// over pairs for stresses, forces and the next state of the links.
///
/// No LAMMPS type in here. The forces of a step are a pure function of positions, velocities and
/// the pair state `now`; what plasticity, fracture and linking change is written to `next` and
/// taken over at the beginning of the following step. Hence a run that continues from a restart
/// file recomputes the very same forces.
///
/// Plane problem; per-automaton arrays are rows of fixed length, 64-byte aligned, so that an
/// automaton costs one cache line. All quantities in one consistent set of units.
#ifndef MCA_KERNEL_H
#define MCA_KERNEL_H

#include "laws/contact.h"

#include <vector>

namespace mca {

/// Laws of one material as an automaton's own.
struct AutomatonLaw {
  double bulkModulus, shearModulus;  ///< K, G [stress]
  double D;                          ///< 1 - 2G/(3K), or 0 for the pairwise law [-]
  double yields;                     ///< 1 with radial return, 0 without
  YieldCurve curve;
};

/// State of the pairs that outlives a step, one value a pair.
struct PairState {
  double *kind;        ///< link::none, link::bulk, link::weld
  double *plastic;     ///< plastic offset of the normal strain [-]
  double *gamma;       ///< elastic shear [-]
  double *gammaTotal;  ///< shear since linking, not reduced by plasticity [-]
};

/// A block of the pair list; all arrays have `n` values.
struct Pairs {
  int n;
  const int *i, *j;   ///< row numbers of the two automata
  const int *law;     ///< number in the table of PairLaw
  PairState now, next;
  double *nx, *ny;    ///< unit normal from i to j [-]
  double *eps;        ///< total normal strain r/d - 1 [-]
  double *separation; ///< normal velocity of j seen from i [length/time]
};

/// Lengths of the rows of the per-automaton arrays.
constexpr int motionRow = 8;    ///< x, y, vx, vy, omega, then unused
constexpr int sumsRow = 8;      ///< Pxx, Pyy, Pxy, Nxx, Nyy, Nxy, bulk links, sum(e^2 + gamma^2)
constexpr int responseRow = 2;  ///< mean stress [stress], factor M of the radial return [-]
constexpr int forceRow = 4;     ///< fx, fy [force], torque [force length], unused

/// First pass: takes over the next state, moves the shear on by one step and adds each contact's
/// share to both of its automata.
/// \param dt      the step [time]; 0 keeps `now` as it is (set-up)
/// \param laws    table of PairLaw; with \p oneLaw the first entry serves all pairs
/// \param motion  motionRow values an automaton
/// \param sums    sumsRow values an automaton, added to
using StrainPass = void(const Pairs &, double dt, const PairLaw *laws, bool oneLaw,
                        const double *motion, double *sums);

/// Second pass, over automata: mean stress, stress intensity, radial return.
/// \param type        material number of each automaton (1-based LAMMPS type), used to index laws
/// \param kappa       equivalent plastic strain [-]
/// \param kappaNext   the same at the beginning of the next step
/// \param response    responseRow values an automaton, written
using YieldPass = void(int n, const int *type, const AutomatonLaw *laws, const double *sums,
                       const double *kappa, double *kappaNext, double *response);

/// Third pass: stresses of the contacts, forces and torques on both automata, next state.
/// \param forces  forceRow values an automaton, added to
/// \return how many pairs change their kind
using ForcePass = double(const Pairs &, const PairLaw *laws, bool oneLaw,
                         const double *response, double *forces);

/// The passes compiled for one instruction set.
struct Kernel {
  const char *name;
  StrainPass *strain;
  YieldPass *yield;
  ForcePass *force;
};

namespace baseline { extern const Kernel kernel; }
namespace avx2 { extern const Kernel kernel; }
namespace avx512 { extern const Kernel kernel; }

/// The fastest kernel that this processor runs.
const Kernel &bestKernel();

/// All kernels that this processor runs, the baseline first.
std::vector<const Kernel *> supportedKernels();

}  // namespace mca

#endif
