// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_LAW_LAW_CHOICE_H
#define WHEELRAIL_LAW_LAW_CHOICE_H

#include "law/friction_law.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// How a law is asked for: the words and keywords by which a case names it, before any of its files
/// is opened.
namespace wheelrail {

/// A keyword of a case that a law reads. Several laws may share one, with equal rows.
struct LawKeyword {
  enum class Kind { Number, Quantity, Switch };
  const char *name; ///< with its group: "friction.mu"
  Kind kind;
  const char *unit;    ///< SI, for UDUNITS-2; "1": a pure number
  const char *initial; ///< value where it is not given; "": it is needed, and refused with others
  double low, high;    ///< allowed range in `unit`, finite, both ends included
  const char *help;    ///< half a sentence
};

/// What a case says after friction.law.
struct LawName {
  std::string word; ///< as given
  std::string path; ///< to open where it is a file: the word, or from the folder of the case
};

/// Values of the keywords that a law reads, all checked against their ranges.
struct LawValues {
  LawName name;
  std::map<std::string, double> numbers; ///< SI; a switch is 0 or 1

  /// \param keyword one of the law's own
  double operator[](const std::string &keyword) const { return numbers.at(keyword); }
};

/// Where the fault of a mu that is not one for all cells lies, for a contact that needs one.
struct CellwiseMu {
  std::string keyword; ///< "friction.local"
  std::string needed;  ///< what it would have to be: "false"
};

/// A law as a case asks for it: its values are checked, its files are not opened.
struct LawChoice {
  /// Makes the law. \throws Error (BadInput) for a file that cannot be read
  std::function<LawPointer()> read;
  std::vector<std::string> files;     ///< by the path that `read` opens
  bool mayHaveCovariance = false;     ///< group `uncertainty` of a case means something
  bool takesStrength = false;         ///< mu depends on the strength that the case states
  bool hasStrength = false;           ///< the strength is that of its own material
  std::optional<CellwiseMu> cellwise; ///< absent: all cells of a temperature have the same mu
};

} // namespace wheelrail
#endif
