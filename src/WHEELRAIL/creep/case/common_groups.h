// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_CASE_COMMON_GROUPS_H
#define WHEELRAIL_CREEP_CASE_COMMON_GROUPS_H

#include "creep/case/case_reader.h"
#include "creep/patch/patch_curve.h"
#include "creep/sweep/field_selection.h"
#include "creep/sweep/law_spread.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace wheelrail {

/// Parts of a case file that line and patch share. All throw what `CaseReader` throws.

/// The path of a file that a case names: as it stands, or from the folder of the case file.
/// A path that is absolute, or that exists from the working folder, is taken as it is.
/// \return the path to open; whether a file is there is not checked
std::string besideCase(const std::string &path, const std::string &caseFile);

/// Of the nominal contact: on fewer cells means over it say nothing.
constexpr double fewestCellsAcross = 4.0;

/// Refuses a grid on which the nominal contact has fewer cells than that.
/// \param points cells on the domain, along one direction
/// \param domain its length in half-widths (semi-axes) of the contact
void requireCellsInContact(const CaseReader &reader, int points, double domain);

/// Refuses a sweep of more points than memory holds.
/// \param points all of them; lists multiply
void requireFewPoints(const CaseReader &reader, double points);

/// What `roughness` says of generated surfaces, of a profile (FractalSurface) and of a map
/// (FractalPatch) alike. \return the seeds
template<class Fractal>
std::vector<std::uint64_t> readFractalWaves(CaseReader &reader, Fractal &fractal)
{
  for (const char *name :
       {"roughness.hurst", "roughness.wavelength_min", "roughness.wavelength_max"})
    reader.require(name);
  fractal.hurst = reader.number("roughness.hurst");
  if (reader.has("roughness.rms_slope") == reader.has("roughness.rms_height"))
    reader.fail("roughness", "one of rms_slope and rms_height is needed, not both");
  if (reader.has("roughness.rms_slope"))
    fractal.rmsSlope = reader.number("roughness.rms_slope");
  else
    fractal.rmsHeight = reader.number("roughness.rms_height");
  fractal.wavelengthMin = reader.number("roughness.wavelength_min");
  fractal.wavelengthMax = reader.number("roughness.wavelength_max");
  if (fractal.wavelengthMin > fractal.wavelengthMax)
    reader.fail("roughness.wavelength_min", "is above wavelength_max");
  std::vector<std::uint64_t> seeds;
  for (double seed : reader.numbers("roughness.seed"))
    seeds.push_back(static_cast<std::uint64_t>(seed));
  return seeds;
}

/// What `roughness` says of measured surfaces, profiles and maps alike: files, as they will be
/// opened, what is taken off and what is filtered out.
struct MeasuredSurfaces {
  std::vector<std::string> rail, wheel; ///< one may be empty; else as many of both
  int detrend = 0;     ///< place in the list of choices: none, mean, line, parabola
  double cutoff = 0.0; ///< m; 0: none
};
MeasuredSurfaces readMeasuredSurfaces(CaseReader &reader, const std::string &caseFile);

/// The law of group `friction` with the keywords that it reads. Refused are those of other laws
/// that have no default; one with a default may stand there unread.
/// \param caseFile path of the case file, for `besideCase`
LawChoice readFriction(CaseReader &reader, const std::string &caseFile);
/// The strength of group `friction`, for a law that reads it and for the limit of the pressure.
/// Where neither takes it, it is the usual one, a scale for temperatures, and a stated one stays
/// unread. Beside a law that has its own a stated one is refused.
Strength readStrength(CaseReader &reader, const LawChoice &friction, bool hardnessLimit);
/// Way over which friction falls with the slip of each cell, m; 0: one sliding speed for all.
double readMemoryLength(CaseReader &reader);
/// Group `thermal`, or `thermal: off`, which is the model Off and reads no material.
/// \param rollsOnPoint a point contact, whose bodies may have bulk temperatures
ThermalSpecification readThermal(CaseReader &reader, bool rollsOnPoint);

/// Two values. \param meaning what they are, for the message
std::array<double, 2> readPair(CaseReader &reader, const std::string &name, const char *meaning);
/// One number for both bodies, or [wheel, rail].
std::array<double, 2> readBodies(CaseReader &reader, const std::string &name);
/// The elastic constants of group `contact`.
ElasticBodies readElasticBodies(CaseReader &reader);
/// Group `layer`; none where it is not given.
InterfacialLayer readLayer(CaseReader &reader);

/// Group `uncertainty`; nothing of it is read where the law has no covariance.
SpreadSpecification readSpread(CaseReader &reader, const LawChoice &friction);

/// "name": a list, or "name.from", "name.to", "name.n" and "name.spacing". In the keyword's unit;
/// both ends of a logarithmic one have the same sign.
/// \return at least one value; of a series `n` values from the first to the last, both exact
std::vector<double> readSeries(CaseReader &reader, const std::string &name);

/// Keyword `fields`.
/// \param total number of points, which no number may exceed
FieldSelection readFields(CaseReader &reader, std::size_t total);

/// A point contact and all that belongs to it.
PatchSpecification readPatch(CaseReader &reader, const std::string &caseFile);

} // namespace wheelrail
#endif
