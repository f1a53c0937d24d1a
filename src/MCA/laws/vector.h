// SPDX-License-Identifier: GPL-2.0-or-later
/// \file vector.h
/// Vectors in space for the inner loops; values only, so that loops over them vectorise.
#ifndef MCA_LAWS_VECTOR_H
#define MCA_LAWS_VECTOR_H

#include <cmath>

namespace mca {

struct Vector {
  double x, y, z;
};

/// In the plane.
struct PlaneVector {
  double x, y;
};

/// Of numbers: so that a shear may be one.
inline double dot(double a, double b)
{
  return a * b;
}

inline double dot(const PlaneVector &a, const PlaneVector &b)
{
  return a.x * b.x + a.y * b.y;
}

inline Vector operator+(const Vector &a, const Vector &b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline Vector operator-(const Vector &a, const Vector &b)
{
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline Vector operator*(double s, const Vector &a)
{
  return {s * a.x, s * a.y, s * a.z};
}

inline double dot(const Vector &a, const Vector &b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Vector cross(const Vector &a, const Vector &b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double length(const Vector &a)
{
  return std::sqrt(dot(a, a));
}

} // namespace mca

#endif
