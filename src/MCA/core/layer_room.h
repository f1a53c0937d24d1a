// SPDX-License-Identifier: GPL-2.0-or-later
/// \file layer_room.h
/// How much room the automata between a held and a driven layer have, and how many have left. From
/// the places of this moment alone. No LAMMPS type in here.
#ifndef MCA_CORE_LAYER_ROOM_H
#define MCA_CORE_LAYER_ROOM_H

#include <algorithm>
#include <cmath>

namespace mca {

/// What an automaton of a friction run belongs to.
enum class Part { Free, Held, Driven };

/// Heights y between which the held and the driven automata lie [length]; the held ones are below.
struct RigidLayers {
  double heldLow = HUGE_VAL, heldHigh = -HUGE_VAL;
  double drivenLow = HUGE_VAL, drivenHigh = -HUGE_VAL;

  /// An automaton of one of them, or a free one, which changes nothing.
  void add(Part part, double y)
  {
    double &low = part == Part::Held ? heldLow : drivenLow;
    double &high = part == Part::Held ? heldHigh : drivenHigh;
    if (part == Part::Free)
      return;
    low = std::min(low, y);
    high = std::max(high, y);
  }
  /// Whether there are both, one above the other.
  bool areApart() const { return isHeld() && drivenLow <= drivenHigh && heldHigh < drivenLow; }
  /// Whether anything is held.
  bool isHeld() const { return heldLow <= heldHigh; }
};

/// Sums over automata, which ranks add up.
struct LayerContents {
  double cells = 0.0;              ///< what solid would need between the innermost rows [length^3]
  double above = 0.0, below = 0.0; ///< free ones beyond the driven, below the held layer

  /// An automaton: free ones between the rigid layers count whole; those of their innermost rows,
  /// which are a quarter of a diameter high, half, since the heights are those of centres.
  /// \param cell  V of it in the unloaded solid [length^3]
  /// \param d     its diameter [length]
  void add(const RigidLayers &layers, Part part, double y, double cell, double d)
  {
    if (part == Part::Free) {
      above += y > layers.drivenHigh ? 1.0 : 0.0;
      below += layers.isHeld() && y < layers.heldLow ? 1.0 : 0.0;
      cells += y > layers.heldHigh && y < layers.drivenLow ? cell : 0.0;
      return;
    }
    const double inside = part == Part::Held ? layers.heldHigh - y : y - layers.drivenLow;
    cells += inside < 0.25 * d ? 0.5 * cell : 0.0;
  }
};

/// Area (in space: volume) of an automaton between the innermost rows over that in the unloaded
/// solid [-]: below 1 automata have sunk into each other, above 1 there are voids.
/// \param area  of the layer in x and z [length^2]
/// \return 0 where there are no two layers, or nothing between them
inline double roomOf(const RigidLayers &layers, const LayerContents &contents, double area)
{
  if (!layers.areApart() || !(contents.cells > 0.0))
    return 0.0;
  return (layers.drivenLow - layers.heldHigh) * area / contents.cells;
}

} // namespace mca

#endif
