// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_LINE_CREEP_REPORT_H
#define WHEELRAIL_CREEP_LINE_CREEP_REPORT_H

#include "creep/line/creep_curve.h"
#include "creep/line/static_contact.h"

#include <string>

namespace wheelrail {

/// The result files of wr_creep and its words on the screen. Files are in mm, MPa, N/mm, m/s and K,
/// said once in the file. Every function takes what was asked for (a specification) and what came
/// out of it; where only the names of the profiles matter, the surface's specification.

/// creep.csv: one row a point, by profile, speed and creep. The profile, `seed` of a generated one
/// and number of a measured one, is added when there are several. Units are said in the first line.
std::string creepCsv(const SurfaceSpecification &surface, const CreepCurves &curves);

/// creep.json: the same and the band, a list for each column of each curve.
/// Numbers are those of creep.csv, in the same units.
std::string creepJson(const CreepSpecification &asked, const CreepCurves &curves);

/// creep_band.csv: T/N with its standard error and 95 % interval from the covariance of the law.
/// Only for curves with `hasBand`; rows as in creep.csv.
std::string creepBandCsv(const SurfaceSpecification &surface, const CreepCurves &curves);

/// static.csv: one row for each force on each profile.
std::string staticCsv(const SurfaceSpecification &surface, const StaticCases &cases);

/// contact.csv of the last point; contact_0003.csv where all points, or some by their numbers, were
/// asked for.
std::string contactFileName(const FieldSelection &asked, int number);
/// Along the contact, of a point that was asked for; mm and MPa. One row a cell of the domain, by
/// x; none, and a first line that says so, for a point that did not converge.
/// \param number of the point, from 1 on
std::string contactTable(const CreepCurves &curves, int number);
std::string contactTable(const StaticCases &cases, int number);

/// The points that did not converge, one line each: number, speed, creep, reason.
std::vector<std::string> failures(const CreepCurves &curves);

/// summary.json: case, law and where it was used, warnings, contacts, curves, points that did not
/// converge, time.
/// \param text the complete case file
std::string summaryJson(const CreepSpecification &asked, const std::string &text,
                        const FrictionLaw &law, const CreepCurves &curves,
                        const std::vector<std::string> &files);
/// summary.json for forces without rolling.
std::string summaryJson(const StaticSpecification &asked, const std::string &text,
                        const FrictionLaw &law, const StaticCases &cases,
                        const std::vector<std::string> &files);

/// What was computed, for the screen: profiles after every step, contacts, curves.
std::string shortReport(const CreepSpecification &asked, const CreepCurves &curves);
/// Words on the screen for forces without rolling.
std::string shortReport(const StaticSpecification &asked, const StaticCases &cases);

/// How the normal contacts were solved, for the screen.
/// Iterations, active sets and residuals, one line a contact.
std::string detailedReport(const SurfaceSpecification &surface,
                           const std::vector<ContactSetup> &contacts);

} // namespace wheelrail
#endif
