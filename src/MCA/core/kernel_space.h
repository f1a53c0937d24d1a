// SPDX-License-Identifier: GPL-2.0-or-later
/// \file kernel_space.h
/// What the kernel does otherwise in space than in the plane: rows of eight values, the shear a
/// vector. kernel_plane.h is its sibling, with the same names. For the kernel's source only.
/// The equations stand in doc/laws.md, Three dimensions. Each struct handles one block: gather()
/// reads rows of automata into columns, one value of each pair, over which the pass's loop runs as
/// vectors, and scatter() adds columns to the rows of both automata. k counts pairs within the
/// block; pi and pj are the rows of both automata, n is the number of pairs.
#ifndef MCA_KERNEL_SPACE_H
#define MCA_KERNEL_SPACE_H

#include "kernel_blocks.h"
#include "laws/automaton_law.h"
#include "laws/pair_motion.h"
#include "rows.h"

namespace mca::MCA_ISA {
namespace {

// The traits of space: what the passes take as their argument D. Names and signatures
// are those of Plane.
struct Space {
  // Where a quantity stands in its row; rows.h.
  static constexpr RowLayout rows = spaceRows;
  // Components of a shear of PairState that exist.
  static constexpr int shears = 3;
  // Automata answer lack of room: plasticity isochoric.
  static constexpr bool keepsVolume = false;
  // Stretch of a contact by its plastic shear: 0, but with isochoric.
  // \param total  a function that gives the total shear, which is not asked for here
  template<class Total>
  static Stretch stretch(double /*left*/, const Vector & /*gamma*/, const Total & /*total*/)
  {
    return {};
  }
  // A shear or shear stress of a pair, perpendicular to its normal.
  using Shear = Vector;
  // The unit normal of a pair, from i to j.
  using Normal = Vector;

  // The step of the strain pass: dt [time], 0 at set-up, and half of it for the mean of two angular
  // velocities. Without motion both are 0, which leaves shears as they are, exactly (pairMotion()
  // of laws/pair_motion.h); normals do not depend on it.
  struct Time {
    double dt, half;
    Time(double step, bool moving) : dt(moving ? step : 0.0), half(0.5 * dt) {}
  };

  // Rows of eight values as two of four: place and first component of the velocity, the rest of the
  // velocity and the first two components of the angular velocity (rows.h, Motion); vectors of
  // eight are not on all processors.
  // \param i      number of the row
  // \param which  0: the first half, 1: the second one
  static const Row4 &half(const double *array, int i, int which)
  {
    return *rowOf<Row4>(array, 2 * i + which);
  }

  // Motion of j seen from i and the sum of both angular velocities of each pair, as columns: place
  // [length], velocity [length/time], sum of angular velocities [1/time]. Pairs past n are made up
  // of the last one.
  struct Motion {
    Column x, y, z, vx, vy, vz, wx, wy, wz;

    // Reads the rows of four pairs at a time. The signs make differences of places and velocities
    // and sums of angular velocities in the same addition; the third component of the angular
    // velocity comes from its own array.
    // \param pi,pj   Pairs::placeI and placeJ, or i and j: rows of images for pairs over a periodic
    //                face
    // \param motion  rows.motion.length values an automaton
    // \param spin    third component of the angular velocity of each automaton [1/time]
    void gather(const int *pi, const int *pj, int n, const double *motion, const double *spin)
    {
      const Row4 signs = {-1.0, -1.0, 1.0, 1.0};
      for (int k = 0; k < n; k += 4) {
        Row4 a[4], b[4];
        for (int m = 0; m < 4; m++) {
          const int i = pi[k + m], j = pj[k + m];
          a[m] = half(motion, j, 0) - half(motion, i, 0);
          b[m] = half(motion, j, 1) + signs * half(motion, i, 1);
          wz[k + m] = spin[i] + spin[j];
        }
        store(a, k, x, y, z, vx);
        store(b, k, vy, vz, wx, wy);
      }
    }

    // Velocity of j seen from i of pair k of the block [length/time].
    Vector velocity(int k) const { return {vx[k], vy[k], vz[k]}; }

    // Sum of both angular velocities of pair k [1/time].
    Vector spin(int k) const { return {wx[k], wy[k], wz[k]}; }

    // Motion of pair k in the step, for carriedShear() and shearGrowth(); also gives the distance.
    // \param time  of this pass
    // \param r     set to the distance at the end of the step [length]
    PairMotion of(int k, const Time &time, double &r) const
    {
      const Vector distance = {x[k], y[k], z[k]}, omegas = spin(k);
      // the root and the division side by side
      const double r2 = dot(distance, distance);
      r = std::sqrt(r2);
      const double invR = r * (1.0 / r2);
      return pairMotion(distance, invR, time.dt * velocity(k), time.half * omegas);
    }
  };

