// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_WEAR_H
#define WHEELRAIL_WEAR_H

namespace wheelrail {

/// How fast a surface wears, of what a place of the contact does while a length is rolled.
struct WearLaw {
  enum class Kind {
    None,
    Archard, ///< J. F. Archard, J. Appl. Phys. 24 (1953) 981: depth = k p s/H
    TGamma   ///< `tGammaWear`
  };
  Kind kind = Kind::None;
  double coefficient = 0.0; ///< k of Archard, > 0
  double hardness = 0.0;    ///< H of Archard, of the body that wears, Pa, > 0
  double density = 0.0;     ///< of T-gamma, kg/m3, > 0

  /// Depth of wear over the length rolled, >= 0; times an area the volume over that length.
  /// \param pressure Pa
  /// \param work of friction on an area over the length rolled: traction times slip, Pa, >= 0
  /// \param slip relative to rolling, >= 0
  double depth(double pressure, double work, double slip) const;
};

/// Wear of the wheel steel R8T on the rail steel UIC60 900A, measured on twin discs without
/// lubricant: F. Braghin, R. Lewis, R. S. Dwyer-Joyce, S. Bruni, Wear 261 (2006) 1253. With the
/// wear index i = T gamma/A in N/mm2 the loss in ug/(m mm2) is
///   mild         5.3 i             i < 10.4
///   severe       55.0              10.4 <= i <= 77.2
///   catastrophic 55.0 + 61.9 (i - 77.2)
/// The 55.0 of the last line is ours and makes the function continuous.
/// \param index T gamma/A, Pa, >= 0
/// \return mass over area and length rolled, kg/m3
double tGammaWear(double index);

} // namespace wheelrail
#endif
