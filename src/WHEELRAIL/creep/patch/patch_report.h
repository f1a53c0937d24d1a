// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_PATCH_REPORT_H
#define WHEELRAIL_CREEP_PATCH_REPORT_H

#include "creep/patch/patch_curve.h"
#include "creep/patch/polach_forces.h"
#include "creep/sweep/result_files.h"

#include <string>
#include <vector>

namespace wheelrail {

/// The result files of a point contact and its words on the screen. Files are in mm, N, MPa,
/// m/s, W and K, said once in the file.

/// Is it a column of mode moving that the case has? Standard errors need two passes that are
/// averaged; neither few passes nor a sequence have them.
bool isOfMoving(const Column<PatchPoint> &column, const PatchSpecification &asked);

/// creep.csv: one row a point; the line contact's columns come first. Mode static: static.csv.
/// One row for each point that converged; points are numbered in the order of the sweep, from 1 on.
std::string patchCsv(const PatchSpecification &asked, const PatchCurves &curves);

/// creep_band.csv: T/N, forces and moment, or creepages that were found, with what the covariance
/// of the law leaves undetermined of them. The line contact's columns come first.
/// \param curves with `hasBand`
std::string patchBandCsv(const PatchSpecification &asked, const PatchCurves &curves);

/// series.csv of mode moving: one row a step of every point.
/// The means in creep.csv are over these rows without the passes that are discarded.
std::string patchSeriesCsv(const PatchSpecification &asked, const PatchCurves &curves);

/// summary.json: case, law, contacts with Kalker's coefficients, warnings, time.
/// \param text the complete case file
std::string patchSummary(const PatchSpecification &asked, const std::string &text,
                         const FrictionLaw &law, const PatchCurves &curves,
                         const std::vector<std::string> &files);

/// What was computed, for the screen.
/// Hertz and cells of every contact, surfaces after each step of their preparation, largest T/N.
std::string patchShortReport(const PatchSpecification &asked, const PatchCurves &curves);
/// How the normal contacts were solved, and the products that the tangential ones took.
std::string patchDetailedReport(const PatchCurves &curves);

/// The points that did not converge, one line each: number, what was asked for, reason.
std::vector<std::string> failures(const PatchCurves &curves);

/// Names of the fields' files without their endings: "fields_0003", at the second of the chosen
/// instants "fields_0003_0002".
std::string fieldStem(const FieldPlace &place);
/// All files that the selected fields make, without the folder.
std::vector<std::string> fieldFileNames(const PatchSpecification &asked);
std::vector<std::string> fieldFileNames(const FieldPlace &place);
/// Adds them to the files of the results: one .vti and several .gsf files for each selected point,
/// converted from SI to the files' units.
/// \throws what `addFieldFiles` throws
void addFields(ResultFiles &files, const PatchSpecification &asked, const PatchCurves &curves);

/// The computed points as those of Polach's law, and the contact it needs.
/// In mm, N and m/s, with the signs of the solvers: forces against the creepages.
std::vector<PolachPoint> polachPoints(const PatchCurves &curves);
/// What Polach's law takes of the first contact: shear modulus and nominal ellipse (mm, N, MPa),
/// with Kalker's coefficients of that ellipse.
PolachContact polachContact(const PatchCurves &curves);

} // namespace wheelrail
#endif
