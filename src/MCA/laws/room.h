// SPDX-License-Identifier: GPL-2.0-or-later
/// \file room.h
/// How much room its present neighbours leave an automaton, and the pressure that resists when it
/// is too little; plasticity isochoric. Ours; equations: doc/laws.md, Room.
///
/// Contacts that flow shorten for good, and what lengthens in exchange breaks and is forgotten, so
/// that no sum over the past of contacts says what volume an automaton has. Here it follows from
/// the present distances alone: with a = 1 - (r/d - 1)/reach, 0 beyond it, of all neighbours,
/// linked or not, what each takes of the room, g(a) = a^3 (3 - a)/2, and the packing's w and N,
///     closeness = 2/5 w reach (sum g - N)
/// is to first order minus the volume strain of a packing. Sheared at constant volume into any
/// other lattice, a hexagonal one whose neighbours are no nearer than 0.8 d reads between -0.3 and
/// +1.0 %, fcc with none nearer than 0.9 d between -2 and +0.8 % (unittest/MCA/test_room.cpp). Of
/// the functions a^m - b a^n that stay convex down to 0.8 d none reads both better.
///
/// The pressure K (closeness - margin), never below 0, is that of the energy
///     U = sum_i V/2 K max(0, closeness_i - margin)^2,
/// a function of places alone: it can neither make nor take energy. Where contacts tell the truth,
/// as in an elastic solid, closeness stays below the margin and nothing acts.
///
/// Beside it the mean stress keeps what links that break leave. A link that is stretched, e > 0,
/// while its automata are pressed lessens their pressure; without it the pressure, and with it the
/// elastic energy, would rise as the link breaks. So its strain stays in the sum of each of its
/// automata, and is let go of where that sets energy free (doc/laws.md, Energy).
///
/// Any consistent set of units; dimensions stand in brackets. Branch-free.
#ifndef MCA_LAWS_ROOM_H
#define MCA_LAWS_ROOM_H

namespace mca {

/// From which normal strain on a neighbour takes no room [-]: at 1.4 d. Below the second neighbours
/// of all packings but beyond those of a sheared one; of the reaches up to there the longest.
constexpr double roomReach = 0.4;

/// Closeness up to which an automaton is left alone [-]. A choice: as large as the elastic volume
/// strain of steel under its hardness, a third of the volume that a layer may lose.
constexpr double roomMargin = 0.01;

/// From which share on g goes on along its tangent [-]: at 0.8 d its slope is the largest.
constexpr double roomSteepest = 1.5;

/// How stiff the pressure is at most, over K [-]: the square of what a logarithmic strain of a
/// neighbour changes of the closeness at 0.8 d, over its change in the packing.
constexpr double roomStiffness = 1.08 * 1.08;

/// Share of a neighbour at this distance [-], a: 1 in the packing, 0 from the reach on.
/// \param ratio  r/d [-]
inline double roomShare(double ratio)
{
  const double share = 1.0 - (ratio - 1.0) * (1.0 / roomReach);
  return share > 0.0 ? share : 0.0;
}

/// What it takes of the room [-], g: 1 in the packing.
/// \param share  of roomShare() [-]
inline double roomTaken(double share)
{
  const double a = share < roomSteepest ? share : roomSteepest, slope = a * a * (4.5 - 2.0 * a);
  return 0.5 * a * a * a * (3.0 - a) + slope * (share - a);
}

/// roomTaken(roomShare()) of a neighbour at a distance where isNear1() (strain.h), to the last bit:
/// a third of the work.
/// \param ratio  r/d [-]
inline double roomTakenNear1(double ratio)
{
  const double a = 1.0 - (ratio - 1.0) * (1.0 / roomReach);
  return 0.5 * a * a * a * (3.0 - a);
}

/// Pressure against lack of room [stress], >= 0.
/// \param taken        sum of roomTaken() over all neighbours [-]
/// \param bulkModulus  K [stress]
/// \param weight       w of the packing [-], D/N
/// \param dimension    D
inline double roomPressure(double taken, double bulkModulus, double weight, int dimension)
{
  const double closeness = 0.4 * roomReach * (weight * taken - dimension);
  const double above = closeness - roomMargin;
  return bulkModulus * (above > 0.0 ? above : 0.0);
}

/// Its normal stress between two automata [stress], <= 0: minus the gradient of U over the area S
/// d/r that it acts on (strain.h), with the slope of g over 5/2, that in the packing.
/// \param ratio  r/d [-], > 0
/// \param i,j    pressures of both [stress]
inline double roomStress(double ratio, double i, double j)
{
  const double share = roomShare(ratio);
  const double a = share < roomSteepest ? share : roomSteepest;
  return -(i + j) * (a * a * (0.9 - 0.4 * a)) * ratio;
}

/// Its energy per volume of an automaton [stress]: P^2/(2K).
inline double roomEnergy(double pressure, double bulkModulus)
{
  return 0.5 * pressure * pressure / bulkModulus;
}

/// Normal strain that a link which breaks leaves to the mean stress of either automaton [-].
/// \param e  its elastic normal strain [-]; pressed, it stays in touch and leaves nothing
inline double strainLeft(double e)
{
  return e > 0.0 ? e : 0.0;
}

/// What of it is kept for the next step [-]: where the mean stress pulls, it is let go of, at most
/// half of the strain that makes this stress, so that neighbours that flow in the same step cannot
/// turn the gain into a loss.
/// \param kept  at present [-], >= 0
/// \param sum   of normal strains, the kept ones included [-]; the mean stress over K w
inline double keptStrain(double kept, double sum)
{
  const double pulled = 0.5 * (sum > 0.0 ? sum : 0.0), less = kept < pulled ? kept : pulled;
  return kept - less;
}

} // namespace mca

#endif
