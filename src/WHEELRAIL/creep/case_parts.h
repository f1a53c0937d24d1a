// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_CASE_PARTS_H
#define WHEELRAIL_CREEP_CASE_PARTS_H

#include "creep/case_reader.h"

#include <string>
#include <vector>

namespace wheelrail {

/// Parts of a case file that line and patch share. All throw what `CaseReader` throws.

/// The path of a file that a case names: as it stands, or from the folder of the case file.
/// A path that is absolute, or that exists from the working folder, is taken as it is.
/// @return the path to open; whether a file is there is not checked
std::string besideCase(const std::string &path, const std::string &caseFile);

/// Group `friction`: mu for a constant law; else the law's name or file, and what scales it.
/// Strength in Pa, its temperature in K.
/// @param caseFile path of the case file, for `besideCase`
FrictionSpecification readFriction(CaseReader &reader, const std::string &caseFile);
/// Group `thermal`, or `thermal: none`, which is the model Off and reads no material.
ThermalSpecification readThermal(CaseReader &reader);

/// "name": a list, or "name.from", "name.to", "name.n" and "name.spacing". In the keyword's unit;
/// both ends of a logarithmic one have the same sign.
/// @return at least one value; of a series `n` values from the first to the last, both exact
std::vector<double> readSeries(CaseReader &reader, const std::string &name);

/// A contact in a point and all that belongs to it.
PatchSpecification readPatch(CaseReader &reader, const std::string &caseFile);

} // namespace wheelrail
#endif
