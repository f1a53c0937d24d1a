// SPDX-License-Identifier: GPL-2.0-or-later
#include "energy_account.h"

#include "laws/pair_motion.h"

#include <algorithm>
#include <numeric>

namespace mca {

static void store(const Vector &v, double *values)
{
  values[0] = v.x;
  values[1] = v.y;
  values[2] = v.z;
}

static bool isSheared(const Step &step, int k)
{
  return link::isLinked(step.links().pairs().now.kind[k]);
}

// Elastic strains of pair k in the present or the next state at the present place. Shears are those
// of present links: what friction leaves to a new one is booked with it.
static ElasticStrain strainOf(const Step &step, int k, bool next)
{
  double state[LinkList::maxStateSize];
  step.links().getState(k, next, state);
  const bool linked = link::isLinked(state[0]);
  const double e = step.links().pairs().eps[k] - state[1];
  const double shear = step.dimension() == 2 ? state[2] : length(vectorOf(state + 2));
  return {touchingStrain(linked, e), isSheared(step, k) && linked ? shear : 0.0};
}

// What of pair k's spring of friction sliding sets free in the evaluation [stress].
static double slidingLoss(const Step &step, int k)
{
  const Vector now = step.frictionShear(k, false), next = step.frictionShear(k, true);
  return 0.5 * step.law(k).twoG * (dot(now, now) - dot(next, next));
}

// What pair k flows along its normal in the evaluation [-].
static double lastFlow(const Step &step, int k)
{
  double now[LinkList::maxStateSize], next[LinkList::maxStateSize];
  step.links().getState(k, false, now);
  step.links().getState(k, true, next);
  return next[1] - now[1];
}

// Where the energy goes that pair k dissipates as it moves.
static EnergyAccount::Channel channelOf(const Step &step, int k)
{
  double now[LinkList::maxStateSize], next[LinkList::maxStateSize];
  step.links().getState(k, false, now);
  step.links().getState(k, true, next);
  const bool was = link::isLinked(now[0]), is = link::isLinked(next[0]);
  return was && !is                              ? EnergyAccount::Fracture
         : was || step.law(k).contactsFlow > 0.0 ? EnergyAccount::Plastic
                                                 : EnergyAccount::Viscous;
}

void EnergyAccount::keep(const Step &step, const double (*x)[3], const double (*f)[3],
                         const double (*torque)[3], const Edges &box)
{
  box_ = box;
  rows_.resize(step.rows());
  rows_.clear();
  const Pairs &p = step.links().pairs();
  for (int k = 0; k < p.n; k++) {
    const double e = strainOf(step, k, true).normal;
    rows_.row(p.i[k])[meanAt] += e;
    rows_.row(p.j[k])[meanAt] += e;
  }
  const int own = step.own();
  external_.resize(own);
  for (int i = 0; i < own; i++) {
    const AutomatonLaw &law = step.laws().automata[step.type(i)];
    external_[i] = {vectorOf(f[i]) - step.force(i), vectorOf(torque[i]) - step.torque(i)};
    store(vectorOf(x[i]), rows_.row(i) + placeAt);
    store(step.velocity(i), rows_.row(i) + velocityAt);
    double &mean = rows_.row(i)[meanAt];
    mean = meanStress(mean + step.keptNext(i), law.bulkModulus, law.weight);
  }
  step.exchange().begin(rows_.data() + meanAt, rowLength, rowLength - meanAt);
  step.exchange().finish(rows_.data() + meanAt, rowLength, rowLength - meanAt);
  findReleased(step);
}

void EnergyAccount::findReleased(const Step &step)
{
  std::fill_n(released_, Channels, 0.0);
  const Pairs &p = step.links().pairs();
  for (int k = 0; k < p.n; k++) {
    if (!p.blocks[k / blockLength].moves)
      continue; // both states are the same
    const int i = p.i[k], j = p.j[k];
    const double means[2] = {step.mean(i), step.mean(j)};
    const double next[2] = {rows_.row(i)[meanAt], rows_.row(j)[meanAt]};
    const PairLaw &law = step.law(k);
    const Channel channel = channelOf(step, k);
    const ElasticStrain before = strainOf(step, k, false), after = strainOf(step, k, true);
    const double volume = law.area * law.diameter * step.share(k);
    released_[channel] += changeLoss(law, before, after, means, next) * volume;
    if (channel == Fracture && law.keepsEnergy > 0.0) {
      // a link that breaks as it flows: only with what its automata's other links flow does the
      // latter dissipate
      const double flow = lastFlow(step, k);
      const double plastic = meanGradient(law, before, after, means, next) * flow * volume;
      released_[Plastic] += plastic;
      released_[Fracture] -= plastic;
    }
  }
  for (const LinkList::Spring &s : step.links().springs()) {
    const PairLaw &law = step.law(s.pair);
    released_[Friction] += slidingLoss(step, s.pair) * law.area * law.diameter * step.share(s.pair);
  }
  // what broken links left to the mean stresses, and what of it is let go of
  for (int i = 0; i < step.own(); i++) {
    const AutomatonLaw &law = step.laws().automata[step.type(i)];
    const double mean = 0.5 * (step.mean(i) + rows_.row(i)[meanAt]);
    released_[Fracture] += mean * law.D * law.weight * (step.kept(i) - step.keptNext(i)) *
                           step.laws().volumes[step.type(i)];
  }
}

double EnergyAccount::released() const
{
  return std::accumulate(released_, released_ + Channels, 0.0);
}

void EnergyAccount::bookWork(int i, const Motion &moved)
{
  sums_[Work] += 0.5 * (dot(external_[i].way, moved.way) + dot(external_[i].turn, moved.turn));
}

void EnergyAccount::bookSecondHalf(const Step &step, double dt)
{
  for (int i = 0; i < step.own(); i++)
    bookWork(i, {dt * step.velocity(i), dt * step.spin(i)});
  bookContacts(step, dt, true);
  for (int m = 0; m < Channels; m++)
    sums_[m] += released_[m];
}

void EnergyAccount::bookFirstHalf(const Step &step, const double (*x)[3], const double (*omega)[3],
                                  double dt, const Edges &box)
{
  for (int m = 0; m < 6; m++)
    growth_.h[m] = box.h[m] - box_.h[m];
  for (int i = 0; i < step.own(); i++) {
    const Motion moved = {vectorOf(x[i]) - vectorOf(rows_.row(i) + placeAt),
                          dt * vectorOf(omega[i])};
    store(moved.way, rows_.row(i) + wayAt);
    store(moved.turn, rows_.row(i) + turnAt);
    bookWork(i, moved);
  }
  step.exchange().begin(rows_.data(), rowLength, meanAt);
  step.exchange().finish(rows_.data(), rowLength, meanAt);
  bookContacts(step, dt, false);
}

// An image stands off its automaton by a vector of the lattice, which the box makes grow.
Vector EnergyAccount::wayOfBox(const Step &step, int k) const
{
  const Pairs &p = step.links().pairs();
  auto off = [&](int place, int i) { return step.place(place) - vectorOf(rows_.row(i) + placeAt); };
  const Vector lattice = off(p.placeJ[k], p.j[k]) - off(p.placeI[k], p.i[k]);
  const double *const h = box_.h, *const g = growth_.h;
  const double nz = lattice.z / h[2], ny = (lattice.y - h[3] * nz) / h[1];
  const double nx = (lattice.x - h[4] * nz - h[5] * ny) / h[0];
  return {g[0] * nx + g[5] * ny + g[4] * nz, g[1] * ny + g[3] * nz, g[2] * nz};
}

// What the contacts dissipate in the second half of the step just done (back), or in the first half
// of the coming one. Of either step the evaluation knows one end; `sign` looks from there to the
// other one.
void EnergyAccount::bookContacts(const Step &step, double dt, bool back)
{
  const Pairs &p = step.links().pairs();
  const double sign = back ? 1.0 : -1.0;
  auto moved = [&](int i) {
    const double *row = rows_.row(i);
    return back ? Motion{dt * vectorOf(row + velocityAt), dt * step.spin(i)}
                : Motion{vectorOf(row + wayAt), vectorOf(row + turnAt)};
  };
  const bool grows =
      std::any_of(growth_.h, growth_.h + 6, [](double length) { return length != 0.0; });
  const bool rubs = !step.links().springs().empty();
  for (int k = 0; k < p.n; k++) {
    const int i = p.i[k], j = p.j[k];
    const PairLaw &law = step.law(k);
    const Motion mi = moved(i), mj = moved(j);
    const Vector ofBox = grows ? wayOfBox(step, k) : Vector{0.0, 0.0, 0.0};
    const Vector apart = mj.way - mi.way + ofBox;
    const Vector distance = step.place(p.placeJ[k]) - step.place(p.placeI[k]);
    const Vector way = sign * apart;
    const PairMotion motion =
        pairMotion(distance, 1.0 / length(distance), way, 0.5 * sign * (mi.turn + mj.turn));
    const double eps = p.eps[k];
    const double other =
        normalStrain(step.laws().keepsVolume, length(distance - way) * law.invDiameter);
    const double growth = sign * dot(shearGrowth(motion), step.alongShear(k, 1.0));

    double state[LinkList::maxStateSize];
    step.links().getState(k, !back, state);
    const bool linked = link::isLinked(state[0]);
    const ElasticStrain here = strainOf(step, k, !back);
    const double there = touchingStrain(linked, other - state[1]);
    const double closer = sign * (here.normal - there);
    const ElasticStrain total = {sign * (eps - other), growth};
    const ElasticStrain elastic = {closer, linked && isSheared(step, k) ? growth : 0.0};
    const double means[2] = {step.mean(i), step.mean(j)};
    const double next[2] = {rows_.row(i)[meanAt], rows_.row(j)[meanAt]};
    const ContactStress s = step.contact(k);
    const double volume = law.area * law.diameter * step.share(k);
    // the force against lack of room is a gradient by itself
    auto lossOf = [&](const ElasticStrain &change, const ElasticStrain &strained) {
      return volume * stepLoss(law, s.normal - s.room - s.viscous, s.shear, here,
                               back ? means : next, change, strained);
    };
    const double all = lossOf(total, elastic);
    double loss = all;
    // of a contact that touches or parts within the step only what its end that touches loses on
    // its way is dissipated
    if ((here.normal == 0.0) != (there == 0.0))
      loss = here.normal == 0.0 ? 0.0 : lossOf({closer, growth}, elastic);
    sums_[Touching] += all - loss;
    double viscous = 0.5 * s.viscous * total.normal;
    if (step.laws().resistsSlip) {
      const double arm = 0.5 * length(distance);
      const Vector slip = slipOf(step.normal(k), apart, mi.turn + mj.turn, arm);
      viscous += slipLoss(law, step.slipStress(k), slip);
    }
    sums_[channelOf(step, k)] += loss;
    sums_[Viscous] += viscous * volume;
    if (back && rubs)
      bookFriction(step, k, shearGrowth(motion), volume);
    if (grows)
      sums_[Box] += 0.5 * dot(step.contactForce(k), ofBox) * step.share(k);
  }
}

// The force is that of what the spring holds, while its energy grew with all of its motion; in the
// first half of a step both agree. What sliding sets free comes with the change of state.
void EnergyAccount::bookFriction(const Step &step, int k, const Vector &growth, double volume)
{
  const Vector slid = step.frictionShear(k, false) - step.frictionShear(k, true);
  const double loss = -0.5 * step.law(k).twoG * dot(slid, growth) * volume;
  const double all = loss + slidingLoss(step, k) * volume, back = all < 0.0 ? all : 0.0;
  sums_[Friction] += loss - back;
  sums_[Touching] += back;
}

double EnergyAccount::bytes() const
{
  return rows_.bytes() + static_cast<double>(external_.capacity() * sizeof(Motion));
}

} // namespace mca
