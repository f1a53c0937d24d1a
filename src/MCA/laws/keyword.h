// SPDX-License-Identifier: GPL-2.0-or-later
/// \file keyword.h
/// What the keywords of pair_style mca are made of: a choice among words, and a threshold. A law is
/// a small type derived from one of them; law_set.h puts them together. No LAMMPS type in here.
#ifndef MCA_LAWS_KEYWORD_H
#define MCA_LAWS_KEYWORD_H

#include "material.h"

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace mca {

/// One word that a keyword takes.
struct Option {
  const char *word;
  bool inSpace = true; ///< acts in space, too, not only in the plane
};

/// A law of which one of several kinds holds; the first one by default.
/// \tparam Words  has `keyword`, `options` and an enumeration `Kind` of them, in their order
template<class Words>
class Choice : public Words {
 public:
  using Kind = typename Words::Kind;

  Kind kind() const { return kind_; }
  bool is(Kind kind) const { return kind_ == kind; }
  std::string word() const { return Words::options[kind_].word; }

  /// \return false if there is no such word; nothing changes then
  bool take(const std::string &word)
  {
    int number = 0;
    for (const Option &o : Words::options) {
      if (word == o.word) {
        kind_ = static_cast<Kind>(number);
        return true;
      }
      number++;
    }
    return false;
  }

  static std::vector<std::string> words()
  {
    std::vector<std::string> all;
    for (const Option &o : Words::options)
      all.emplace_back(o.word);
    return all;
  }

  /// What take() takes, for messages: the words with commas.
  static std::string allowed()
  {
    std::string all;
    for (const std::string &word : words())
      all += (all.empty() ? "" : ", ") + word;
    return all;
  }

  /// Whether it acts in this dimension, 2 or 3.
  bool actsIn(int dimension) const { return dimension == 2 || Words::options[kind_].inSpace; }

  /// \throw std::invalid_argument  there is no such word
  Choice &operator=(const std::string &word)
  {
    if (!take(word))
      throw std::invalid_argument(std::string(Words::keyword) + " " + word);
    return *this;
  }

 private:
  Kind kind_ = static_cast<Kind>(0);
};

/// A limit that is switched off, a multiple of something, or a named stress of the material.
class Threshold {
 public:
  static Threshold off() { return Threshold(Kind::Off, 0.0); }
  static Threshold times(double factor) { return Threshold(Kind::Factor, factor); }
  static Threshold ofMaterial() { return Threshold(Kind::OfMaterial, 0.0); }

  bool isOff() const { return kind_ == Kind::Off; }
  bool isOfMaterial() const { return kind_ == Kind::OfMaterial; }

  /// \throw std::logic_error  it is no multiple
  double factor() const
  {
    if (kind_ != Kind::Factor)
      throw std::logic_error("this threshold is no multiple");
    return factor_;
  }

  /// The limit in numbers, for comparisons; infinity, which nothing reaches, where it is off.
  /// \param unit        what it is a multiple of
  /// \param ofMaterial  the named stress
  double limit(double unit, double ofMaterial = 0.0) const
  {
    return isOff()          ? std::numeric_limits<double>::infinity()
           : isOfMaterial() ? ofMaterial
                            : factor_ * unit;
  }

  bool operator==(const Threshold &o) const { return kind_ == o.kind_ && factor_ == o.factor_; }
  bool operator!=(const Threshold &o) const { return !(*this == o); }

  /// As a word that take() reads back exactly.
  /// \param name  of the material's stress; nullptr: it takes none
  std::string word(const char *name) const;
  bool take(const std::string &word, const char *name);
  static std::string allowed(const char *name);

 private:
  enum class Kind { Off, Factor, OfMaterial };
  Threshold(Kind kind, double factor) : kind_(kind), factor_(factor) {}

  Kind kind_;
  double factor_;
};

/// A law that is one threshold.
/// \tparam Words  has `keyword`, `materialStress` (the name of a stress of the material, or
/// nullptr)
///                and `initial()`, its default
template<class Words>
class ThresholdLaw : public Words {
 public:
  const Threshold &threshold() const { return threshold_; }
  bool isOff() const { return threshold_.isOff(); }
  std::string word() const { return threshold_.word(Words::materialStress); }
  bool take(const std::string &word) { return threshold_.take(word, Words::materialStress); }
  static std::string allowed() { return Threshold::allowed(Words::materialStress); }

  /// Words beside the number.
  static std::vector<std::string> words()
  {
    std::vector<std::string> all = {"none"};
    if constexpr (Words::materialStress != nullptr)
      all.emplace(all.begin(), Words::materialStress);
    return all;
  }

  bool actsIn(int /*dimension*/) const { return true; }

  ThresholdLaw &operator=(const Threshold &threshold)
  {
    threshold_ = threshold;
    return *this;
  }

 private:
  Threshold threshold_ = Words::initial();
};

} // namespace mca

#endif
