// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_BASE_SI_H
#define WHEELRAIL_BASE_SI_H

namespace wheelrail {

/// Units of files, in SI: a length x in metres is x / mm in millimetres.
constexpr double nm = 1e-9, um = 1e-6, mm = 1e-3, mm2 = 1e-6;
constexpr double MPa = 1e6, GPa = 1e9;
constexpr double newtonMm = 1e-3;   ///< N mm, a moment
constexpr double newtonPerMm = 1e3; ///< N/mm, a load per length

} // namespace wheelrail
#endif
