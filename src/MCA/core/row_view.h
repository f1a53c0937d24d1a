// SPDX-License-Identifier: GPL-2.0-or-later
/// \file row_view.h
/// The rows of a step by quantity, for code that looks at few automata or pairs: vectors have three
/// components whatever the dimension. The kernel's loops read whole rows instead. No LAMMPS type in
/// here.
#ifndef MCA_ROW_VIEW_H
#define MCA_ROW_VIEW_H

#include "laws/automaton_law.h"
#include "laws/contact.h"
#include "rows.h"

#include <cstddef>

namespace mca {

/// Where the arrays of a step stand, and what they say of automaton i. A view: it holds until the
/// step sizes its rows anew. Numbers of rows are not checked; rows of images have a place, a
/// velocity and a spin only.
struct RowView {
  const RowLayout *layout; ///< that of all arrays below
  const double *motion;    ///< layout->motion.length values an automaton, and so on
  const double *spins;     ///< last component of each angular velocity [1/time]
  const double *response;
  const double *sums; ///< of stresses and forces

  /// Place of i [length]; z is 0 in the plane.
  Vector place(int i) const { return along(inMotion(i, layout->motion.place)); }

  /// Velocity that the forces of the step see [length/time]; z is 0 in the plane.
  Vector velocity(int i) const { return along(inMotion(i, layout->motion.velocity)); }

  /// Angular velocity [1/time]; in the plane about z.
  Vector spin(int i) const
  {
    if (isPlane())
      return {0.0, 0.0, spins[i]};
    const double *first = inMotion(i, layout->motion.spin);
    return {first[0], first[1], spins[i]};
  }

  /// Sum of the contacts' forces [force]; z is 0 in the plane.
  Vector force(int i) const
  {
    return along(row(sums, layout->force.length, i, layout->force.force));
  }

  /// Sum of their torques [force length]; in the plane about z.
  Vector torque(int i) const
  {
    const double *values = row(sums, layout->force.length, i, layout->force.torque);
    return isPlane() ? Vector{0.0, 0.0, values[0]} : vectorOf(values);
  }

  /// What it answers its contacts.
  Answer answer(int i) const
  {
    const RowLayout::Response &in = layout->response;
    const double *values = row(response, in.length, i, 0);
    return {values[in.mean], values[in.factor], values[in.centre],
            in.room < in.length ? values[in.room] : 0.0};
  }

  /// Averaged stress, elastic, before the return [stress]; in the plane with the mean stress of its
  /// answer.
  /// \param law  of its material
  StressTensor averaged(int i, const AutomatonLaw &law) const
  {
    const double *t = row(sums, layout->stress.length, i, layout->stress.tensor);
    return isPlane() ? automatonStress(t[0], t[1], t[2], answer(i).mean) : weighted(t, law.weight);
  }

  bool isPlane() const { return layout->dimension == 2; }

 private:
  static const double *row(const double *array, int length, int i, int offset)
  {
    return array + static_cast<std::size_t>(i) * static_cast<std::size_t>(length) + offset;
  }
  const double *inMotion(int i, int offset) const
  {
    return row(motion, layout->motion.length, i, offset);
  }
  Vector along(const double *values) const
  {
    return {values[0], values[1], isPlane() ? 0.0 : values[2]};
  }
};

} // namespace mca

#endif
