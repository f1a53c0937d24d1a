// SPDX-License-Identifier: GPL-2.0-or-later
/// \file rows.h
/// Rows of the per-automaton arrays: how long they are and where in them each quantity stands. The
/// only place that knows; whoever reads a row takes its offsets from here.
///
/// Each array is plain doubles, one row an automaton, 64-byte aligned, so that an automaton costs
/// at most one cache line. Dimensions stand in brackets; any consistent set of units.
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
  } strain;
  /// Sums over the contacts of an automaton, by the stress pass.
  struct Stress {
    int length;
    int tensor;  ///< `components` values: xx, yy, xy, in space zz, xz, yz, too [stress]; in the
                 ///< plane averaged, in space without the packing's weight
    int squares; ///< e^2 + gamma^2 [-]
    int flowing; ///< the normal stresses of the contacts that flow with it [stress]; in the plane
                 ///< only with j2, else it equals length
  } stress;
  /// What an automaton answers its contacts.
  struct Response {
    int length;
    int mean;    ///< mean stress [stress]
    int factor;  ///< M of the radial return [-]
    int centre;  ///< what normal stresses of its contacts return to [stress]: in the plane the
                 ///< mean stress itself, in space and with j2 the mean over those that flow
    int answers; ///< so many values from `factor` on are new after a return
  } response;
  /// Sums over the contacts of an automaton, by the force pass.
  struct Force {
    int length;
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

/// In the plane: rows of 2 or 4 values; - is not used, x and y are the components of vectors, zz of
/// the tensors follows from the mean.
///
///     motion     x  y  vx  vy             and one array of spins
///     strain     sum  flowing
///     stress     xx  yy  xy  squares
///     response   mean  factor             the centre is the mean
///     force      fx  fy  torque  -
///     local      xx  yy  xy  work
constexpr RowLayout planeRows = {
    {4, 0, 2, 4}, {2, 0, 1}, {4, 0, 3, 4}, {2, 0, 1, 0, 1}, {4, 0, 2}, {4, 0, 3}, 2, 3};
/// In the plane with plasticity j2: as in space the centre is of its own.
///
///     stress     xx  yy  xy  squares  flowing  -  -  -
///     response   mean  factor  centre  -
constexpr RowLayout planeJ2Rows = {
    {4, 0, 2, 4}, {2, 0, 1}, {8, 0, 3, 4}, {4, 0, 1, 2, 2}, {4, 0, 2}, {4, 0, 3}, 2, 3};
/// In space: rows of 2, 4 or 8 values; some have values that are not used, for whole vectors.
///
///     motion     x  y  z  vx  vy  vz  wx  wy      and one array of wz
///     strain     sum  flowing
///     stress     xx  yy  xy  zz  xz  yz  squares  flowing
///     response   mean  factor  centre  -
///     force      fx  fy  fz  tx  ty  tz  -  -
///     local      xx  yy  xy  zz  xz  yz  work  -
constexpr RowLayout spaceRows = {
    {8, 0, 3, 6}, {2, 0, 1}, {8, 0, 6, 7}, {4, 0, 1, 2, 2}, {8, 0, 3}, {8, 0, 6}, 3, 6};

} // namespace mca

#endif
