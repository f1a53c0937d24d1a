// SPDX-License-Identifier: GPL-2.0-or-later
/// \file kernel_plane.h
/// What the kernel does otherwise in the plane than in space: rows gathered and scattered, the
/// shear a number. kernel_space.h is its sibling, with the same names. For the kernel's source
/// only.
/// The equations stand in doc/laws.md. gather() reads rows of automata into columns, one value of
/// each pair of a block, over which the pass's loop runs as vectors, and scatter() adds columns to
/// the rows of both automata. k counts pairs within the block; pi and pj are the rows of both
/// automata, n is the number of pairs.
#ifndef MCA_KERNEL_PLANE_H
#define MCA_KERNEL_PLANE_H

#include "kernel_blocks.h"
#include "laws/automaton_law.h"
#include "laws/pair_motion.h"
#include "rows.h"

namespace mca::MCA_ISA {
namespace {

// The traits of the plane: what the passes take as their argument D. Names and
// signatures are those of Space.
struct Plane {
  // Where a quantity stands in its row; rows.h.
  static constexpr RowLayout rows = planeRows;
  // Components of a shear of PairState that exist.
  static constexpr int shears = 1;
  // Automata answer lack of room: plasticity isochoric.
  static constexpr bool keepsVolume = false;
  // Stretch of a contact by its plastic shear: 0, but with isochoric.
  // \param total  a function that gives the total shear, which is not asked for here
  template<class Total>
  static Stretch stretch(double /*left*/, double /*gamma*/, const Total & /*total*/)
  {
    return {};
  }
  // A shear or shear stress of a pair along t, the normal turned by +90 degrees.
  using Shear = double;
  // The unit normal of a pair, from i to j.
  using Normal = PlaneVector;

  // The step of the strain pass: dt [time], and a factor that is 1, or 0 at set-up, when nothing
  // moves on. A factor, since distances and normals then come out the same to the last bit; so do
  // the forces of a run that goes on from a restart file.
  struct Time {
    double dt, moves;
    Time(double step, bool moving) : dt(step), moves(moving ? 1.0 : 0.0) {}
  };

  // Motion of j seen from i and the sum of both spins of each pair, as columns: place [length],
  // velocity [length/time], spins [1/time]. Works on whole fours: Pairs are padded.
  struct Motion {
    Column x, y, vx, vy, spins;

    // Reads the rows of four pairs at a time: place and velocity of an automaton are one vector of
    // four.
    // \param pi,pj   Pairs::placeI and placeJ, or i and j: rows of images for pairs over a periodic
    //                face
    // \param motion  rows.motion.length values an automaton: place and velocity
    // \param spin    angular velocity of each automaton about z [1/time]
    void gather(const int *pi, const int *pj, int n, const double *motion, const double *spin)
    {
      for (int k = 0; k < n; k += 4) {
        Row4 r[4];
        for (int m = 0; m < 4; m++) {
          const int i = pi[k + m], j = pj[k + m];
          r[m] = *rowOf<Row4>(motion, j) - *rowOf<Row4>(motion, i);
          spins[k + m] = spin[i] + spin[j];
        }
        store(r, k, x, y, vx, vy);
      }
    }

    // Velocity of j seen from i of pair k of the block [length/time].
    PlaneVector velocity(int k) const { return {vx[k], vy[k]}; }

    // Sum of both angular velocities of pair k [1/time].
    Vector spin(int k) const { return {0.0, 0.0, spins[k]}; }

    // Motion of pair k in the step; also gives the distance.
    // \param time  of this pass
    // \param r     set to the distance at the end of the step [length]
    // \return for carriedShear() and shearGrowth() of laws/pair_motion.h, with the normal
    PlaneMotion of(int k, const Time &time, double &r) const
    {
      const PlaneMotion moved =
          pairMotion({x[k], y[k]}, velocity(k), spins[k], time.dt, time.moves);
      r = moved.r;
      return moved;
    }
  };

  // Answers of one automaton of each pair: mean stress [stress] and factor M of the return [-]; the
  // rows RowLayout::Response. One object for the first automata, one for the second ones.
  struct Answers {
    Column mean, factor;

