// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CONTACT_INTERFACIAL_LAYER_H
#define WHEELRAIL_CONTACT_INTERFACIAL_LAYER_H

#include <limits>

namespace wheelrail {

/// A layer between the bodies, of oxide or sand for example: it shears like a Winkler foundation
/// and flows at its yield stress (elastic, perfectly plastic). SI units.
struct InterfacialLayer {
  double thickness = 0.0;    ///< m; 0: no layer
  double shearModulus = 1.0; ///< Pa, > 0
  /// Pa, > 0: no traction is larger. What the layer flows counts as slip, for both dissipate and
  /// neither is undone.
  double yieldStress = std::numeric_limits<double>::infinity();

  double compliance() const { return thickness / shearModulus; } ///< m/Pa
};

} // namespace wheelrail
#endif
