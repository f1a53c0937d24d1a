#include "law_set.h"

#include "shared/nearest_word.h"
#include "shared/plain_number.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace mca {

static std::string shortest(double value)
{
  if (value == LawSet::off)
    return "none";
  if (value == LawSet::atElasticLimit)
    return "elastic_limit";
  if (value == LawSet::atHardness)
    return "hardness";
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof(text), value).ptr);
}

namespace {
struct Choice {
  const char *keyword;
  std::string LawSet::*value;
  std::vector<std::string> allowed;
};
struct Threshold {
  const char *keyword;
  double LawSet::*value;
  std::string material; // word for a stress of the material, if the threshold takes one
  double materialValue;
};
const std::vector<Choice> &choices()
{
  static const std::vector<Choice> table = {
      {"plane", &LawSet::plane, {"strain", "stress"}},
      {"elasticity", &LawSet::elasticity, {"many-body", "pairwise"}},
      {"plasticity", &LawSet::plasticity, {"radial", "j2", "none"}},
      {"fracture", &LawSet::fracture, {"strain", "stress", "equivalent", "drucker-prager", "none"}},
      {"viscosity", &LawSet::viscosity, {"normal", "none"}},
      {"steps", &LawSet::steps, {"corrected", "plain"}},
  };
  return table;
}
const std::vector<Threshold> &thresholds()
{
  static const std::vector<Threshold> table = {
      {"link", &LawSet::link, "elastic_limit", LawSet::atElasticLimit},
      {"weld", &LawSet::weld, "", 0.0},
      {"heal", &LawSet::heal, "hardness", LawSet::atHardness},
      {"link_work", &LawSet::link_work, "", 0.0},
      {"compressive_strength", &LawSet::compressive_strength, "", 0.0},
  };
  return table;
}
std::string joined(const std::vector<std::string> &words)
{
  std::string all;
  for (const auto &word : words)
    all += (all.empty() ? "" : ", ") + word;
  return all;
}
} // namespace

LawSet LawSet::named(const std::string &preset)
{
  LawSet set;
  set.preset = preset;
  if (preset == "a") {
    set.link = 2.35;
    set.weld = off;
    set.heal = off;
  }
  return set;
}

std::string LawSet::parse(const std::vector<std::string> &words)
{
  for (size_t k = 0; k < words.size(); k += 2) {
    const std::string &keyword = words[k];
    if (k + 1 == words.size())
      return "keyword " + keyword + " has no value";
    const std::string &value = words[k + 1];
    auto bad = [&](const std::string &allowed) {
      return "keyword " + keyword + ", value " + value + ", allowed: " + allowed;
    };
    if (keyword == "preset") {
      if (value != "a" && value != "b")
        return bad("a, b");
      *this = named(value);
      continue;
    }
    auto choice = std::find_if(choices().begin(), choices().end(),
                               [&](const Choice &c) { return keyword == c.keyword; });
    if (choice != choices().end()) {
      const auto &allowed = choice->allowed;
      if (std::find(allowed.begin(), allowed.end(), value) == allowed.end())
        return bad(joined(allowed));
      this->*choice->value = value;
      continue;
    }
    auto threshold = std::find_if(thresholds().begin(), thresholds().end(),
                                  [&](const Threshold &t) { return keyword == t.keyword; });
    if (threshold == thresholds().end()) {
      std::vector<std::string> known = {"thickness", "cutoff", "preset"};
      for (const auto &c : choices())
        known.push_back(c.keyword);
      for (const auto &t : thresholds())
        known.push_back(t.keyword);
      return mcawr::unknownWord("keyword", keyword, known);
    }
    const auto number = mcawr::plainNumber(value);
    if (value == "none")
      this->*threshold->value = off;
    else if (!value.empty() && value == threshold->material)
      this->*threshold->value = threshold->materialValue;
    else if (number && *number > 0.0)
      this->*threshold->value = *number;
    else
      return bad("a multiple of the strength > 0, " +
                 (threshold->material.empty() ? "" : threshold->material + ", ") + "none");
  }
  if (heal != off && weld == off)
    return "keyword heal needs welds: give weld a value";
  if (plane == "stress" && plasticity != "none")
    return "keyword plane, value stress, needs plasticity none: the return of plasticity " +
           plasticity + " is that of plane strain";
  if ((fracture == "drucker-prager") != (compressive_strength != off))
    return "keyword compressive_strength and fracture drucker-prager need each other";
  if (compressive_strength < 1.0)
    return "keyword compressive_strength, value " + shortest(compressive_strength) +
           ", allowed: a multiple of the strength >= 1";
  return "";
}

