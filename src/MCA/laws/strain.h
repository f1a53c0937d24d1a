// SPDX-License-Identifier: GPL-2.0-or-later
/// \file strain.h
/// The normal strain of a contact, from its distance. Ours; equations: doc/laws.md, Strains of a
/// pair.
///
/// With plasticity isochoric it is logarithmic, eps = ln(r/d). Its stress then acts on S d/r, which
/// is the area of a contact that keeps its volume S d as it lengthens, and the force sigma S d/r is
/// the gradient of the same energy V sigma eps. So the stress that a body bears, its forces over
/// its present sections, is the averaged stress that yields, however far it flows: a bar that is
/// drawn to twice its length holds half the force. With the other plasticities eps = r/d - 1, whose
/// stress acts on S.
///
/// Strains are dimensionless. Branch-free.
#ifndef MCA_LAWS_STRAIN_H
#define MCA_LAWS_STRAIN_H

namespace mca {

/// Coefficients of ln(x)/s in powers of s^2, s = (x - 1)/(x + 1).
constexpr double logarithmSeries[] = {2.0,
                                      0.66666666666671169715,
                                      0.39999999998797618439,
                                      0.28571428696841921603,
                                      0.22222215484244263549,
                                      0.18182030987577636033,
                                      0.1538037521503107819,
                                      0.13388570748814651036,
                                      0.11289665821424223215,
                                      0.13177139227944024053,
                                      0.0046729780953445370433,
                                      0.24933261698540403701};

/// The first four terms.
inline double firstTerms(double q)
{
  constexpr const double(&c)[12] = logarithmSeries;
  return (c[0] + c[1] * q) + (c[2] + c[3] * q) * (q * q);
}

/// The next four, over the fourth power of q.
inline double middleTerms(double q)
{
  constexpr const double(&c)[12] = logarithmSeries;
  return (c[4] + c[5] * q) + (c[6] + c[7] * q) * (q * q);
}

/// Whether logarithmNear1() is logarithm() to the last bit: what it leaves out is a millionth of
/// the last bit of what it has.
inline bool isNear1(double x)
{
  return (x > 0.9) & (x < 1.1);
}

/// ln(x) where isNear1(), which nearly all links are: two thirds of the work.
inline double logarithmNear1(double x)
{
  const double s = (x - 1.0) / (x + 1.0), q = s * s, q2 = q * q;
  return s * (firstTerms(q) + q2 * q2 * middleTerms(q));
}

/// ln(x) = 2 artanh((x - 1)/(x + 1)) by a polynomial in the square of its argument, within 1e-16
/// for exp(-0.9) <= x <= exp(0.9), where no link is shorter than one that has collapsed and none
/// longer than breaking strains allow; monotone for any x > 0. At 1 it is exactly 0.
inline double logarithm(double x)
{
  constexpr const double(&c)[12] = logarithmSeries;
  const double s = (x - 1.0) / (x + 1.0);
  // in three parts, which a processor works on at the same time
  const double q = s * s, q2 = q * q, q4 = q2 * q2;
  const double low = firstTerms(q), middle = middleTerms(q);
  const double high = (c[8] + c[9] * q) + (c[10] + c[11] * q) * q2;
  return s * (low + q4 * (middle + q4 * high));
}

/// Total normal strain eps of a contact [-].
/// \param isochoric  plasticity isochoric
/// \param ratio      r/d [-], > 0
inline double normalStrain(bool isochoric, double ratio)
{
  return isochoric ? logarithm(ratio) : ratio - 1.0;
}

} // namespace mca

#endif
