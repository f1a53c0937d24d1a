// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CONTACT_LINE_CONTACT_SETUP_H
#define WHEELRAIL_CONTACT_LINE_CONTACT_SETUP_H

#include "contact/elastic_bodies.h"
#include "contact/hertz.h"
#include "contact/interfacial_layer.h"
#include "contact/line/contact_interval.h"
#include "contact/line/surface.h"
#include "contact/normal_contact.h"

#include <cmath>

namespace wheelrail {

/// The nominal contact of two cylinders, or of two flat surfaces whose roughness repeats; SI units.
struct LineContactSpecification {
  double load = 0.0;   ///< N/m, > 0
  double radius = 0.0; ///< 1/R = 1/R1 + 1/R2, m, > 0; flat: infinite
  ElasticBodies bodies;
  InterfacialLayer layer;
  double domain = 4.0; ///< computed length / Hertz half-width, > 2; not for flat surfaces
  double period = 0.0; ///< m; > 0: flat surfaces whose roughness repeats
  int points = 1024;   ///< cells on the whole domain
};

/// What all operating points of a curve share: grid, surface and normal contact of one profile.
struct ContactSetup {
  /// Nominal contact. For flat surfaces it holds load, modulus, half the period as halfWidth and
  /// the mean pressure as hertzPressure.
  HertzContact hertz;
  double coupling = 0.0; ///< of pressure and traction: `couplingOf` the bodies
  double layer = 0.0;    ///< compliance of the layer, in cells per E*
  /// Shear yield stress of the layer, Pa; infinite where there is none.
  double yieldStress = std::numeric_limits<double>::infinity();
  int cells = 0;
  double cellSize = 0.0;              ///< m
  Boundary boundary = Boundary::Free; ///< Periodic: flat surfaces
  Surface surface;
  NormalContactResult normal; ///< without a pressure limit, or with the cold one's; E*, cells

  double position(int cell) const { return (cell + 0.5 - 0.5 * cells) * cellSize; } ///< m
  bool isNominal(int cell) const { return std::abs(position(cell)) <= hertz.halfWidth; }
  /// Mean over the nominal contact of a value per cell.
  double nominalMean(const Eigen::VectorXd &values) const;
  /// What friction, or the layer, carries of a traction: mu p, at most the yield stress; in E*.
  /// \param mu, pressure one value per cell; pressure in Pa
  Eigen::VectorXd bound(const Eigen::VectorXd &mu, const Eigen::VectorXd &pressure) const;
  /// What is carried where all slides, over the load; as `bound`.
  double meanFriction(const Eigen::VectorXd &mu, const Eigen::VectorXd &pressure) const;
  /// Undeformed gap in cells, the material moved on by `travel` cells (towards smaller x).
  Eigen::VectorXd gap(int travel = 0) const;
  /// Number of cells the material can travel.
  int longestTravel() const;
  /// The normal problem in units of E* and cells.
  /// \param pressureLimit  Pa; infinite: elastic
  NormalContactProblem problem(double pressureLimit, int travel = 0) const;

  double realContactLength() const; ///< m, of `normal`
  double realAreaRatio() const { return realContactLength() / (2.0 * hertz.halfWidth); }
};

/// Prepares the surface and solves the normal contact.
/// \param index of the profile, below surface.profiles()
/// \param pressureLimit Pa; infinite: elastic
/// \param travels the material will move through the contact: measured profiles are kept whole
/// \throws Error (BadInput) when profiles do not fit, or the contact reaches the domain's ends;
///         Error (NotConverged)
ContactSetup prepareContact(const LineContactSpecification &contact,
                            const SurfaceSpecification &surface, std::size_t index,
                            double pressureLimit, bool travels);

/// \throws Error (BadInput) unless every cell with pressure is away from the domain's ends
void checkInsideDomain(const Eigen::VectorXd &pressure);

} // namespace wheelrail
#endif
