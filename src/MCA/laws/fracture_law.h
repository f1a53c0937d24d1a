// SPDX-License-Identifier: GPL-2.0-or-later
/// \file fracture_law.h
/// Keyword fracture: which criterion of fracture_criteria.h bulk links break by, and the numbers of
/// those that have a keyword of their own.
#ifndef MCA_LAWS_FRACTURE_LAW_H
#define MCA_LAWS_FRACTURE_LAW_H

#include "fracture_criteria.h"
#include "keyword.h"

#include <array>
#include <optional>

namespace mca {

/// What is known of a criterion without its type: the static members of FractureCriterion
/// (fracture.h), one row of the table criteria().
struct CriterionInfo {
  /// The word after keyword fracture.
  const char *keyword;
  /// It decides by strain alone; it reads the local stress; it acts in space, too.
  bool strainOnly, needsLocalStress, inSpace;
  const char *parameter; ///< its own keyword, or nullptr
  /// What its number has to be, in words, and whether a number is that.
  const char *parameterRange;
  bool (*accepts)(double);
};

/// The choice of one criterion. Values of the criteria's own keywords are kept for all criteria,
/// since they may be given before the word of fracture itself; problem() says what does not fit.
class FractureLaw {
 public:
  /// The keyword itself, as the laws of law_keywords.h have it.
  static constexpr const char *keyword = "fracture";

  /// The table of all criteria, in the order of FractureCriteria.
  static const std::array<CriterionInfo, FractureCriteria::size> &criteria();

  int number() const { return number_; } ///< in FractureCriteria
  /// The row of the chosen criterion.
  const CriterionInfo &criterion() const { return criteria()[number_]; }
  /// Its word; by default that of the first criterion, "strain".
  std::string word() const { return criterion().keyword; }
  /// Chooses the criterion of this word; a number given before stays and is looked at by problem().
  /// \param word  compared exactly, with its case
  /// \return false if there is no such word; nothing changes then
  bool take(const std::string &word);
  /// The words of all criteria, in the order of FractureCriteria.
  static std::vector<std::string> words();
  /// The words that are allowed, with commas, for messages.
  static std::string allowed();
  /// Whether the chosen criterion acts in this dimension, 2 or 3.
  bool actsIn(int dimension) const { return dimension == 2 || criterion().inSpace; }

  /// The first criterion with the same own keyword, which keeps the number for all that share it.
  /// \param criterion  its number in FractureCriteria, of one that has a keyword
  static int keeperOf(int criterion);
  /// The number of a criterion's own keyword as a word that takeParameter() reads back exactly, or
  /// "none".
  /// \param criterion  its number in FractureCriteria, of a keeper; not checked, here and below
  std::string parameterWord(int criterion) const { return parameter_[criterion].word(nullptr); }
  /// Reads the number of a criterion's own keyword: a multiple of the strength > 0, or "none".
  /// Whether the criterion accepts it is up to problem().
  /// \return false for a bad word; nothing changes then
  bool takeParameter(int criterion, const std::string &word)
  {
    return parameter_[criterion].take(word, nullptr);
  }

  /// The number given by this keyword of a criterion [-].
  /// \param name  such as "compressive_strength"
  /// \throw std::invalid_argument  no criterion has it
  /// \throw std::logic_error  it was not given
  double parameter(const std::string &name) const;

  /// Whether criterion and numbers fit: the chosen criterion has its number, in its range, and no
  /// other criterion was given one.
  /// \return an empty string, or one line: keyword, value, what is allowed
  std::string problem() const;

  /// The limits of the chosen criterion for links of these two materials, for breaks().
  /// \param materials  their `parameter` is set here: the number given, 1 without one
  FractureLimits limits(LinkMaterials materials) const;

  /// For presets and tests.
  /// \throw std::invalid_argument  there is no such word; nothing changes then
  FractureLaw &operator=(const std::string &word);

 private:
  /// In FractureCriteria.
  int number_ = 0;
  /// By keeper; off where the keyword was not given, and of all that are no keepers.
  std::vector<Threshold> parameter_ =
      std::vector<Threshold>(FractureCriteria::size, Threshold::off());
};

/// Limits of all transitions of a pair; linking.h.
struct LinkLimits;
/// Whether a bulk link breaks, by the criterion of these limits or by collapse; for few links,
/// since it looks for the criterion each time. Loops take breaks<Criterion>() instead.
/// \param load  of linkLoad() [-], [stress]
bool bulkBreaks(const LinkLimits &, const LinkLoad &);

} // namespace mca

#endif
