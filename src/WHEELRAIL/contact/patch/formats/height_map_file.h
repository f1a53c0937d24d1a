// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PATCH_HEIGHT_MAP_FILE_H
#define WHEELRAIL_PATCH_HEIGHT_MAP_FILE_H

#include "contact/patch/formats/height_map.h"

#include <string>

namespace wheelrail {

/// A measured height map. The format is told by what the file begins with, not by its name:
///
/// - GSF, Gwyddion Simple Field 1.0, begins with "Gwyddion Simple Field 1.0". Spacing is XReal/XRes
///   and YReal/YRes in XYUnits, heights are in ZUnits; the head must state all of them. Rows run
///   downwards.
/// - SDF of ISO 25178-71 in ASCII, ISO-1.0 and 2.0, begins with "aISO-". Xscale, Yscale and Zscale
///   are in metres. Rows run upwards.
/// - Its forerunner begins with "aBCR-1.0". The same, but rows run downwards.
/// - SDF in binary begins with "bISO-" or "bBCR-1.0". Points that were not measured have the
///   smallest integer of a signed type, or no finite float.
/// - x3p of ISO 25178-72 begins as a zip file. Lengths are in metres. Rows run upwards.
/// - SUR of Digital Surf begins with "DIGITAL SURF". Rows run downwards.
/// - npy 1.0, 2.0, 3.0 begins with "\x93NUMPY": float32 or float64 in either byte order, C or
///   Fortran order. Spacing and unit come from `scale`; both are needed. Rows run downwards, as
///   a picture of the array is drawn.
/// - Anything else is a text matrix with a head, see below. Rows run downwards unless it says so.
///
/// *Text matrix.* Head lines begin with '#':
///   # height: um
///   # spacing: 5 um           (or two: # spacing: 5 um, 10 um for x and y)
///   # rows: upwards           (downwards where nothing is said)
///   # points: 512, 256        (may be left out; along x and y, compared with what follows)
/// or those of Gwyddion's export as text with a header, Width, Height and Value units; or, of a
/// list of points, one a line,
///   # height: um
///   # position: mm            (the columns are x, y, height; y upwards; points in any order)
/// else then one line for each row of points along x, numbers separated by blanks, commas,
/// semicolons or tabs.
///
/// Unmeasured points are NaN in GSF and npy, BAD in SDF and "nan" in a text matrix. In every format
/// heights beyond 1000 m, infinite ones among them, and spacings outside of 1e-12 to 1000 m are
/// refused, and so is a key of the head that appears twice.
///
/// No length that a file states is believed before it was compared with the file's size; maps of
/// more than 2^27 points (1 GiB) are refused. GSF and npy files must end where their data end; SDF
/// files that are compressed or have check sums are refused. So a file that was cut off is
/// refused, but for a text matrix without `points`. None of the formats carries a check sum: a
/// height that was falsified is not noticed unless it is infinite.
/// \param scale for formats that do not state their lengths (npy); others leave it alone
/// \throws Error (BadInput), one line: file, line or byte, what stands there, what is allowed. At
///         least 4 x 4 points are needed.
HeightMap readHeightMap(const std::string &path, const HeightMapScale &scale = {});

/// Does a file state its own spacing and unit? By what it begins with; true for a file that is not
/// there or cannot be opened, which `readHeightMap` then says.
bool statesLengths(const std::string &path);

} // namespace wheelrail
#endif
