// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_PATCH_REPORT_H
#define WHEELRAIL_CREEP_PATCH_REPORT_H

#include "creep/patch/patch_curve.h"
#include "creep/polach.h"

#include <string>
#include <vector>

namespace wheelrail {

/// The result files of a contact in a point and its words on the screen. Files are in mm, N, MPa,
/// m/s, W and K, said once in the file.

/// creep.csv: one row a point; the line contact's columns come first. Mode static: static.csv.
std::string patchCsv(const PatchSpecification &asked, const PatchCurves &curves);

/// series.csv of mode moving: one row a step of every point.
std::string patchSeriesCsv(const PatchCurves &curves);

/// summary.json: case, law, contacts with Kalker's coefficients, warnings, time.
/// @param text the complete case file
std::string patchSummary(const PatchSpecification &asked, const std::string &text,
                         const FrictionLaw &law, const PatchCurves &curves);

/// What was computed, for the screen.
std::string patchShortReport(const PatchSpecification &asked, const PatchCurves &curves);
std::string patchDetailedReport(const PatchCurves &curves);

/// Names of the fields' files without their endings, by number of the point: "fields_0003".
std::string fieldStem(int number);
/// All files that the selected fields make, without the folder.
std::vector<std::string> fieldFileNames(const PatchSpecification &asked);
/// Writes them. @throws Error (Io)
void writeFields(const std::string &folder, const PatchSpecification &asked,
                 const PatchCurves &curves);

/// The computed points as those of Polach's law, and the contact it needs.
std::vector<PolachPoint> polachPoints(const PatchCurves &curves);
PolachContact polachContact(const PatchCurves &curves);

} // namespace wheelrail
#endif
