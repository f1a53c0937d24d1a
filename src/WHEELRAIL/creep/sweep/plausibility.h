// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_SWEEP_PLAUSIBILITY_H
#define WHEELRAIL_CREEP_SWEEP_PLAUSIBILITY_H

#include "contact/contact_temperature.h"

#include <string>
#include <vector>

namespace wheelrail {

/// Lines for the user about numbers that can be computed with but hardly be meant: a wrong unit, a
/// slip of the decimal point, values that stand for "not measured". Each names the keyword, the
/// number and the limit; empty where there is nothing to say. SI units.

/// Above 1 half of the surface is steeper than 45 degrees, and no half-space.
/// \param step of the preparation, as the report calls it: "rail: on the cells"
std::string slopeDoubt(const std::string &step, double rmsSlope);

/// Above the hardness 3 sigma_0 asperities flow; where no strength is in use, E/50 is what no metal
/// bears.
/// \param peak elastic, Pa
/// \param strength sigma_0, Pa; 0: not known
/// \param youngsModulus Pa, of the softer body
std::string pressureDoubt(double peak, double strength, double youngsModulus);

/// Above 1 the bodies slide faster than they roll.
/// \param keyword of the case: "creep"
/// \param values -; the largest size counts
std::string creepDoubt(const std::string &keyword, const std::vector<double> &values);

/// Faster than any train.
/// \param keyword of the case: "speed"
/// \param values m/s; the largest counts
std::string speedDoubt(const std::string &keyword, const std::vector<double> &values);

/// So slow that heat spreads along the contact and across it as fast as the contact moves on.
/// \param keyword of the case: "speed"
/// \param values m/s; the smallest counts
/// \param halfWidth a, m, of a patch the semi-axis along the way
std::string pecletDoubt(const std::string &keyword, const std::vector<double> &values,
                        double halfWidth, const ThermalSpecification &thermal);

/// A contact larger than the body's radius is no contact of Hertz.
/// \param halfAxis  m
/// \param radius    m, > 0; infinite: flat
std::string sizeDoubt(double halfAxis, double radius);

/// No wheel rolls on more than 10 m.
/// \param radius that was given, along the way; m, > 0
std::string radiusDoubt(double radius);

/// A memory of what friction has fallen to does nothing with a law that no speed changes.
/// \param length of the memory, m; 0: none
/// \param dependsOnSpeed does the law?
std::string memoryDoubt(double length, bool dependsOnSpeed);

/// Adds a line unless it is empty or there already.
void addDoubt(std::vector<std::string> &warnings, const std::string &line);

} // namespace wheelrail
#endif
