// SPDX-License-Identifier: GPL-2.0-or-later
/// \file keyword.h
/// What the keywords of pair_style mca are made of: a choice among words, and a threshold. A law is
/// a small type derived from one of them; law_set.h puts them together. No LAMMPS type in here.
/// Choice and ThresholdLaw have the same functions, so that one table of law_set.h serves all
/// keywords: take() reads a word, word() gives it back for restart files, allowed() fills error
/// messages, and actsIn() says whether the present value has a meaning in the plane or in space.
/// take() does not throw on a bad word of the input: the caller makes the message, which names the
/// keyword.
#ifndef MCA_LAWS_KEYWORD_H
#define MCA_LAWS_KEYWORD_H

#include "material.h"

#include "shared/plain_number.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace mca {

/// One word that a keyword takes. Words are those of the input script and of restart files, so that
/// a word that changes its meaning makes old files mean something else.
struct Option {
  const char *word;
  bool inSpace = true; ///< acts in space, too, not only in the plane
};

/// A law of which one of several kinds holds; the first one by default. Keyword and words come from
/// the base, so that a law is declared once, in law_keywords.h.
/// \tparam Words  has `keyword`, `options`, an array of Option with at least one, and an
///                enumeration `Kind` of them, in their order
template<class Words>
class Choice : public Words {
 public:
  /// The enumeration of the law; its values count from 0 in the order of Words::options.
  using Kind = typename Words::Kind;

  /// The kind that holds; the first of the options until take() or operator= chooses another.
  Kind kind() const { return kind_; }
  /// Whether this kind holds. Laws are asked in set-up only; what loops read of them are numbers
  /// (PairLaw, AutomatonLaw).
  bool is(Kind kind) const { return kind_ == kind; }
  /// Its word, which take() reads back.
  std::string word() const { return Words::options[kind_].word; }

  /// Makes the kind of this word hold.
  /// \param word  compared exactly, with its case
  /// \return false if there is no such word; nothing changes then, and the caller makes the message
  /// from allowed()
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

  /// All words in the order of Words::options; the first one is the default. For messages about a
  /// misspelt word and for the check against the documentation.
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

  /// Whether the present kind has a meaning in this dimension, 2 or 3. What has none is an error of
  /// the input, found by LawSet::notInDimension() when the box is known.
  bool actsIn(int dimension) const { return dimension == 2 || Words::options[kind_].inSpace; }

  /// For presets and tests.
  /// \throw std::invalid_argument  there is no such word; nothing changes then
  Choice &operator=(const std::string &word)
  {
    if (!take(word))
      throw std::invalid_argument(std::string(Words::keyword) + " " + word);
    return *this;
  }

 private:
  /// The first option is the default.
  Kind kind_ = static_cast<Kind>(0);
};

/// A limit that is switched off, a multiple of something, or a named stress of the material,
/// without a number that stands for "off": three kinds of which one holds. It carries no unit: that
/// comes in limit(), where the stresses of the material are known. Multiples are > 0; take() sees
/// to that, times() does not.
class Threshold {
 public:
  /// No limit: what it would switch on never happens. The word is "none".
  static Threshold off() { return Threshold(Kind::Off, 0.0); }
  /// A multiple of the unit of limit().
  /// \param factor  [-], > 0
  static Threshold times(double factor) { return Threshold(Kind::Factor, factor); }
  /// The stress of the material that a keyword names, such as its elastic limit.
  static Threshold ofMaterial() { return Threshold(Kind::OfMaterial, 0.0); }

  /// Whether there is no limit.
  bool isOff() const { return kind_ == Kind::Off; }
  /// Whether the limit is the named stress of the material.
  bool isOfMaterial() const { return kind_ == Kind::OfMaterial; }

  /// The number [-] of a multiple.
  /// \throw std::logic_error  it is no multiple: it is off, or the named stress
  double factor() const;

