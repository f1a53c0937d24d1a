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

/// What is known of a criterion without its type.
struct CriterionInfo {
  const char *keyword;
  bool strainOnly, needsLocalStress, inSpace;
  const char *parameter; ///< its own keyword, or nullptr
  const char *parameterRange;
  bool (*accepts)(double);
};

class FractureLaw {
 public:
  static constexpr const char *keyword = "fracture";

  /// Of all criteria, in the order of FractureCriteria.
  static const std::array<CriterionInfo, FractureCriteria::size> &criteria();

  int number() const { return number_; } ///< in FractureCriteria
  const CriterionInfo &criterion() const { return criteria()[number_]; }
  std::string word() const { return criterion().keyword; }
  bool take(const std::string &word);
  static std::vector<std::string> words();
  static std::string allowed();
  bool actsIn(int dimension) const { return dimension == 2 || criterion().inSpace; }

  /// Its number, or "none".
  std::string parameterWord(int criterion) const { return parameter_[criterion].word(nullptr); }
  bool takeParameter(int criterion, const std::string &word)
  {
    return parameter_[criterion].take(word, nullptr);
  }

  /// The number given by this keyword of a criterion.
  /// \throw std::invalid_argument  no criterion has it
  /// \throw std::logic_error  it was not given
  double parameter(const std::string &name) const;

  /// \return an empty string, or one line: what is wrong with the criterion's number
  std::string problem() const;

  /// \param materials  their `parameter` is set here
  FractureLimits limits(LinkMaterials materials) const;

  /// \throw std::invalid_argument  there is no such word
  FractureLaw &operator=(const std::string &word)
  {
    if (!take(word))
      throw std::invalid_argument("fracture " + word);
    return *this;
  }

 private:
  int number_ = 0;
  std::vector<Threshold> parameter_ =
      std::vector<Threshold>(FractureCriteria::size, Threshold::off());
};

/// Whether a bulk link breaks, by the criterion of these limits or by collapse; for few links.
/// Loops take breaks<Criterion>() instead.
struct LinkLimits;
bool bulkBreaks(const LinkLimits &, const LinkLoad &);

} // namespace mca

#endif
