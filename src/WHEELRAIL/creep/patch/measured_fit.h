// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_MEASURED_FIT_H
#define WHEELRAIL_CREEP_MEASURED_FIT_H

#include "creep/patch/measured_curve.h"
#include "creep/patch/patch_curve.h"
#include "creep/patch/polach_forces.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace wheelrail {

/// A parameter with its 95 % interval.
struct MeasuredParameter {
  std::string name, unit;
  double value = 0.0;
  double low = 0.0, high = 0.0; ///< open ends are the bound, or infinite
  bool lowOpen = false, highOpen = false;
};

/// One way to describe a measured curve.
struct MeasuredModel {
  std::vector<MeasuredParameter> parameters;
  std::vector<double> tractionRatio; ///< T/N at the points of the curve
  double rms = 0.0;                  ///< of T/N less the measured one, over the degrees of freedom
};

/// What a measured curve says of a contact: beside what was predicted without it, two fits.
struct MeasuredFit {
  std::vector<double> predicted; ///< T/N of the case as it is, nothing fitted
  double predictedRms = 0.0;     ///< of T/N less the measured one
  /// Polach's form on the smooth ellipse: mu0, A, B, kA, kS; intervals by the profile of the sum of
  /// squares.
  MeasuredModel polach;
  /// The contact of the case with a layer and friction that falls with the sliding speed: mu0, A, B
  /// and the layer's compliance; intervals likewise.
  MeasuredModel layer;
  /// The initial slope that the layer leaves of that without one.
  double slopeShare = 1.0;
  bool uncoupled = false; ///< the bodies are unlike, and the fit of the layer leaves that out
};

/// \param contact, law the case as it is; its layer and the coupling of its bodies are not used by
///        the fit of a layer
/// \param goOn asked at each point that is rolled; false to stop
/// \throws Error (NotConverged) where the points do not determine the parameters; Error
///         (Interrupted) when stopped
MeasuredFit fitMeasured(const std::vector<MeasuredTraction> &curve, const CreepPhysics &physics,
                        const PatchContact &contact, double spinPoint, const FrictionLaw &law,
                        const PolachContact &ellipse, const std::function<bool()> &goOn);

/// The same for the first contact of a case that is solved.
MeasuredFit fitMeasured(const std::vector<MeasuredTraction> &curve, const PatchSpecification &asked,
                        const PatchCurves &curves, const FrictionLaw &law,
                        const std::function<bool()> &goOn);

/// A file without a column of speed was measured at that of the case, where there is one.
std::vector<MeasuredTraction> readMeasuredCurve(const std::string &path,
                                                const PatchSpecification &asked);

/// measured_fit.json and measured_fit.csv.
std::string measuredJson(const MeasuredFit &fit, const std::string &path);
std::string measuredCsv(const MeasuredFit &fit, const std::vector<MeasuredTraction> &curve);

} // namespace wheelrail
#endif
