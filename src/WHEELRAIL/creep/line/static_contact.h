// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_LINE_STATIC_CONTACT_H
#define WHEELRAIL_CREEP_LINE_STATIC_CONTACT_H

#include "creep/line/creep_point.h"
#include "creep/sweep/field_selection.h"
#include "creep/sweep/sweep.h"
#include "law/law_choice.h"

#include <map>
#include <string>
#include <vector>

namespace wheelrail {

/// Dimensionless: the half-plane's unit of stress is E*.
struct StaticTraction {
  Eigen::VectorXd traction;           ///< per cell, in E*
  std::vector<ContactInterval> stick; ///< where nothing slips
};

/// A tangential force below full sliding, applied once without rolling (Cattaneo 1938, Mindlin
/// 1949), friction coefficient constant. By the theorem of Ciavarella and Jaeger the traction is mu
/// [p(N) - p(N - T/mu)], for any elastic profile, and what is in contact under N - T/mu sticks: one
/// more normal contact.
/// \param normal solution of `problem`, elastic where forceRatio > 0
/// \param forceRatio T/(mu N) in [0, 1)
/// \param mu >= 0, the same everywhere
/// \return traction positive along the force; its sum is forceRatio mu N up to the tolerance
/// \throws Error (BadInput) for another force ratio, and what `solveNormalContact` throws
StaticTraction staticTraction(HalfPlane &halfPlane, const NormalContactProblem &problem,
                              const NormalContactResult &normal, double mu, double forceRatio);

/// Tangential forces on profiles, without rolling; SI units.
struct StaticSpecification {
  LineContactSpecification contact;
  SurfaceSpecification surface;
  LawChoice friction;             ///< not cellwise
  CreepPhysics physics;           ///< no temperature; no hardness limit where a
                                  ///< force ratio is above 0
  std::vector<double> forceRatio; ///< T/(mu N), in [0, 1), at least one
  FieldSelection fields;          ///< points whose fields along the contact are kept
};

/// One force on one profile; SI units.
/// Lengths are along x; a rough contact may stick in many places.
struct StaticPoint {
  std::uint64_t profile = 0;
  double forceRatio = 0.0; ///< T/(mu N)
  /// mu times the force ratio.
  double tractionRatio = 0.0; ///< T/N
  double traction = 0.0;      ///< T, N/m
  double mu = 0.0;
  double stickLength = 0.0; ///< m, of all stick zones
  double stickCentre = 0.0; ///< m, mean place of what sticks; 0: middle of the computed length

  bool converged() const { return true; } ///< or `solveStaticCases` has thrown
};

/// All that such a point has, in the order of static.csv: the table from which static.csv and the
/// summary's list of forces follow.
/// \return the same table in every call
const std::vector<Column<StaticPoint>> &staticColumns();

/// Complete, or `solveStaticCases` has thrown.
struct StaticCases {
  std::vector<ContactSetup> contacts; ///< one per profile
  std::vector<StaticPoint> points;    ///< by profile, then force
  /// Along the contact, by number of the point, from 1 on: those that were asked for.
  std::map<int, ContactFields> fields;
  LawUse use;                        ///< where the law was asked for mu
  std::vector<std::string> warnings; ///< one line each
  double seconds = 0.0;
};

/// All forces on all profiles, free or periodic.
/// \throws Error as the normal contact does, Error (Interrupted)
/// \param law gives mu at sliding speed 0 and no temperature rise
/// \param options threads, progress, interruption; there is no journal here
StaticCases solveStaticCases(const StaticSpecification &specification, const FrictionLaw &law,
                             const SweepOptions &options = {});

} // namespace wheelrail
#endif
