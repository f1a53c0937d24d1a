// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_COUPLING_H
#define WHEELRAIL_PATCH_COUPLING_H

#include "contact/normal_contact.h"
#include "contact/patch/elasticity/cell_influence.h"
#include "contact/patch/elasticity/plane_transform.h"
#include "contact/patch/solvers/tangential.h"

#include <optional>

namespace wheelrail {

/// How the pressure and the tangential traction of unlike bodies influence each other (Kalker
/// 1990, sec. 1.7; Johnson, Contact Mechanics, sec. 5.4). Under a pressure both surfaces move
/// towards the load, the softer one further, and a traction presses one body in and lifts the
/// other, by influences K/(pi G) x/r^2 that are odd in the distance. With K = 0 nothing is
/// computed and fields are empty.
///
/// Signs: the traction acts on the wheel, whose material is the first of `combinedPair`'s;
/// tangential displacements are the wheel's less the rail's, normal ones open the gap. One object
/// per thread.
class PatchCoupling {
 public:
  /// \param pair units as everywhere: length of the grid, tractions as G
  PatchCoupling(const CellGrid &grid, const ElasticPair &pair);

  /// Do the bodies couple?
  bool any() const { return strength_ != 0.0; }
  /// Tangential displacement per cell that a pressure causes; empty where nothing couples.
  TangentialField tangential(const Eigen::VectorXd &pressure);
  /// Opening of the gap per cell by a traction; empty where nothing couples.
  Eigen::VectorXd normal(const TangentialField &traction);

  /// Pressure and traction by turns (Panagiotopoulos 1975) until the pressure settles; one turn
  /// where nothing couples.
  /// \param pressure of the last normal contact; read anew after each `press`
  /// \param slide solves the tangential problem with the displacement `tangential(pressure)`
  ///        imposed
  /// \param press solves the normal problem, its gap opened by its argument
  /// \return the last tangential solution, under a pressure that is off by `tolerance`
  /// \throws Error (NotConverged)
  template<class Slide, class Press>
  TangentialResult settle(const Eigen::VectorXd &pressure, const Slide &slide, const Press &press)
  {
    for (int turn = 1;; ++turn) {
      TangentialResult result = slide();
      if (!any())
        return result;
      // NOLINTNEXTLINE(performance-unnecessary-copy-initialization): press() changes `pressure`
      const Eigen::VectorXd before = pressure;
      press(normal(result.traction));
      if (settled(before, pressure))
        return result;
      checkTurns(turn);
    }
  }

  /// Has a pressure changed by less than `tolerance`, relative to itself?
  static bool settled(const Eigen::VectorXd &before, const Eigen::VectorXd &after);
  /// \throws Error (NotConverged) when there were too many turns
  static void checkTurns(int turns);

  static constexpr double tolerance = 1e-5; ///< of the pressure

 private:
  void fillSpectra();

  CellGrid grid_;
  double strength_; ///< K/(pi G)
  std::optional<PlaneTransform> transform_;
  Quarter x_, y_; ///< spectra of `CouplingIntegrals`, times i
};

} // namespace wheelrail
#endif
