// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_CASE_KEYWORDS_H
#define WHEELRAIL_CREEP_CASE_KEYWORDS_H

#include <string>
#include <vector>

namespace wheelrail {

/// A contact in a mode, as bits, and what a keyword is for.
using Scope = unsigned;
namespace scope {
constexpr Scope lineFrozen = 1, lineMoving = 2, lineStatic = 4;
constexpr Scope pointFrozen = 8, pointMoving = 16, pointStatic = 32;
constexpr Scope line = lineFrozen | lineMoving | lineStatic;
constexpr Scope point = pointFrozen | pointMoving | pointStatic;
constexpr Scope everywhere = line | point;
constexpr Scope rolling = everywhere & ~(lineStatic | pointStatic);
/// Surfaces: a keyword without either is for both.
constexpr Scope generated = 64, measured = 128;
} // namespace scope

/// One keyword of the case file. The table of them is the one source of parsing, `--help`,
/// `--print-config` and the check against the documentation.
/// Units in a case file may be any that UDUNITS-2 converts; the program goes on in SI units.
struct Keyword {
  /// What a value may be; only the lists take more than one.
  /// Form and range are checked when a value is read, before its meaning.
  enum class Kind {
    Quantity, ///< a number with a unit that UDUNITS-2 can convert to `unit`
    QuantityList,
    Ratio, ///< a pure number, or one in per cent
    RatioList,
    Number, ///< a number without a unit
    NumberList,
    Integer,
    IntegerList,
    Unit,   ///< a unit, "mm", or a number with one: what a 1 means
    Switch, ///< true, false
    Choice, ///< one of `choices`
    Text,
    TextList
  };
  /// Group and word; at most one dot.
  const char *name; ///< with dots: "contact.radius"
  Kind kind;
  const char *unit;    ///< SI unit for UDUNITS-2; "1": pure number
  const char *initial; ///< value that is used when it is not given; "": none
  double low, high;    ///< allowed range in `unit`, finite, both ends included
  /// Where the range holds 0: how far from it any other number has to be. 0: any distance.
  /// Negative: what is nearer to 0 than that counts as 0, as the rounding of a creepage.
  double smallest;
  const char *choices; ///< Choice: separated by '|'
  const char *help;    ///< half a sentence for --help and messages
  /// Contacts and modes that it is for; in all others it is refused.
  Scope scope = scope::everywhere;
  const char *why = ""; ///< why it is refused in a mode of a contact that it is for; or empty
};

/// The name in the table: cells of `points`, its older name, which is read as well. Any other word
/// comes back as it is.
std::string presentName(const std::string &name);

/// What --help says before the help: "point contact, mode moving or static: "; empty where a
/// keyword is for both contacts.
std::string scopeWords(const Keyword &keyword);

/// A keyword or group that another one rules out.
struct Exclusion {
  const char *given, *excluded;
  const char *why; ///< or empty
  Scope scope;     ///< where that is so
};
/// All of them. \return the same table in every call
const std::vector<Exclusion> &exclusions();

/// The range of a keyword that takes numbers, in words: "[-10, 10], 0 and beyond 1e-12 1/m".
std::string rangeOf(const Keyword &keyword);

/// All keywords, in the order of --help and --print-config; every group together.
/// \return the same table in every call; it lives as long as the program
const std::vector<Keyword> &keywords();

} // namespace wheelrail
#endif
