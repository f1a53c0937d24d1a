// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_HERTZ_ELLIPSE_H
#define WHEELRAIL_PATCH_HERTZ_ELLIPSE_H

namespace wheelrail {

/// Complete elliptic integrals of the parameter m = k^2, 0 <= m < 1, with D = (K - E)/m and
/// B = K - D, which keep their accuracy where m is small.
struct EllipticIntegrals {
  double K, E, D, B;
};
/// \param m the parameter, not the modulus k
EllipticIntegrals ellipticIntegrals(double m);

/// Gap A x^2 + B y^2 between two bodies that touch in a point; 1/length, both > 0.
struct GapCurvatures {
  double A, B;
};

/// Gap of a wheel on a rail whose principal curvatures lie along x and y; lengths.
/// \param wheelRolling > 0
/// \param wheelProfile, railProfile transverse radii, negative where hollow, infinite where
///        straight; the sum of their curvatures must be > 0
GapCurvatures gapOfRadii(double wheelRolling, double wheelProfile, double railProfile);

/// Smooth contact of an ellipse with semi-axes a along x and b along y (Hertz 1882; Johnson,
/// Contact Mechanics, sec. 4.2). Any consistent units.
struct HertzEllipse {
  double load;              ///< N
  double modulus;           ///< E*, of equal bodies G/(1 - nu)
  GapCurvatures curvatures; ///< 1/length
  double a, b;              ///< length
  double hertzPressure;     ///< p0 = 3 N/(2 pi a b)
  double approach;          ///< of the bodies' far points, length

  double pressure(double x, double y) const; ///< p0 sqrt(1 - x^2/a^2 - y^2/b^2) inside, 0 outside
  double gap(double x, double y) const;      ///< undeformed: A x^2 + B y^2
};

/// Semi-axes' ratio a/b that belongs to the curvatures' ratio A/B > 0; decreasing, 1 at 1.
double axesRatio(double curvatureRatio);
/// The inverse: A/B of an ellipse of a/b.
double curvatureRatio(double axesRatio);

/// All arguments > 0.
HertzEllipse hertzEllipse(double load, double modulus, const GapCurvatures &curvatures);
/// Ellipse of given semi-axes: the curvatures are those that belong to them under the load.
HertzEllipse hertzEllipseOfAxes(double load, double modulus, double a, double b);

} // namespace wheelrail
#endif
