// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_QUICK_HALF_SPACE_H
#define WHEELRAIL_PATCH_QUICK_HALF_SPACE_H

#include "contact/patch/elasticity/influence_table.h"
#include "contact/patch/elasticity/tangential_field.h"

namespace wheelrail {

/// Products of `PatchHalfSpace` with pressures, in single precision: half the time, an error of
/// 1e-6 of the largest value.
class QuickHalfSpace final : public QuickProducts {
 public:
  /// \param table of cells of the same shape, over at least as many
  QuickHalfSpace(const CellGrid &grid, const ElasticPair &pair, const InfluenceTable &table);

  void displacement(const Field &pressure, Field &result) override;
  void tractionEstimate(const Field &displacement, Field &result) override;

 private:
  using Transform = PlaneTransformOf<float>;
  using Spectrum = std::vector<float>; ///< as of `Quarter`
  static void product(const Field &field, Transform &transform, const Spectrum &spectrum,
                      Field &result);

  Transform padded_, wrapping_;
  Spectrum compliance_, stiffness_;
};

/// Its products with tractions, likewise.
class QuickTractions {
 public:
  /// \param table as of `QuickHalfSpace`
  QuickTractions(const CellGrid &grid, const ElasticPair &pair, const InfluenceTable &table);

  /// As the functions of `PatchHalfSpace`.
  TangentialField displacement(const TangentialField &traction);
  TangentialField tractionEstimate(const TangentialField &displacement);

 private:
  using Transform = PlaneTransformOf<float>;
  using Symbol = SymmetricSymbolOf<float>;
  static TangentialField product(const TangentialField &field, Transform &transform,
                                 const Symbol &symbol);

  Transform padded_, wrapping_;
  Symbol compliance_, stiffness_;
};

} // namespace wheelrail
#endif