  // Answers of one automaton of each pair [stress], factor [-]; see Answer of contact.h. Pairs past
  // n are made up of the last one.
  struct Answers {
    Column mean, factor, centre;

    // All three values.
    // \param index     row of the automaton of each pair: Pairs::i or Pairs::j
    // \param response  rows.response.length values an automaton
    void gather(const int *index, int n, const double *response)
    {
      mca::MCA_ISA::gather(index, n, response, mean, factor, centre);
    }
    // The mean stresses alone, for the stress pass, when the other values are not known yet: a row
    // is longer than what it needs.
    void gatherMeans(const int *index, int n, const double *response)
    {
      gatherOne<rows.response.length>(index, n, response + rows.response.mean, mean);
    }
    // What the automaton of pair k of the block answers; after gather(), while gatherMeans() gives
    // the mean alone.
    Answer operator[](int k) const { return {mean[k], factor[k], centre[k]}; }
  };

  // What each pair adds to the averaged stresses of both of its automata: sigma n n + (n tau + tau
  // n)/2 [stress] in six components, xx, yy, xy, zz, xz, yz, and a sum. The weight of the
  // packing is left to averaged(), once an automaton instead of once a pair.
  struct Shares {
    Columns<2> row;

    Shares() { row.clearFrom(rows.components); }
    // The share of pair k in the tensor, stressShare() of laws/elasticity.h.
    // \param sigma  normal stress of the contact [stress], tension positive
    // \param tau    its shear stress [stress], perpendicular to n
    // \param n      its unit normal [-]
    void set(int k, double sigma, const Vector &tau, const Vector &n)
    {
      const StressTensor s = stressShare(sigma, tau, n);
      row.c[0][k] = s.xx;
      row.c[1][k] = s.yy;
      row.c[2][k] = s.xy;
      row.c[3][k] = s.zz;
      row.c[4][k] = s.xz;
      row.c[5][k] = s.yz;
    }
    // \param flowing  sigma of a contact that flows with them, else 0 [stress]: for the centre of
    //                 the return
    void setFlowing(int k, double flowing) { row.c[rows.stress.flowing][k] = flowing; }
  };

  // Forces [force] and torques [force length] of each pair on its first automaton, three components
  // each; the last two columns are unused and stay 0.
  struct Forces {
    Columns<2> row;

    Forces() { row.clearFrom(6); }
    // Force and torque of pair k of the block.
    void set(int k, const SpaceForce &f)
    {
      row.c[0][k] = f.force.x;
      row.c[1][k] = f.force.y;
      row.c[2][k] = f.force.z;
      row.c[3][k] = f.torque.x;
      row.c[4][k] = f.torque.y;
      row.c[5][k] = f.torque.z;
    }
  };

  // Averaged stress tensor of an automaton [stress] from a row of the stress pass: the sum over its
  // contacts times the packing's weight (doc/laws.md, Three dimensions). The mean is not needed.
  // \param tensor  xx, yy, xy, zz, xz, yz [stress], without the weight
  static StressTensor averaged(const AutomatonLaw &law, const double *tensor, double /*mean*/)
  {
    return weighted(tensor, law.weight);
  }

  // The centre of the return is that of meanOfFlow(); only then does flow dissipate in each
  // automaton (doc/laws.md, Three dimensions).
  static void setCentre(double *response, const double *stress, double contacts)
  {
    meanOfFlow<spaceRows>(response, stress, contacts);
  }

  // The tensor of a row of local, or of the mean of two rows [stress].
  static StressTensor localTensor(const double *tensor, double /*mean*/)
  {
    return {tensor[0], tensor[1], tensor[2], tensor[3], tensor[4], tensor[5]};
  }
};

// Space with plasticity isochoric.
struct SpaceIsochoric : Space {
  static constexpr RowLayout rows = spaceIsochoricRows;
  static constexpr bool keepsVolume = true;
  using Answers = RoomAnswers<spaceIsochoricRows>;

  static void setCentre(double *response, const double *stress, double contacts)
  {
    meanOfFlow<spaceIsochoricRows>(response, stress, contacts);
  }

  template<class Total>
  static Stretch stretch(double left, const Vector &gamma, const Total &total)
  {
    return shearStretch(left, gamma, total());
  }
};

} // namespace
} // namespace mca::MCA_ISA

#endif
