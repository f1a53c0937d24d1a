// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CONTACT_ROUGHNESS_KIND_H
#define WHEELRAIL_CONTACT_ROUGHNESS_KIND_H

namespace wheelrail {

/// Where the roughness of a contact comes from: there is none, it is generated from a spectrum, or
/// it was measured. For line and point contacts alike.
/// Fractal: a self-affine surface from a seed. Measured: a profile or a
/// height map from a file.
enum class RoughnessKind { None, Fractal, Measured };

} // namespace wheelrail
#endif
