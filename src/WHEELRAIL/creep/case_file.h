#ifndef WHEELRAIL_CREEP_CASE_FILE_H
#define WHEELRAIL_CREEP_CASE_FILE_H

#include "contact/line/contact_temperature.h"
#include "contact/line/profile.h"

#include <cstdint>
#include <string>
#include <vector>

namespace wheelrail {

enum class RoughnessKind { None, Fractal, Measured };
enum class ThermalModel { Off, Averaged, AveragedPower, Local };
enum class RollingMode { Frozen, Moving, Static };
enum class UncertaintyMethod { Linear, Sampled };

/// Everything wr_creep computes from; SI units. Read from a YAML file by `readCase`.
struct Case {
  // contact
  double load = 0.0;   ///< N/m
  double radius = 0.0; ///< 1/R = 1/R1 + 1/R2, m
  double youngsModulus = 0.0, poissonsRatio = 0.0;
  bool hardnessLimit = false; ///< pressure stops at 3 sigma_0(Theta)
  double domain = 4.0;        ///< computed length / Hertz half-width
  double period = 0.0; ///< m; > 0: flat surfaces whose roughness repeats, `radius` is infinite
  int points = 1024;   ///< on the whole domain

  RoughnessKind roughness = RoughnessKind::None;
  FractalSurface surface;               ///< Fractal; its seed is replaced by each of `seeds`
  std::vector<std::uint64_t> seeds;     ///< Fractal: one creep curve each
  std::vector<std::string> rail, wheel; ///< Measured: files, one creep curve each; either empty
  double cutoff = 0.0;                  ///< m, 0: none
  int detrend = 1;                      ///< order of the polynomial taken off, -1: none

  // friction
  std::string law; ///< "bucher2006", "constant" or a law file
  double mu = 0.0; ///< of the constant law
  bool local = false, velocityTerm = true;
  double strength = 0.0, strengthTemperature = 0.0; ///< Eq. 10: Pa, K
  double frictionModulus = 0.0, frictionDensity = 0.0;

  ThermalModel thermal = ThermalModel::Averaged;
  ThermalMaterial material{};

  RollingMode mode = RollingMode::Frozen;
  int passes = 4;               ///< Moving: times the material goes through the contact
  double referenceLength = 1.0; ///< Moving: of the half-plane's free constant, in a

  std::vector<double> creep, speed; ///< 1, m/s; not Static
  std::vector<double> forceRatio;   ///< Static: T/(mu N)

  UncertaintyMethod uncertainty = UncertaintyMethod::Linear;
  int uncertaintySamples = 0;
  std::uint64_t uncertaintySeed = 0;

  std::size_t profiles() const; ///< number of profiles

  /// The complete configuration as a case file: reading it gives the same case.
  std::string text;
};

/// One keyword of the case file. The table of them is the one source of parsing, `--help`,
/// `--print-config` and the check against the documentation.
struct Keyword {
  enum class Kind {
    Quantity,
    QuantityList,
    Number,
    NumberList,
    Integer,
    IntegerList,
    Switch,
    Choice,
    Text,
    TextList
  };
  const char *name; ///< with dots: "contact.radius"
  Kind kind;
  const char *unit;    ///< SI unit for UDUNITS-2; "1": pure number
  const char *initial; ///< value that is used when it is not given; "": none
  double low, high;    ///< allowed range in `unit`; low is excluded where `lowOpen`
  bool lowOpen;
  const char *choices; ///< Choice: separated by '|'
  const char *help;
};

const std::vector<Keyword> &keywords();

/// Reads a case file and then "keyword=value" changes, the value in YAML as in the file.
/// @throws Error (BadInput) for the file, with line and keyword; Error (Usage) for changes
Case readCase(const std::string &path, const std::vector<std::string> &changes = {});

} // namespace wheelrail
#endif
