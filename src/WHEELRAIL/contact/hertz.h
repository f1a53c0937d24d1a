// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CONTACT_HERTZ_H
#define WHEELRAIL_CONTACT_HERTZ_H

namespace wheelrail {

/// Smooth line contact of cylinders (Hertz 1882; Johnson, Contact Mechanics, sec. 4.2). SI units,
/// or any other consistent ones.
struct HertzContact {
  double load;          ///< normal force per length, N/m
  double radius;        ///< 1/R = 1/R1 + 1/R2, m
  double modulus;       ///< E*, Pa
  double halfWidth;     ///< a = sqrt(4 N R/(pi E*)), m
  double hertzPressure; ///< p0 = 2 N/(pi a), Pa

  double pressure(double x) const; ///< p0 sqrt(1 - x^2/a^2) inside, 0 outside; Pa
  double gap(double x) const;      ///< 0 inside; m
};

/// All arguments > 0.
HertzContact hertzContact(double load, double radius, double modulus);

/// dT/dcreep at creep 0 for any roughness that is fixed in the contact frame: (pi E*/4) x real
/// contact length, N/m; from full stick on every micro-contact, whatever the friction.
/// \param modulus E*, Pa
/// \param realContactLength sum of the lengths in contact, m
double initialSlope(double modulus, double realContactLength);

} // namespace wheelrail
#endif
