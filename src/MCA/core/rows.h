// SPDX-License-Identifier: GPL-2.0-or-later
/// \file rows.h
/// Rows of the per-automaton arrays: how long they are and where in them each quantity stands. The
/// only place that knows; whoever reads a row takes its offsets from here.
///
/// Each array is plain doubles, one row an automaton, 64-byte aligned, so that an automaton costs
/// at most one cache line, in space two. Dimensions stand in brackets; any consistent set of units.
#ifndef MCA_ROWS_H
#define MCA_ROWS_H

namespace mca {

/// Lengths and offsets in one dimension, all counted in doubles. A length is the stride from one
/// automaton to the next; values of a row that no offset names are padding and may hold anything.
struct RowLayout {
  /// What the strain pass sees of an automaton.
  struct Motion {
    int length;
    int place;    ///< `dimension` values [length]
    int velocity; ///< `dimension` values [length/time]
    int spin;     ///< in space the first two components of the angular velocity [1/time]; the last
                  ///< one has an array of its own. In the plane none, and it equals length
  } motion;
  /// Sums over the contacts of an automaton, by the strain pass.
  struct Strain {
    int length;
    int sum;     ///< of the elastic normal strains [-]
    int flowing; ///< number of contacts that flow with it
    int room;    ///< squares of the shares of its neighbours in its room [-]; only with isochoric,
                 ///< else it equals length
  } strain;
  /// Sums over the contacts of an automaton, by the stress pass. Stresses and forces share a row,
  /// since the stress pass adds to both at once.
  struct Stress {
    int length;  ///< of the whole row
    int tensor;  ///< `components` values: xx, yy, xy, in space zz, xz, yz, too [stress]; in the
                 ///< plane averaged, in space without the packing's weight
    int flowing; ///< the normal stresses of the contacts that flow with it [stress]; in the plane
                 ///< only with isochoric, else it equals length
  } stress;
  /// What an automaton answers its contacts.
  struct Response {
    int length;
    int mean;    ///< mean stress [stress]
    int room;    ///< pressure against lack of room [stress]; only with isochoric, else it equals
                 ///< length
    int means;   ///< so many values from `mean` on are known before the stress pass
    int factor;  ///< M of the radial return [-]
    int centre;  ///< what normal stresses of its contacts return to [stress]: in the plane the
                 ///< mean stress itself, in space and with isochoric the mean over those that flow
    int answers; ///< so many values from `factor` on are new after a return
  } response;
  /// What returns take from Stress, with the same offsets, by the return pass.
  struct Taken {
    int length;
  } taken;
  /// Sums over the contacts of an automaton: elastic forces by the stress pass, to which the force
  /// pass adds all else.
  struct Force {
    int length; ///< that of Stress
    int force;  ///< `dimension` values [force]
    int torque; ///< one value in the plane, three in space [force length]
  } force;
  /// What an automaton shows to criteria of local stress and of plastic work.
  struct Local {
    int length;
    int tensor; ///< `components` values: averaged stress tensor after the return [stress]
    int work;   ///< plastic work per volume of the step [stress]
  } local;
  int dimension;
  int components; ///< of a symmetric stress tensor in a row: 3 or 6
};

/// In the plane: rows of 2, 4 or 8 values; - is not used, x and y are the components of vectors, zz
/// of the tensors follows from the mean.
///
///     motion     x  y  vx  vy             and one array of spins
///     strain     sum  flowing
///     stress     xx  yy  xy  -  fx  fy  torque  -
///     response   mean  factor             the centre is the mean
///     local      xx  yy  xy  work
constexpr RowLayout planeRows = [] {
  RowLayout r{};
  r.motion.length = 4, r.motion.place = 0, r.motion.velocity = 2, r.motion.spin = 4;
  r.strain.length = 2, r.strain.sum = 0, r.strain.flowing = 1, r.strain.room = 2;
  r.stress.length = 8, r.stress.tensor = 0, r.stress.flowing = 8;
  r.taken.length = 4;
  r.response.length = 2, r.response.mean = 0, r.response.room = 2, r.response.means = 1;
  r.response.factor = 1, r.response.centre = 0, r.response.answers = 1;
  r.force.length = 8, r.force.force = 4, r.force.torque = 6;
  r.local.length = 4, r.local.tensor = 0, r.local.work = 3;
  r.dimension = 2, r.components = 3;
  return r;
}();
/// Rows with plasticity isochoric, of any dimension: strains have the room that neighbours
/// take, and answers the pressure against its lack and a centre of their own.
///
///     strain     sum  flowing  room  -
///     response   mean  room  factor  centre
constexpr RowLayout withRoom(RowLayout r)
{
  r.strain.length = 4, r.strain.room = 2;
  r.response.length = 4, r.response.mean = 0, r.response.room = 1, r.response.means = 2;
  r.response.factor = 2, r.response.centre = 3, r.response.answers = 2;
  return r;
}
/// In the plane with plasticity isochoric, besides:
///
///     stress     xx  yy  xy  flowing  fx  fy  torque  -
constexpr RowLayout planeIsochoricRows = [] {
  RowLayout r = withRoom(planeRows);
  r.stress.flowing = 3;
  return r;
}();
/// In space: rows of 2, 4, 8 or 16 values; some have values that are not used, for whole vectors.
///
///     motion     x  y  z  vx  vy  vz  wx  wy      and one array of wz
///     strain     sum  flowing
///     stress     xx  yy  xy  zz  xz  yz  flowing  -  fx  fy  fz  tx  ty  tz  -  -
///     response   mean  factor  centre  -
///     local      xx  yy  xy  zz  xz  yz  work  -
constexpr RowLayout spaceRows = [] {
  RowLayout r{};
  r.motion.length = 8, r.motion.place = 0, r.motion.velocity = 3, r.motion.spin = 6;
  r.strain.length = 2, r.strain.sum = 0, r.strain.flowing = 1, r.strain.room = 2;
  r.stress.length = 16, r.stress.tensor = 0, r.stress.flowing = 6;
  r.taken.length = 8;
  r.response.length = 4, r.response.mean = 0, r.response.room = 4, r.response.means = 1;
  r.response.factor = 1, r.response.centre = 2, r.response.answers = 2;
  r.force.length = 16, r.force.force = 8, r.force.torque = 11;
  r.local.length = 8, r.local.tensor = 0, r.local.work = 6;
  r.dimension = 3, r.components = 6;
  return r;
}();
/// In space with plasticity isochoric.
constexpr RowLayout spaceIsochoricRows = withRoom(spaceRows);

} // namespace mca

#endif
