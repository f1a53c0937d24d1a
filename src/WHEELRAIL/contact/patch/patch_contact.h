// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_CONTACT_H
#define WHEELRAIL_PATCH_CONTACT_H

#include "contact/elastic_bodies.h"
#include "contact/interfacial_layer.h"
#include "contact/normal_contact.h"
#include "contact/patch/elasticity/cell_influence.h"
#include "contact/patch/elasticity/grid.h"
#include "contact/patch/elasticity/hertz_ellipse.h"
#include "contact/patch/solvers/edge_compliance.h"
#include "contact/patch/surfaces/rough_patch.h"

#include <array>
#include <limits>
#include <optional>
#include <vector>

namespace wheelrail {

/// The half-spaces' pair whose displacement differences are those of both bodies together:
/// 2/G = 1/G1 + 1/G2, 2 nu/G = nu1/G1 + nu2/G2, and what couples the normal and the tangential
/// problem, K = (G/4) [(1 - 2 nu1)/G1 - (1 - 2 nu2)/G2] (Kalker 1990, sec. 1.7).
/// \return Pa and -; equal bodies give their own G and nu and K = 0, as do some unlike ones. A K
///         that is rounding only is 0
ElasticPair combinedPair(const ElasticBody &wheel, const ElasticBody &rail);

/// The nominal point contact, and its box of cells; SI units.
struct PatchContactSpecification {
  std::vector<double> load; ///< N, > 0, at least one
  /// Gap A x^2 + B y^2, 1/m; absent: `semiAxes` of the one load decide.
  std::optional<GapCurvatures> curvatures;
  std::array<double, 2> semiAxes{}; ///< a along x, b along y, m
  ElasticBodies bodies;
  double domain = 0.0; ///< box / semi-axes: +- domain/2 a and +- domain/2 b, > 2
  /// In place of `domain`: the box's lengths along x and y, m.
  std::optional<std::array<double, 2>> box;
  std::array<double, 2> centre{}; ///< of the box, m
  /// In place of the loads, which are then Hertz's under it: one for each of them, m. Empty: none.
  std::vector<double> approach;
  /// Factor on the law's mu across the contact: at places (m, increasing), linear between them, the
  /// outermost beyond. Empty: 1.
  std::vector<double> acrossY, acrossFactor;
  int nx = 0, ny = 0;     ///< cells of the box
  double spinPoint = 0.5; ///< `TangentialProblem::spinPoint`
  InterfacialLayer layer;
  bool edgesInside = false; ///< leading edges inside their cells: see `edgeCompliance`

  /// \param normalForce N, > 0
  /// \return the smooth contact under it; SI units
  HertzEllipse hertz(double normalForce) const;
};

/// What all operating points with one load on one pair of surfaces share; SI units.
struct PatchContact {
  HertzEllipse hertz;
  ElasticPair pair;
  PatchGrid grid;
  double load = 0.0; ///< N
  RoughPatch surface;
  NormalContactResult normal;     ///< at the start; Pa and m
  std::optional<double> approach; ///< m; given: `load` is what it makes
  Eigen::VectorXd muFactor;       ///< per cell, on the law's mu; empty: 1
  bool edgesInside = false;       ///< of the specification
  /// Yield stress of the layer, Pa; infinite where there is none.
  double yieldStress = std::numeric_limits<double>::infinity();

  /// The law's mu times the factor of each cell.
  Eigen::VectorXd across(Eigen::VectorXd mu) const;
  /// Undeformed gap of each cell, m: the smooth gap less both bodies' heights.
  /// \param wheel, rail  how far each of the surfaces has travelled
  Eigen::VectorXd gap(const Travel &wheel = {}, const Travel &rail = {}) const;
  /// \param pressureLimit Pa; infinite: elastic
  /// \param normalForce N; not read where the approach is given
  NormalContactProblem problem(double pressureLimit, double normalForce, const Travel &wheel = {},
                               const Travel &rail = {}) const;
  /// What friction, or the layer, carries of a traction: mu p, at most the yield stress; Pa.
  Eigen::VectorXd bound(const Eigen::VectorXd &mu, const Eigen::VectorXd &pressure) const;
  /// What is carried where all slides, over the load; as `bound`.
  double meanFriction(const Eigen::VectorXd &mu, const Eigen::VectorXd &pressure) const;
  /// Compliance of the leading edges under a pressure; empty where cells count as a whole.
  EdgeCompliance edge(const Eigen::VectorXd &pressure, const Eigen::VectorXd &gap) const;
  /// \param cell index in the grid; its centre decides
  bool isNominal(int cell) const; ///< inside the smooth contact's ellipse?
  /// Mean over the nominal contact of a value per cell.
  /// The cells count whose centres lie inside the ellipse.
  double nominalMean(const Eigen::VectorXd &values) const;
  double nominalArea() const; ///< pi ab, m^2
  /// The load that is meant; what a pressure carries where the approach is given, N.
  double carried(double normalForce, const Eigen::VectorXd &pressure) const;
  /// All cells with pressure, each with its whole area.
  double realArea(const Eigen::VectorXd &pressure) const; ///< m^2
};

/// Grid, surface and normal contact.
/// \param load one of the specification's, N
/// \param index of the surface, below roughness.surfaces()
/// \param pressureLimit Pa; infinite: elastic
/// \param travel how far the material will move through the contact, m; 0 where it stands
/// \throws Error (BadInput) for surfaces that cannot be read or do not fit, for a box that the
///         contact reaches the border of; Error (NotConverged)
PatchContact preparePatch(const PatchContactSpecification &contact,
                          const RoughPatchSpecification &roughness, double load, std::size_t index,
                          double pressureLimit, double travel);

/// \throws Error (BadInput) when a cell at the border of the box is in contact
/// The message names the border: leading, trailing or lateral.
void checkInsideBox(const PatchGrid &grid, const Eigen::VectorXd &pressure);

} // namespace wheelrail
#endif
