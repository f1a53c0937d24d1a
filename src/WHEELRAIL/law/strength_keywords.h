// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_LAW_STRENGTH_KEYWORDS_H
#define WHEELRAIL_LAW_STRENGTH_KEYWORDS_H

#include "law/law_choice.h"
#include "law/strength.h"

#include <vector>

namespace wheelrail {

/// The keywords of `Strength`, for laws that depend on it.
inline std::vector<LawKeyword> strengthKeywords()
{
  using Kind = LawKeyword::Kind;
  return {{"friction.strength", Kind::Quantity, "Pa", "1000 MPa", 1, 1e15,
           "sigma_0 of Eq. 10 at no temperature rise"},
          {"friction.strength_temperature", Kind::Quantity, "K", "1250 K", 1e-3, 1e9,
           "temperature rise at which Eq. 10 has no strength left"}};
}

/// The strength of a law that lists these keywords.
inline Strength strengthFrom(const LawValues &values)
{
  return {values["friction.strength"], values["friction.strength_temperature"], nullptr};
}

} // namespace wheelrail
#endif
