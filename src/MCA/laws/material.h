// SPDX-License-Identifier: GPL-2.0-or-later
/// \file material.h
/// The homogeneous material of a movable cellular automaton (Table 1 and Fig. 5 of Bucher et al.,
/// Wear 261 (2006) 874).
///
/// Any consistent set of units; dimensions stand in brackets. No LAMMPS type in here.
#ifndef MCA_LAWS_MATERIAL_H
#define MCA_LAWS_MATERIAL_H

#include <string>
#include <vector>

namespace mca {

/// Values of one line of the potential file. checkMaterial() has the allowed ranges, and all other
/// functions of a material rely on it.
struct Material {
  double youngsModulus = 0;  ///< E [stress], > 0
  double poissonsRatio = 0;  ///< nu [-], in (-1, 0.5)
  double density = 0;        ///< rho [mass/length^3] of the solid, > 0
  double strength = 0;       ///< sigma_0 [stress], ultimate tensile strength, > 0
  double elasticLimit = 0;   ///< sigma_y1 / sigma_0 [-], in (0, 1]
  double yieldStrength = 0;  ///< sigma_y2 / sigma_0 [-], in [elasticLimit, 1]
  double yieldStrain = 0;    ///< eps_y2 [-], total strain at which sigma_y2 is reached
  double breakingStrain = 0; ///< eps_c [-], total strain at which sigma_0 is reached
  double viscosity = 0;      ///< eta [stress time], >= 0
  double diameter = 0;       ///< d [length] of the automaton, > 0

  /// G = E/[2(1 + nu)] [stress]
  double shearModulus() const { return youngsModulus / (2.0 * (1.0 + poissonsRatio)); }
  /// K = E/[3(1 - 2 nu)] [stress]
  double bulkModulus() const { return youngsModulus / (3.0 * (1.0 - 2.0 * poissonsRatio)); }

  /// Elastic limit sigma_y1 [stress], where flow begins.
  double sigmaY1() const { return elasticLimit * strength; }
  /// Yield strength sigma_y2 [stress], the second point of the diagram.
  double sigmaY2() const { return yieldStrength * strength; }

  /// Equivalent plastic strain at sigma_y2 and at sigma_0: the diagram's total strain less the
  /// elastic part [-]; > 0 and in this order where checkMaterial() accepts the material.
  double plasticStrainY2() const { return yieldStrain - sigmaY2() / youngsModulus; }
  double plasticStrainUltimate() const { return breakingStrain - strength / youngsModulus; }

  /// Equal in all values, exactly.
  bool operator==(const Material &) const;
};

/// One row of the table from which the potential file, the keywords of pair_coeff, the restart file
/// and the documentation are made. Adding a quantity is a line of the table, a member of Material
/// and its check.
struct MaterialQuantity {
  const char *keyword;
  double Material::*value;
  /// As the pages name it, and as unit conversion knows it: "stress", "length", "-" and so on.
  const char *dimension;
  /// Its range in words, for messages.
  const char *allowed;
};

/// All quantities of a material, in the order of the potential file.
const std::vector<MaterialQuantity> &materialQuantities();

/// The table's row of this keyword, compared exactly, or nullptr.
const MaterialQuantity *findMaterialQuantity(const std::string &keyword);

/// The keywords of the table.
std::vector<std::string> materialKeywords();

/// Checks each value's range and the order of the diagram's three points; a value that is not
/// finite is refused.
/// \return an empty string, or one line: keyword, value, what is allowed; of several faults the
/// first
std::string checkMaterial(const Material &);

} // namespace mca

#endif
