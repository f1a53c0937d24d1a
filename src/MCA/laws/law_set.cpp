// SPDX-License-Identifier: GPL-2.0-or-later
#include "law_set.h"

#include "shared/nearest_word.h"

#include <algorithm>
#include <functional>

namespace mca {

namespace {

// A keyword with the functions that read and write its value in a LawSet.
struct Entry {
  LawSet::Keyword keyword;
  std::function<bool(LawSet &, const std::string &)> take;
  std::function<std::string(const LawSet &)> word;
};

template<class Words>
constexpr bool takesNumber(const ThresholdLaw<Words> &)
{
  return true;
}

template<class Words>
constexpr bool takesNumber(const Coefficient<Words> &)
{
  return true;
}

template<class Law>
constexpr bool takesNumber(const Law &)
{
  return false;
}

// the law of type L in a set
template<class L, class Set>
auto &lawOf(Set &set)
{
  using Pointer = std::conditional_t<std::is_const_v<Set>, const L *, L *>;
  Pointer found = nullptr;
  LawSet::eachLaw(set, [&](auto &law) {
    if constexpr (std::is_same_v<std::decay_t<decltype(law)>, L>)
      found = &law;
  });
  return *found;
}

std::vector<Entry> makeTable()
{
  std::vector<Entry> all;
  LawSet set;
  LawSet::eachLaw(set, [&](auto &law) {
    using L = std::decay_t<decltype(law)>;
    all.push_back({{L::keyword, L::words(), takesNumber(law), L::allowed()},
                   [](LawSet &s, const std::string &word) { return lawOf<L>(s).take(word); },
                   [](const LawSet &s) { return lawOf<L>(s).word(); }});
  });
  for (int k = 0; k < FractureCriteria::size; k++)
    if (const char *name = FractureLaw::criteria()[k].parameter;
        name && FractureLaw::keeperOf(k) == k)
      all.push_back(
          {{name, {"none"}, true, Threshold::allowed(nullptr, OfStrength::number)},
           [k](LawSet &s, const std::string &word) { return s.fracture.takeParameter(k, word); },
           [k](const LawSet &s) { return s.fracture.parameterWord(k); }});
  return all;
}

const std::vector<Entry> &table()
{
  static const std::vector<Entry> entries = makeTable();
  return entries;
}

const LawSet::Keyword presets = {"preset", {"a", "b", "c", "d"}, false, "a, b, c, d"};

// what does not go together
std::string conflictIn(const LawSet &s)
{
  if (!s.heal.isOff() && s.weld.isOff())
    return "keyword heal needs welds: give weld a value, or heal none";
  if (!s.healedStrain.isOff() && s.heal.isOff())
    return "keyword healed_strain needs healing: give heal a value";
  if (s.plane.is(PlaneCondition::Stress) && s.flows())
    return "keyword plane, value stress, needs plasticity none: the return of plasticity " +
           s.plasticity.word() + " is that of plane strain";
  return s.fracture.problem();
}

} // namespace

std::vector<LawSet::Keyword> LawSet::keywords()
{
  std::vector<Keyword> all = {presets};
  for (const Entry &e : table())
    all.push_back(e.keyword);
  return all;
}

LawSet LawSet::named(const std::string &preset)
{
  LawSet set;
  set.preset = preset;
  if (preset != "d")
    set.plasticity = "radial";
  if (preset == "a" || preset == "b") {
    set.flow = "links";
    set.viscosity = "normal";
    set.weld = Threshold::times(1.0);
  }
  if (preset == "a") {
    set.link = Threshold::times(2.35);
    set.weld = Threshold::off();
    set.heal = Threshold::off();
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
    if (keyword == presets.name) {
      if (std::find(presets.words.begin(), presets.words.end(), value) == presets.words.end())
        return bad(presets.allowed);
      *this = named(value);
      continue;
    }
    const auto entry = std::find_if(table().begin(), table().end(),
                                    [&](const Entry &e) { return keyword == e.keyword.name; });
    if (entry == table().end()) {
      std::vector<std::string> known = {"thickness", "cutoff", presets.name};
      for (const Entry &e : table())
        known.push_back(e.keyword.name);
      return mcawr::unknownWord("keyword", keyword, known);
    }
    if (!entry->take(*this, value))
      return bad(entry->keyword.allowed);
  }
  return conflictIn(*this);
}

std::vector<std::string> LawSet::words() const
{
  std::vector<std::string> all = {presets.name, preset};
  const auto isUsual = [&](const std::string &name) { // logs and restart files do not name it
    return (name == WornRule::keyword && worn.is(WornRule::Unloaded)) ||
           (name == HealedStrainLaw::keyword && healedStrain.isOff()) ||
           (name == ContactFrictionLaw::keyword && friction.isOff()) ||
           (name == FlowLaw::keyword && flow.is(FlowLaw::Links) &&
            named(preset).flow.is(FlowLaw::Links));
  };
  for (const Entry &e : table())
    if (!isUsual(e.keyword.name))
      all.insert(all.end(), {e.keyword.name, e.word(*this)});
  return all;
}

std::string LawSet::notInDimension(int dimension) const
{
  std::string first;
  eachLaw(*this, [&](const auto &law) {
    if (first.empty() && !law.actsIn(dimension))
      first = std::string(law.keyword) + " " + law.word();
  });
  return first;
}

ElasticModuli elasticModuli(const LawSet &set, const Material &m)
{
  const bool stress = set.plane.is(PlaneCondition::Stress);
  if (set.elasticity.is(Elasticity::Pairwise)) // the law of a solid whose Lame constant is 0
    return {m.shearModulus(), stress ? 2.0 / 3.0 * m.shearModulus() : m.bulkModulus(), 0.0};
  return (stress ? planeStressModuli : planeStrainModuli)(m.shearModulus(), m.bulkModulus());
}

AutomatonLaw makeAutomatonLaw(const LawSet &set, const Material &m, const Packing &packing)
{
  const ElasticModuli moduli = elasticModuli(set, m);
  AutomatonLaw law(m);
  law.bulkModulus = moduli.bulk;
  law.shearModulus = moduli.shear;
  law.D = moduli.D;
  law.yields = set.flows() ? 1.0 : 0.0;
  law.mostReturn =
      set.keepsVolume() ? mostReturn(moduli.shear, moduli.bulk, moduli.D, packing.dimension) : 1.0;
  law.weight = packing.stressWeight();
  return law;
}

// plastic work per volume up to the strength [stress]
static double workToStrength(const Material &m)
{
  return YieldCurve(m).work(m.plasticStrainUltimate());
}

static LinkLimits makeLinkLimits(const LawSet &usual, const Material &ofI, const Material &ofJ,
                                 int dimension, const Interface &interface)
{
  LawSet set = usual;
  set.parse(interface.links); // what is wrong was refused
  const Material i = interface.material(ofI), j = interface.material(ofJ);
  const LinkMaterials materials = {i,         j,  elasticModuli(set, i), elasticModuli(set, j),
                                   dimension, 1.0};
  const double strength = materials.strength();
  const double weld = set.weld.threshold().limit(strength, WeldLaw::stress(i, j));
  LinkLimits limits;
  limits.fracture = set.fracture.limits(materials);
  limits.criterion = set.fracture.number();
  limits.weldIntensity2 = weld * weld;
  limits.linkPressure = set.link.threshold().limit(strength, LinkLaw::stress(i, j));
  limits.healPressure = set.heal.threshold().limit(strength, HealLaw::stress(i, j));
  limits.healedKind = set.healedStrain.isOff() ? link::bulk : link::healed;
  const double healed = set.healedStrain.threshold().limit(1.0, HealedStrainLaw::strain(i, j));
  limits.healedIntensity2 = healed * healed;
  limits.linkedKind = set.weld.isOff() ? link::bulk : link::weld;
  limits.unloads = set.worn.is(WornRule::Unloaded) ? 1.0 : 0.0;
  limits.breakingStrain = std::max({ofI.breakingStrain, ofJ.breakingStrain, i.breakingStrain});
  limits.countsWork = set.linkWork.isOff() ? 0.0 : 1.0;
  limits.linkWork =
      set.linkWork.threshold().limit(std::min(workToStrength(ofI), workToStrength(ofJ)));
  return limits;
}

double contactViscosity(const LawSet &set, const Material &i, const Material &j,
                        const Interface &interface)
{
  return set.isViscous() ? interface.viscosity.value_or(0.5 * (i.viscosity + j.viscosity)) : 0.0;
}

PairLaw makePairLaw(const LawSet &set, const Material &i, const Material &j, double thickness,
                    const Packing &packing, const Interface &interface)
{
  const double diameter = 0.5 * (i.diameter + j.diameter);
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
  const bool keeps = set.keepsVolume();
  const ElasticModuli a = elasticModuli(set, i), b = elasticModuli(set, j);
  law.contactsFlow = !set.flow.is(FlowLaw::Contacts) ? 0.0
                     : keeps                         ? law.twoG / std::max(i.sigmaY1(), j.sigmaY1())
                                                     : 1e300;
  law.keepsEnergy = keeps ? 1.0 : 0.0;
  law.mostStretch = std::min(mostStretch(a.shear, a.bulk, a.D, packing.dimension),
                             mostStretch(b.shear, b.bulk, b.D, packing.dimension));
  law.viscosity = contactViscosity(set, i, j, interface);
  law.friction = interface.friction.value_or(set.friction.value());
  law.invMassI = 1.0 / Cell{packing, i.diameter, thickness}.mass(i.density);
  law.invMassJ = 1.0 / Cell{packing, j.diameter, thickness}.mass(j.density);
  law.invInertiaI = 1.0 / Cell{packing, i.diameter, thickness}.inertia(i.density);
  law.invInertiaJ = 1.0 / Cell{packing, j.diameter, thickness}.inertia(j.density);
  law.centring = set.resistsSlip() ? centredSlipShare / packing.ownSlipShare() : 1.0;
  law.limits = makeLinkLimits(set, i, j, packing.dimension, interface);
  return law;
}

} // namespace mca