std::vector<std::string> LawSet::words() const
{
  std::vector<std::string> all = {"preset", preset};
  for (const auto &c : choices())
    all.insert(all.end(), {c.keyword, this->*c.value});
  for (const auto &t : thresholds())
    all.insert(all.end(), {t.keyword, shortest(this->*t.value)});
  return all;
}

bool LawSet::needsLocal() const
{
  return fracture == "equivalent" || fracture == "drucker-prager" || link_work != off;
}

ElasticModuli elasticModuli(const LawSet &set, const Material &m)
{
  const bool stress = set.plane == "stress";
  if (set.elasticity == "pairwise") // the law of a solid whose Lame constant is 0
    return {m.shearModulus(), stress ? 2.0 / 3.0 * m.shearModulus() : m.bulkModulus(), 0.0};
  return (stress ? planeStressModuli : planeStrainModuli)(m.shearModulus(), m.bulkModulus());
}

// plastic work per volume up to the strength [stress]
static double workToStrength(const Material &m)
{
  return YieldCurve(m).work(m.plasticStrainUltimate());
}

PairLaw makePairLaw(const LawSet &set, const Material &i, const Material &j, double thickness,
                    const Packing &packing)
{
  const double diameter = 0.5 * (i.diameter + j.diameter);
  const double weaker = std::min(i.strength, j.strength);
  const double strain = std::min(i.breaking_strain, j.breaking_strain);
  auto squared = [](double value) { return value * value; };
  PairLaw law;
  law.diameter = diameter;
  law.invDiameter = 1.0 / diameter;
  law.area = Cell{packing, diameter, thickness}.contactArea();
  law.twoGi = 2.0 * i.shearModulus();
  law.twoGj = 2.0 * j.shearModulus();
  law.twoG = 0.5 * (law.twoGi + law.twoGj);
  law.invTwoG = 1.0 / law.twoG;
  law.Di = elasticModuli(set, i).D;
  law.Dj = elasticModuli(set, j).D;
  law.viscosity = set.viscosity == "normal" ? 0.5 * (i.viscosity + j.viscosity) : 0.0;
  law.invMassI = 1.0 / Cell{packing, i.diameter, thickness}.mass(i.density);
  law.invMassJ = 1.0 / Cell{packing, j.diameter, thickness}.mass(j.density);
  law.limits.bulkStrain2 = set.fracture == "strain" ? squared(strain) : LawSet::off;
  law.limits.bulkIntensity2 = set.fracture == "stress" ? squared(weaker) : LawSet::off;
  law.limits.weldIntensity2 = squared(set.weld * weaker);
  law.limits.linkPressure =
      set.link == LawSet::atElasticLimit ? std::min(i.sigmaY1(), j.sigmaY1()) : set.link * weaker;
  law.limits.healPressure =
      set.heal == LawSet::atHardness ? 3.0 * std::min(i.sigmaY2(), j.sigmaY2()) : set.heal * weaker;
  law.limits.linkedKind = set.weld == LawSet::off ? link::bulk : link::weld;
  law.limits.bulkStress = set.fracture == "equivalent" ? druckerPrager(weaker, 1.0)
                          : set.fracture == "drucker-prager"
                              ? druckerPrager(weaker, set.compressive_strength)
                              : StressLimit{1.0, 0.0, LawSet::off};
  law.limits.linkWork = set.link_work * std::min(workToStrength(i), workToStrength(j));
  return law;
}

} // namespace mca
