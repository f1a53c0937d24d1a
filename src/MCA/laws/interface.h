// SPDX-License-Identifier: GPL-2.0-or-later
/// \file interface.h
/// What two types of automata have of their own where they meet: a coating, an inclusion, the
/// boundary of two grains. No LAMMPS type in here.
#ifndef MCA_LAWS_INTERFACE_H
#define MCA_LAWS_INTERFACE_H

#include "material.h"

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mca {

struct LawSet;

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
  /// Keywords link, weld, heal, worn of pair_style with their values.
  std::vector<std::string> links;

  bool operator==(const Interface &other) const;
  /// Nothing is given.
  bool empty() const { return *this == Interface(); }

  /// Keywords and values, which parse() reads back exactly.
  std::vector<std::string> words() const;
  /// \param words  keyword, value, keyword, value, ...; a keyword may stand twice, the last one
  ///               counts
  /// \param laws   of the pair style: links break by one criterion everywhere
  /// \return empty, or one line: keyword, value, what is allowed; then nothing has changed
  std::string parse(const std::vector<std::string> &words, const LawSet &laws);
  /// Whether it fits other laws.
  /// \return as parse()
  std::string problem(const LawSet &laws) const;

  /// The laws of its links and contacts.
  LawSet laws(const LawSet &usual) const;
  /// One of both materials with strength and breaking strain of the interface.
  Material material(Material) const;
};

/// By two types, the lower one first.
using Interfaces = std::map<std::pair<int, int>, Interface>;

/// That of two types in any order, or nullptr.
const Interface *findInterface(const Interfaces &, int typeI, int typeJ);

} // namespace mca

#endif