    // Both values.
    // \param index     row of the automaton of each pair: Pairs::i or Pairs::j
    // \param response  rows.response.length values an automaton
    void gather(const int *index, int n, const double *response)
    {
      mca::MCA_ISA::gather(index, n, response, mean, factor);
    }
    // Reads both, too: a row of two values is read in one load, so there is nothing to save.
    void gatherMeans(const int *index, int n, const double *response)
    {
      gather(index, n, response);
    }
    // What the automaton of pair k answers. Normal stresses return to the mean stress (MCA).
    Answer operator[](int k) const { return {mean[k], factor[k], mean[k]}; }
  };

  // What each pair adds to the averaged stresses of both of its automata [stress], with the weight
  // 1/3 of the hexagonal packing in it.
  struct Shares {
    Columns<1> row;

    Shares() { row.clearFrom(rows.components); }
    // The share of pair k in the tensor, stressShare() of laws/elasticity.h.
    // \param sigma,tau  normal and shear stress of the contact [stress], tension positive
    // \param n          its unit normal [-]
    void set(int k, double sigma, double tau, const PlaneVector &n)
    {
      const StressTensor s = stressShare(sigma, tau, n.x, n.y);
      row.c[0][k] = s.xx;
      row.c[1][k] = s.yy;
      row.c[2][k] = s.xy;
    }
    // No sum of stresses: the centre is the mean.
    void setFlowing(int, double /*flowing*/) {}
  };

  // Forces [force] and torques [force length] of each pair on its first automaton; the torque is
  // about z.
  struct Forces {
    Columns<1> row;

    Forces() { row.clearFrom(3); }
    // Force and torque of pair k of the block.
    void set(int k, const PlaneForce &f)
    {
      row.c[0][k] = f.x;
      row.c[1][k] = f.y;
      row.c[2][k] = f.torque;
    }
  };

  // Averaged stress tensor of an automaton [stress]: sigma_zz = 3 mean - sigma_xx - sigma_yy. The
  // weight of the packing is in the shares already.
  // \param tensor  xx, yy, xy of the stress pass [stress]; less what was returned, for the second
  //                yield pass
  // \param mean    mean stress of the automaton [stress]; the return does not change it
  static StressTensor averaged(const AutomatonLaw &, const double *tensor, double mean)
  {
    return automatonStress(tensor[0], tensor[1], tensor[2], mean);
  }

  // In the plane the centre of the return is the mean stress itself, so a row has no place for it.
  static void setCentre(double * /*response*/, const double * /*stress*/, double /*contacts*/) {}

  // The tensor of a row of local, or of the mean of two rows, with the mean stress that goes with
  // it [stress].
  // \param tensor  xx, yy, xy after the return, the weight in them [stress]
  // \param mean    mean stress, which the return leaves as it is [stress]
  static StressTensor localTensor(const double *tensor, double mean)
  {
    return automatonStress(tensor[0], tensor[1], tensor[2], mean);
  }
};

// The plane with plasticity isochoric.
struct PlaneIsochoric : Plane {
  static constexpr RowLayout rows = planeIsochoricRows;
  static constexpr bool keepsVolume = true;
  using Answers = RoomAnswers<planeIsochoricRows>;

  // Plane's shares with one more sum.
  struct Shares : Plane::Shares {
    // \param flowing  sigma of a contact that flows with them, else 0 [stress]; of the return pass
    //                 its square and those of its shear [stress^2]
    void setFlowing(int k, double flowing) { row.c[rows.stress.flowing][k] = flowing; }
  };

  // Where only the plane flows, the stress across it is the mean of those in it, so that the
  // intensity is sqrt(3) times the largest shear stress.
  static StressTensor averaged(const AutomatonLaw &, const double *tensor, double /*mean*/)
  {
    return flowStress(tensor[0], tensor[1], tensor[2]);
  }

  static void setCentre(double *response, const double *stress, double contacts)
  {
    meanOfFlow<planeIsochoricRows>(response, stress, contacts);
  }

  template<class Total>
  static Stretch stretch(double left, double gamma, const Total &total)
  {
    return shearStretch(left, gamma, total());
  }
};

} // namespace
} // namespace mca::MCA_ISA

#endif
