// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef MCAWR_SHARED_PLAIN_NUMBER_H
#define MCAWR_SHARED_PLAIN_NUMBER_H

#include <optional>
#include <string>
#include <string_view>

namespace mcawr {

/// The decimal number that a text begins with, in the C locale whatever the program's is: digits
/// with an optional sign, point and power of ten ("-1.5e-3"). No hexadecimal form: "0x10" begins
/// with 0, and "x10" is left over.
/// A text gives one number whatever locale a host program has set.
struct LeadingNumber {
  double value;          ///< finite, correctly rounded
  std::string_view rest; ///< what follows, untouched
};

/// \return nothing where the text does not begin with a finite number (blanks included, "nan",
///         "inf", beyond the range of double precision)
/// \param text must outlive the result's `rest`
std::optional<LeadingNumber> leadingNumber(std::string_view text);

/// Number of a text that has to be one number as a whole.
/// \return nothing where anything is left over, blanks included
std::optional<double> plainNumber(std::string_view text);

/// A number as text, in the C locale whatever the program's is: what printf's "%.*g" gives there.
/// What is written for others to read goes through this, never through printf or a stream.
/// \param digits significant ones, 1 to 17; 17 give back the same number
std::string numberWord(double value, int digits = 6);

} // namespace mcawr
#endif
