// SPDX-License-Identifier: GPL-2.0-or-later
/// \file friction_laws.h
/// The friction laws of contacts: the one list from which come the words and keywords of a case
/// with their messages and --help, and the check against the documentation. A new one is a header
/// in law/forms/, its line here, its test and its paragraph.
#ifndef WHEELRAIL_LAW_FRICTION_LAWS_H
#define WHEELRAIL_LAW_FRICTION_LAWS_H

#include "law/forms/constant.h"
#include "law/forms/eq2.h"
#include "law/forms/material.h"
#include "law/forms/polach.h"
#include "law/forms/table.h"

#include <string>
#include <vector>

namespace wheelrail {

/// A law of the list, as cases and pages know it. The types of law/forms/ have each of these as a
/// static member.
struct LawForm {
  const char *word;                 ///< begins its paragraph on the page, and stands in messages
  const char *named;                ///< what may stand after friction.law, in words
  std::vector<LawKeyword> keywords; ///< those that it reads, in the order of --help
  bool (*isNamedBy)(const LawName &name); ///< is this the law that a case means?
  LawChoice (*choose)(const LawValues &values);

  /// Does it read the keyword?
  bool reads(const std::string &keyword) const;
};

/// \tparam Laws  types derived from FrictionLaw. A name belongs to the first one that takes it.
template<class... Laws>
struct LawList {
  static std::vector<LawForm> forms()
  {
    return {{Laws::word, Laws::named, Laws::keywords(), Laws::isNamedBy, Laws::choose}...};
  }
};

/// The list.
using FrictionLaws = LawList<ConstantLaw, PolachLaw, TableLaw, LawOfMaterial, Eq2Law>;

/// The forms of the list, in its order.
const std::vector<LawForm> &lawForms();

/// The form that a name belongs to; every name belongs to one.
const LawForm &lawFormOf(const LawName &name);

/// What may stand after friction.law, in words.
std::string lawNames();

/// The keywords of all laws, each once, in the order of the list.
std::vector<LawKeyword> lawKeywords();

/// The laws that read a keyword, in words: "law: constant", "law: a or law: b".
std::string lawsWith(const std::string &keyword);

} // namespace wheelrail
#endif
