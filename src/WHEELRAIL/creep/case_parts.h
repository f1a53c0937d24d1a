// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_CASE_PARTS_H
#define WHEELRAIL_CREEP_CASE_PARTS_H

#include "creep/case_reader.h"

#include <string>
#include <vector>

namespace wheelrail {

/// Parts of a case file that line and patch share. All throw what `CaseReader` throws.

/// The path of a file that a case names: as it stands, or from the folder of the case file.
std::string besideCase(const std::string &path, const std::string &caseFile);

FrictionSpecification readFriction(CaseReader &reader, const std::string &caseFile);
ThermalSpecification readThermal(CaseReader &reader);

/// "name": a list, or "name.from", "name.to", "name.n" and "name.spacing". In the keyword's unit;
/// both ends of a logarithmic one have the same sign.
std::vector<double> readSeries(CaseReader &reader, const std::string &name);

/// A contact in a point and all that belongs to it.
PatchSpecification readPatch(CaseReader &reader, const std::string &caseFile);

} // namespace wheelrail
#endif
