// SPDX-License-Identifier: GPL-2.0-or-later
/// \file pair_motion.h
/// How the shear of a pair follows the motion of its two automata, in the plane and in space.
///
/// In the plane the shear is a number that grows by elasticity.h's shearIncrement(). In space: in a
/// step the material of the pair turns by the rotation Q, the mean of what both automata turn,
/// and its axis from n_old to n. The shear, a vector perpendicular to the axis, is first turned
/// with the material, then with the axis from Q n_old to n on the shortest way, and grows by the
/// angle of that last turn: the rotation of the axis that the material does not share. So it is
/// unchanged, exactly and for steps of any size, when the pair turns like a rigid body, also about
/// its own axis. Along t, n turned by +90 degrees, a motion in a plane gives the plane's number.
///
/// Exchange of both automata turns n and the shear round.
///
/// Any consistent set of units; dimensions stand in brackets. Branch-free. Differences are made of
/// the small steps, not of positions or directions, so that little motion loses no digits.
#ifndef MCA_LAWS_PAIR_MOTION_H
#define MCA_LAWS_PAIR_MOTION_H

#include "elasticity.h"
#include "vector.h"

namespace mca {

/// Motion of a pair in the plane in a step, all that the shear and the force need of it; of
/// pairMotion() below, for one pair at a time.
struct PlaneMotion {
  double r;           ///< distance at the end [length]
  PlaneVector normal; ///< n at the end [-]
  double growth;      ///< of the shear along t, n turned by +90 degrees [-]
};

/// Motion of a pair from what it is at the end of the step and its velocity in the step
/// (doc/laws.md, Strains of a pair; MCA). The way is straight, with the velocity of half a step
/// ago, which is the one that Verlet moved it by: so the former place is distance - velocity dt.
/// \param distance  place of j seen from i at the end of the step [length], not 0
/// \param velocity  of j seen from i, of the step [length/time]; the way along n less than the
///                  distance
/// \param turns     sum of both automata's angular velocities [1/time]
/// \param dt        the step [time]
/// \param moves     1, or 0: nothing moves on (set-up); all else is the same to the last bit
inline PlaneMotion pairMotion(const PlaneVector &distance, const PlaneVector &velocity,
                              double turns, double dt, double moves)
{
  const double dx = distance.x, dy = distance.y, dvx = velocity.x, dvy = velocity.y;
  const double r2 = dx * dx + dy * dy, r = std::sqrt(r2);
  const double stepN = (dvx * dx + dvy * dy) * dt, stepT = (dvy * dx - dvx * dy) * dt; // times r
  const double inverse = 1.0 / (r2 * (r2 - stepN)); // one division for both
  const double invR = r * (r2 - stepN) * inverse;
  const double turn = axisRotation(stepT * r2 * inverse);
  return {r, {dx * invR, dy * invR}, moves * shearIncrement(turn, turns * dt)};
}

/// A shear at the end of the step, before it grows [-]: a number is carried as it is, since t turns
/// with the pair.
inline double carriedShear(const PlaneMotion &, double gamma)
{
  return gamma;
}

/// Growth of the shear in the step [-], an angle: half the engineering shear strain. Elastic and
/// total shear grow alike.
inline double shearGrowth(const PlaneMotion &m)
{
  return m.growth;
}

/// Gibbs's vector tan(|phi|/2) phi/|phi| of a rotation by |phi| [rad] about phi, by its series
/// (below 1e-12 up to 0.03 rad). It needs no division by |phi|, so no rotation is a case like any
/// other.
/// \param phi  rotation vector [rad], along its axis
inline Vector gibbsVector(const Vector &phi)
{
  const double h2 = 0.25 * dot(phi, phi);
  return 0.5 * (1.0 + h2 * (1.0 / 3.0 + h2 * (2.0 / 15.0 + h2 * (17.0 / 315.0)))) * phi;
}

/// What a rotation changes of a vector, Q a - a, in the dimension of a: 2/(1 + b^2) (b x a + b x (b
/// x a)), Rodrigues' formula. Without a rotation it is exactly 0.
/// \param gibbs  Gibbs's vector b of the rotation [-]
/// \param twice  2/(1 + b^2) [-]
inline Vector turnOf(const Vector &a, const Vector &gibbs, double twice)
{
  const Vector c = cross(gibbs, a);
  return twice * (c + cross(gibbs, c));
}

/// (1 - q)^(-1/2) - 1 by its series (below 1e-12 of itself up to q = 0.06): r/r_old - 1 of a
/// distance with (r_old/r)^2 = 1 - q. The difference itself, not a root less 1, so that a small q
/// loses no digits.
/// \param q  [-], |q| well below 1; 0 gives 0 exactly
inline double lengtheningBy(double q)
{
  constexpr double c[] = {1.0 / 2.0,          3.0 / 8.0,         5.0 / 16.0,
                          35.0 / 128.0,       63.0 / 256.0,      231.0 / 1024.0,
                          429.0 / 2048.0,     6435.0 / 32768.0,  12155.0 / 65536.0,
                          46189.0 / 262144.0, 88179.0 / 524288.0};
  // in three parts, which a processor works on at the same time
  const double q2 = q * q, q4 = q2 * q2;
  const double low = (c[0] + c[1] * q) + (c[2] + c[3] * q) * q2;
  const double middle = (c[4] + c[5] * q) + (c[6] + c[7] * q) * q2;
  const double high = (c[8] + c[9] * q) + c[10] * q2;
  return q * (low + q4 * (middle + q4 * high));
}

/// Motion of a pair in space in a step, all that the shear needs of it. The place before the step
/// does not appear: everything is made of the end of the step and of what changed.
struct PairMotion {
  Vector normal; ///< n at the end [-]
  Vector gibbs;  ///< of the material's rotation [-]
  double twice;  ///< 2/(1 + gibbs^2), by its series
  Vector slip;   ///< n - Q n_old: the axis seen from the material [-]
  double slip2;  ///< slip^2
};

/// Motion of a pair in space (doc/laws.md, Three dimensions); in a plane it is the plane's law.
/// Steps are taken for small: the series hold 1e-12 up to rotations of 0.03 rad in a step.
/// \param distance  place of j seen from i at the end of the step [length], not 0
/// \param invR      1 over its length [1/length]; given, since the caller has the length, too
/// \param step      what it has changed in the step [length]; much less than the distance
/// \param phi       mean rotation of both automata in the step [rad]
/// \return with step = 0 and phi = 0 a slip of exactly 0: carriedShear() and shearGrowth() change
/// nothing
inline PairMotion pairMotion(const Vector &distance, double invR, const Vector &step,
                             const Vector &phi)
{
  PairMotion m;
  m.normal = invR * distance;
  m.gibbs = gibbsVector(phi);
  const double b2 = dot(m.gibbs, m.gibbs);
  m.twice = 2.0 * (1.0 - b2 * (1.0 - b2 * (1.0 - b2)));
  // n - n_old = (step + p (step - distance))/r, p = r/r_old - 1
  const double q = dot(step, 2.0 * distance - step) * invR * invR; // 1 - (r_old/r)^2
  const Vector swing = invR * (step + lengtheningBy(q) * (step - distance));
  const Vector old = m.normal - swing;
  m.slip = swing - turnOf(old, m.gibbs, m.twice);
  m.slip2 = dot(m.slip, m.slip);
  return m;
}

/// A shear at the end of the step, before it grows [-]: turned by Q, then from Q n_old to n on the
/// shortest way. Its length stays, and it is perpendicular to n afterwards if it was to n_old.
/// Shear stresses and the total shear turn in the same way.
/// \param gamma  the shear at the beginning of the step [-]
inline Vector carriedShear(const PairMotion &m, const Vector &gamma)
{
  const Vector turned = gamma + turnOf(gamma, m.gibbs, m.twice);
  // on the shortest way from a = Q n_old to n: g - (n.g)/(1 + a.n) (a + n), with a = n - slip
  const double share = dot(m.slip, turned) * (0.5 + m.slip2 * (0.125 + m.slip2 * 0.03125));
  return turned - share * (2.0 * m.normal - m.slip);
}

/// Growth of the shear in the step [-]: the angle between Q n_old and n, along the axis' way at its
/// end; by the series of the arcsine (below 1e-12 up to 0.03 rad). Perpendicular to n.
inline Vector shearGrowth(const PairMotion &m)
{
  const double s2 = m.slip2 * (1.0 - 0.25 * m.slip2); // squared sine of the angle
  const double angle = 1.0 + s2 * (1.0 / 6.0 + s2 * (3.0 / 40.0 + s2 * (15.0 / 336.0)));
  return angle * (m.slip - 0.5 * m.slip2 * m.normal);
}

} // namespace mca

#endif
