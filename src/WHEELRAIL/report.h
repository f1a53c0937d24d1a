#ifndef WHEELRAIL_REPORT_H
#define WHEELRAIL_REPORT_H

#include "creep_curve.h"

#include <string>

namespace wheelrail {

/// creep.csv: one row a point, by profile, speed and creep. `seed` is added when there are several
/// profiles. Units are said in the first line: m/s, N/mm, K.
std::string creepCsv(const Case &input, const CreepCurves &curves);

/// creep_band.csv: T/N with its standard error and 95 % interval from the law's covariance.
std::string creepBandCsv(const CreepCurves &curves);

/// contact.csv: along the contact, of the last point; mm and MPa.
std::string contactCsv(const CreepCurves &curves);

/// summary.json: case, law, contacts, curves, time.
std::string summaryJson(const Case &input, const FrictionLaw &law, const CreepCurves &curves);

/// What was computed, for the screen.
std::string shortReport(const Case &input, const CreepCurves &curves);

/// Statistics of the profiles and of the normal contact, for the screen.
std::string detailedReport(const CreepCurves &curves);

} // namespace wheelrail
#endif