  /// The limit in numbers, for comparisons; infinity, which nothing reaches, where it is off, so
  /// that inner loops need no branch for it.
  /// \param unit        what it is a multiple of, for most keywords the strength sigma_0 [stress],
  ///                    > 0
  /// \param ofMaterial  the named stress [stress]; not used by a threshold that has none
  /// \return the limit in the dimension of unit
  double limit(double unit, double ofMaterial = 0.0) const;

  /// Equal in kind and number; numbers are compared exactly, so that a limit that was written by
  /// word() and read by take() is equal to the first one.
  bool operator==(const Threshold &o) const { return kind_ == o.kind_ && factor_ == o.factor_; }
  bool operator!=(const Threshold &o) const { return !(*this == o); }

  /// As a word that take() reads back to the last bit: "none", the name, or the shortest decimal
  /// number.
  /// \param name  of the material's stress; nullptr: it takes none
  std::string word(const char *name) const;
  /// Reads "none", the name, or a plain number: digits with point and exponent, the whole word; no
  /// inf, no nan, no expression.
  /// \param name  as in word()
  /// \return false if the word is none of these or its number is not > 0; nothing changes then
  bool take(const std::string &word, const char *name);
  /// What take() takes, for messages: "a multiple of the strength > 0, NAME, none".
  /// \param number  what a number is and has to be, in words
  static std::string allowed(const char *name, const char *number);

 private:
  /// What factor_ means: it is 0 unless the kind is Factor.
  enum class Kind { Off, Factor, OfMaterial };
  /// \param factor  0 unless the kind is Factor
  Threshold(Kind kind, double factor) : kind_(kind), factor_(factor) {}

  Kind kind_;
  double factor_;
};

/// A law that is one number >= 0, 0 where it does not act. Keyword and what is allowed come from
/// the base. \tparam Words  has `keyword` and `range`, the allowed values in words
template<class Words>
class Coefficient : public Words {
 public:
  /// [-], >= 0.
  double value() const { return value_; }
  bool isOff() const { return value_ == 0.0; }
  /// The shortest decimal number that take() reads back to the last bit.
  std::string word() const { return mcawr::numberWord(value_, 17); }
  /// Reads a plain number >= 0.
  /// \return false for any other word; nothing changes then
  bool take(const std::string &word)
  {
    const auto number = mcawr::plainNumber(word);
    if (!number || *number < 0.0)
      return false;
    value_ = *number;
    return true;
  }
  /// What take() takes, for messages.
  static std::string allowed() { return Words::range; }
  /// It takes no word beside the number.
  static std::vector<std::string> words() { return {}; }
  /// It acts in the plane and in space.
  bool actsIn(int /*dimension*/) const { return true; }

 private:
  double value_ = 0.0;
};

/// What the number of most thresholds is.
struct OfStrength {
  static constexpr const char *number = "a multiple of the strength > 0";
};

/// A law that is one threshold. Keyword, material stress and default come from the base.
/// \tparam Words  has `keyword`, `materialStress` (the name of a stress or strain of the material,
///                or nullptr), `number` (what a number is, in words) and `initial()`, its default
template<class Words>
class ThresholdLaw : public Words {
 public:
  /// The limit as it was given; Threshold::limit() makes a stress of it.
  const Threshold &threshold() const { return threshold_; }
  /// Whether what this law would do never happens.
  bool isOff() const { return threshold_.isOff(); }
  /// Its value as a word that take() reads back exactly; see Threshold::word().
  std::string word() const { return threshold_.word(Words::materialStress); }
  /// Reads a value; see Threshold::take().
  /// \return false for a bad word; nothing changes then
  bool take(const std::string &word) { return threshold_.take(word, Words::materialStress); }
  /// What take() takes, for messages.
  static std::string allowed() { return Threshold::allowed(Words::materialStress, Words::number); }

  /// All words beside the number.
  static std::vector<std::string> words()
  {
    std::vector<std::string> all = {"none"};
    if constexpr (Words::materialStress != nullptr)
      all.emplace(all.begin(), Words::materialStress);
    return all;
  }

  /// Thresholds act in the plane and in space.
  bool actsIn(int /*dimension*/) const { return true; }

  /// For presets and tests: sets the limit without a word, also one that take() would refuse.
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
