// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_CASE_CASE_FILE_H
#define WHEELRAIL_CREEP_CASE_CASE_FILE_H

#include "creep/line/creep_curve.h"
#include "creep/line/static_contact.h"
#include "creep/patch/patch_curve.h"

#include <string>
#include <variant>
#include <vector>

namespace wheelrail {

/// What a case file asks for, in the words of the physics, and the file itself with everything
/// filled in.
/// Values and their combinations were checked when it was read; files that it names were not
/// opened.
struct Case {
  /// A line contact that rolls, or carries a tangential force without rolling (mode static); or a
  /// contact in a point.
  std::variant<CreepSpecification, StaticSpecification, PatchSpecification> task;
  /// The complete configuration as a case file: reading it gives the same case.
  std::string text;

  const LawChoice &friction() const; ///< of the task
  /// Files that the case reads, by the path that will be opened: law, measured surfaces.
  std::vector<std::string> files() const;
  /// All that decides the results, for a journal: the text, and the content of the files it names
  /// as checksums. Reads them.
  /// @throws Error (BadInput) for a file that cannot be read
  std::string identity() const;
};

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
  double smallest;
  const char *choices; ///< Choice: separated by '|'
  const char *help;    ///< half a sentence for --help and messages
};

/// The range of a keyword that takes numbers, in words: "[-10, 10], 0 and beyond 1e-12 1/m".
std::string rangeOf(const Keyword &keyword);

/// All keywords, in the order of --help and --print-config; every group together.
/// @return the same table in every call; it lives as long as the program
const std::vector<Keyword> &keywords();

/// Reads a case file (YAML) and then "keyword=value" changes, the value in YAML as in the file.
/// Profile and law files that are named in it are looked for from the working folder, then from the
/// case file's; they are not read here.
/// @return all in SI units
/// @throws Error (BadInput) for the file, with line and keyword; Error (Usage) for changes
/// @param path of the case file
/// @param changes of --set, later ones over earlier ones
Case readCase(const std::string &path, const std::vector<std::string> &changes = {});

} // namespace wheelrail
#endif
