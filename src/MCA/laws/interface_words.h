// SPDX-License-Identifier: GPL-2.0-or-later
/// \file interface_words.h
/// The words of pair_coeff I J interface, of the input script and of restart files.
#ifndef MCA_LAWS_INTERFACE_WORDS_H
#define MCA_LAWS_INTERFACE_WORDS_H

#include "interface.h"
#include "law_set.h"

#include <string>
#include <vector>

namespace mca {

/// Keywords and values of what is given, which readInterface() reads back exactly.
std::vector<std::string> wordsOf(const Interface &);

/// \param words  keyword, value, keyword, value, ...; a keyword may stand twice, the last one
///               counts
/// \param laws   of the pair style: links break by one criterion everywhere
/// \param interface  set as a whole, where nothing is wrong
/// \return empty, or one line: keyword, value, what is allowed
std::string readInterface(const std::vector<std::string> &words, const LawSet &laws,
                          Interface &interface);

/// Whether it fits these laws.
/// \return as readInterface()
std::string problemOf(const Interface &, const LawSet &laws);

} // namespace mca

#endif
