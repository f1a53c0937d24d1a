// SPDX-License-Identifier: GPL-2.0-or-later
/// \file kernel_plane.h
/// What the kernel does otherwise in the plane than in space: rows gathered and scattered, the
/// shear a number. kernel_space.h is its sibling, with the same names. For the kernel's source
/// only.
#ifndef MCA_KERNEL_PLANE_H
#define MCA_KERNEL_PLANE_H

#include "kernel_blocks.h"
#include "laws/pair_motion.h"

namespace mca::MCA_ISA {
namespace {

struct Plane {
  static constexpr RowLayout rows = planeRows;
  static constexpr int shears = 1;
  using Shear = double;
  using Normal = PlaneVector;

  // The step of the strain pass.
  struct Time {
    double dt, moves;
    Time(double step, bool moving) : dt(step), moves(moving ? 1.0 : 0.0) {}
  };

  // Motion of j seen from i and the sum of both spins of each pair, as columns. Works on whole
  // fours: Pairs are padded.
  struct Motion {
    Column x, y, vx, vy, spins;

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

    PlaneVector velocity(int k) const { return {vx[k], vy[k]}; }

    // Also gives the distance.
    PlaneMotion of(int k, const Time &time, double &r) const
    {
      const PlaneMotion moved =
          pairMotion({x[k], y[k]}, velocity(k), spins[k], time.dt, time.moves);
      r = moved.r;
      return moved;
    }
  };

  // Answers of one automaton of each pair.
  struct Answers {
    Column mean, factor;

    void gather(const int *index, int n, const double *response)
    {
      mca::MCA_ISA::gather(index, n, response, mean, factor);
    }
    void gatherMeans(const int *index, int n, const double *response)
    {
      gather(index, n, response);
    }
    Answer operator[](int k) const { return {mean[k], factor[k], mean[k]}; }
  };

  // What each pair adds to the averaged stresses of both of its automata.
  struct Shares {
    Column xx, yy, xy, squares;

    void set(int k, double sigma, double tau, const PlaneVector &n)
    {
      const StressTensor s = stressShare(sigma, tau, n.x, n.y);
      xx[k] = s.xx;
      yy[k] = s.yy;
      xy[k] = s.xy;
    }
    void setSums(int k, double e2, double gamma2, double /*bulkSigma*/)
    {
      squares[k] = e2 + gamma2;
    }
    void scatter(const int *pi, const int *pj, int n, double *sums) const
    {
      const Row4 same = {1.0, 1.0, 1.0, 1.0};
      mca::MCA_ISA::scatter(pi, pj, n, xx, yy, xy, squares, same, sums);
    }
    // Without the sums.
    void scatterTensors(const int *pi, const int *pj, int n, double *sums) const
    {
      const Row4 same = {1.0, 1.0, 1.0, 1.0};
      mca::MCA_ISA::scatter(pi, pj, n, xx, yy, xy, xy, same, sums);
    }
  };

  // Forces and torques of each pair.
  struct Forces {
    Column x, y, torque;

    void set(int k, const PlaneForce &f)
    {
      x[k] = f.x;
      y[k] = f.y;
      torque[k] = f.torque;
    }
    void scatter(const int *pi, const int *pj, int n, double *sums) const
    {
      const Row4 turned = {-1.0, -1.0, 1.0, 1.0};
      mca::MCA_ISA::scatter(pi, pj, n, x, y, torque, torque, turned, sums);
    }
  };

  // Averaged stress tensor of an automaton.
  static StressTensor averaged(const AutomatonLaw &, const double *tensor, double mean)
  {
    return automatonStress(tensor[0], tensor[1], tensor[2], mean);
  }

  // In the plane the centre of the return is the mean stress itself.
  static void setCentre(double * /*response*/, const double * /*stress*/, double /*bulks*/) {}

  // The tensor of a row of local.
  static StressTensor localTensor(const double *tensor, double mean)
  {
    return automatonStress(tensor[0], tensor[1], tensor[2], mean);
  }
};

} // namespace
} // namespace mca::MCA_ISA

#endif
