// SPDX-License-Identifier: GPL-2.0-or-later
/// \file interface.h
/// What two types of automata have of their own where they meet: a coating, an inclusion, the
/// boundary of two grains. interface_words.h reads it. No LAMMPS type in here.
#ifndef MCA_LAWS_INTERFACE_H
#define MCA_LAWS_INTERFACE_H

#include "material.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mca {

/// Numbers and laws of links that take the place of what would follow from both materials
/// (doc/laws.md, Unlike materials); what is not given follows from them. Moduli, flow and diameter
/// are always those of the materials.
struct Interface {
  /// sigma_0 of its links [stress], > 0: criteria of stress, and what is a multiple of the strength
  /// or a stress of the yield curve, which keeps its shape.
  std::optional<double> strength;
  /// eps_c of its links [-], > 0 and < 0.5.
  std::optional<double> breakingStrain;
  /// eta [stress time], >= 0.
  std::optional<double> viscosity;
  /// mu of its unlinked contacts [-], >= 0.
  std::optional<double> friction;
  /// Keywords link, weld, heal, healed_strain, worn of pair_style with their values.
  std::vector<std::string> links;

  bool operator==(const Interface &other) const
  {
    return strength == other.strength && breakingStrain == other.breakingStrain &&
           viscosity == other.viscosity && friction == other.friction && links == other.links;
  }
  /// Nothing is given.
  bool empty() const { return *this == Interface(); }

  /// One of both materials with strength and breaking strain of the interface.
  Material material(Material m) const
  {
    m.strength = strength.value_or(m.strength);
    m.breakingStrain = breakingStrain.value_or(m.breakingStrain);
    return m;
  }
};

/// By two types, the lower one first.
using Interfaces = std::map<std::pair<int, int>, Interface>;

/// The interface of two types in any order, or nullptr.
inline const Interface *findInterface(const Interfaces &all, int typeI, int typeJ)
{
  const auto found = all.find(std::minmax(typeI, typeJ));
  return found == all.end() ? nullptr : &found->second;
}

} // namespace mca

#endif
