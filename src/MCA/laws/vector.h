// SPDX-License-Identifier: GPL-2.0-or-later
/// \file vector.h
/// Vectors in space for the inner loops; values only, so that loops over them vectorise.
/// They have no dimension of their own: each use says whether components are lengths, velocities,
/// strains or stresses. Nothing is checked and nothing branches; a component that is not a number
/// stays one.
#ifndef MCA_LAWS_VECTOR_H
#define MCA_LAWS_VECTOR_H

#include <cmath>

namespace mca {

/// In space, along the axes x, y, z of the simulation box. Three doubles without padding.
struct Vector {
  /// Components in the order of the axes; an aggregate, so {x, y, z} makes one.
  double x, y, z;
};

/// Three values that follow each other.
inline Vector vectorOf(const double *values)
{
  return {values[0], values[1], values[2]};
}

/// In the plane: along x and y; z is the axis about which automata turn, positive from x to y.
struct PlaneVector {
  /// Components; {x, y} makes one.
  double x, y;
};

/// Inner product [dimension of a times that of b]. The product of two numbers, so that code that is
/// written for a shear in space also takes the plane's, which is one signed number along t.
inline double dot(double a, double b)
{
  return a * b;
}

/// Inner product of two vectors in the plane [dimension of a times that of b].
inline double dot(const PlaneVector &a, const PlaneVector &b)
{
  return a.x * b.x + a.y * b.y;
}

/// Sum by components; both have the same dimension.
inline Vector operator+(const Vector &a, const Vector &b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

/// Difference by components; of two places, a - b is the place of a seen from b.
inline Vector operator-(const Vector &a, const Vector &b)
{
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// Multiple of a vector, in the product of both dimensions. The number stands on the left; there is
/// no form with the number on the right, and none that divides: divisions are made once, outside.
inline Vector operator*(double s, const Vector &a)
{
  return {s * a.x, s * a.y, s * a.z};
}

/// Inner product. The order of its sum is fixed: x and y first, then z, so that a result is the
/// same wherever the product stands.
inline double dot(const Vector &a, const Vector &b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Vector product, right-handed: cross(x, y) = z; perpendicular to both, in the product of their
/// dimensions. 0 where both are parallel, but for rounding.
inline Vector cross(const Vector &a, const Vector &b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Euclidean length, >= 0, in the vector's dimension. Squares overflow above about 1e154 and vanish
/// below about 1e-162, far from any quantity of a run in LAMMPS's unit styles.
inline double length(const Vector &a)
{
  return std::sqrt(dot(a, a));
}

} // namespace mca

#endif
