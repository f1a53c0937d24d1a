// SPDX-License-Identifier: GPL-2.0-or-later
#include "energy_account.h"

#include "laws/pair_motion.h"

#include <algorithm>
#include <cmath>

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

EnergyAccount::Channel EnergyAccount::pay(const Step &step, int k, double loss, double *sums)
{
  const Channel channel = channelOf(step, k);
  sums[channel] += loss;
  if (channel == Plastic && !link::isLinked(step.links().pairs().now.kind[k]))
    sums[ContactFlow] += loss;
  return channel;
}

// Whether what pair k holds, of what its energy knows, is another one in the next state.
static bool changesState(const Pairs &p, int k, int shears)
{
  if (!p.blocks[k / blockLength].moves)
    return false;
  bool same = p.now.kind[k] == p.next.kind[k] && p.now.plastic[k] == p.next.plastic[k];
  for (int m = 0; m < shears; m++)
    same = same && p.now.gamma[m][k] == p.next.gamma[m][k];
  return !same;
}

static int shearsOf(const Step &step)
{
  return step.dimension() == 2 ? 1 : maxShears;
}

void EnergyAccount::keep(const Step &step, const double (*x)[3], const double (*f)[3],
                         const double (*torque)[3], const Edges &box)
{
  box_ = box;
  rows_.resize(step.rows());
  const RowView rows = step.view();
  external_.clear();
  for (int i = 0; i < step.own(); i++) {
    const Motion outer = {vectorOf(f[i]) - rows.force(i), vectorOf(torque[i]) - rows.torque(i)};
    if (dot(outer.way, outer.way) + dot(outer.turn, outer.turn) != 0.0)
      external_.push_back({i, outer});
    store(vectorOf(x[i]), rows_.row(i) + placeAt);
    store(rows.velocity(i), rows_.row(i) + velocityAt);
  }
  findNextMeans(step);
  step.exchange().begin(rows_.data() + meanAt, rowLength, rowLength - meanAt);
  step.exchange().finish(rows_.data() + meanAt, rowLength, rowLength - meanAt);
  findActive(step);
  findReleased(step);
}

// An automaton of whose contacts none changes keeps its mean stress, to the last bit.
void EnergyAccount::findNextMeans(const Step &step)
{
  const Pairs &p = step.links().pairs();
  const RowView rows = step.view();
  const int own = step.own(), shears = shearsOf(step);
  changing_.clear();
  touched_.assign(step.rows(), false);
  for (int first = 0; first < p.n; first += blockLength)
    if (p.blocks[first / blockLength].moves)
      for (int k = first; k < std::min(first + blockLength, p.n); k++)
        if (changesState(p, k, shears)) {
          changing_.push_back(k);
          touched_[p.i[k]] = touched_[p.j[k]] = true;
        }
  for (int i = 0; i < own; i++) {
    touched_[i] = touched_[i] || step.kept(i) != step.keptNext(i);
    rows_.row(i)[meanAt] = touched_[i] ? 0.0 : rows.answer(i).mean;
  }
  for (int k = 0; k < p.n; k++)
    if (touched_[p.i[k]] | touched_[p.j[k]]) { // seldom: one branch, not two
      const double e = strainOf(step, k, true).normal;
      for (const int i : {p.i[k], p.j[k]})
        if (touched_[i])
          rows_.row(i)[meanAt] += e;
    }
  for (int i = 0; i < own; i++)
    if (touched_[i]) {
      const AutomatonLaw &law = step.laws().automata[step.type(i)];
      double &mean = rows_.row(i)[meanAt];
      mean = meanStress(mean + step.keptNext(i), law.bulkModulus, law.weight);
    }
}

// Links that stay as they are, between automata whose mean stresses do, dissipate nothing: their
// force is the gradient of their energy.
void EnergyAccount::findActive(const Step &step)
{
  const Pairs &p = step.links().pairs();
  const RowView rows = step.view();
  for (int i = 0; i < rows_.rows(); i++)
    touched_[i] = rows_.row(i)[meanAt] != rows.answer(i).mean;
  active_.clear();
  auto changes = changing_.begin();
  for (int k = 0; k < p.n; k++) {
    const bool changed = changes != changing_.end() && *changes == k;
    changes += changed ? 1 : 0;
    const bool touched = touched_[p.i[k]] | touched_[p.j[k]];
    if (changed | touched | !link::isLinked(p.now.kind[k]))
      active_.push_back(k);
  }
}

void EnergyAccount::findReleased(const Step &step)
{
  std::fill_n(released_, Channels, 0.0);
  const Pairs &p = step.links().pairs();
  for (const int k : changing_) {
    const int i = p.i[k], j = p.j[k];
    const double means[2] = {step.mean(i), step.mean(j)};
    const double next[2] = {rows_.row(i)[meanAt], rows_.row(j)[meanAt]};
    const PairLaw &law = step.law(k);
    const ElasticStrain before = strainOf(step, k, false), after = strainOf(step, k, true);
    const double volume = law.area * law.diameter * step.share(k);
    const double loss = changeLoss(law, before, after, means, next) * volume;
    if (pay(step, k, loss, released_) == Fracture && law.keepsEnergy > 0.0) {
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
    if (step.kept(i) == step.keptNext(i))
      continue;
    const AutomatonLaw &law = step.laws().automata[step.type(i)];
    const double mean = 0.5 * (step.mean(i) + rows_.row(i)[meanAt]);
    released_[Fracture] += mean * law.D * law.weight * (step.kept(i) - step.keptNext(i)) *
                           step.laws().volumes[step.type(i)];
  }
}

double EnergyAccount::released() const
{
  double sum = 0.0;
  for (int m = 0; m < Channels; m++)
    sum += leaves(m) * released_[m];
  return sum;
}

void EnergyAccount::bookSecondHalf(const Step &step, double dt)
{
  for (const External &on : external_)
    bookWork(on, {dt * step.velocity(on.row), dt * step.spin(on.row)});
  bookContacts(step, dt, true);
  for (int m = 0; m < Channels; m++)
    sums_[m] += released_[m];
}

void EnergyAccount::bookWork(const External &on, const Motion &moved)
{
  sums_[Work] += 0.5 * (dot(on.forces.way, moved.way) + dot(on.forces.turn, moved.turn));
}

void EnergyAccount::bookFirstHalf(const Step &step, const double (*x)[3], const double (*omega)[3],
                                  double dt, const Edges &box)
{
  for (int m = 0; m < 6; m++)
    growth_.h[m] = box.h[m] - box_.h[m];
  for (int i = 0; i < step.own(); i++) {
    double *const row = rows_.row(i);
    store(vectorOf(x[i]) - vectorOf(row + placeAt), row + wayAt);
    store(dt * vectorOf(omega[i]), row + turnAt);
  }
  for (const External &on : external_) {
    const double *const row = rows_.row(on.row);
    bookWork(on, {vectorOf(row + wayAt), vectorOf(row + turnAt)});
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
// of the coming one. Where the box grows, all contacts over its faces work on it.
void EnergyAccount::bookContacts(const Step &step, double dt, bool back)
{
  const bool grows =
      std::any_of(growth_.h, growth_.h + 6, [](double length) { return length != 0.0; });
  if (!grows)
    for (const int k : active_)
      bookContact(step, k, dt, back, false);
  else
    for (int k = 0; k < step.links().size(); k++)
      bookContact(step, k, dt, back, true);
}

// Whether pair k is unlinked and apart at both ends of a way, as far as a bound tells that takes no
// strain: along the way eps changes by at most twice its length over the distance.
static bool staysApart(const Step &step, int k, const Vector &way)
{
  const Pairs &p = step.links().pairs();
  const bool moves = p.blocks[k / blockLength].moves;
  const double kind = p.now.kind[k], kindNext = moves ? p.next.kind[k] : kind;
  if (link::isLinked(kind) || link::isLinked(kindNext))
    return false;
  const double plastic = p.now.plastic[k], next = moves ? p.next.plastic[k] : plastic;
  const double gap = p.eps[k] - std::max(plastic, next);
  const double most = std::abs(way.x) + std::abs(way.y) + std::abs(way.z);
  return gap > 2.0 * most * step.law(k).invDiameter / std::min(p.ratio[k], 1.0);
}

// The evaluation knows one end of either step; `sign` looks from there to the other one.
void EnergyAccount::bookContact(const Step &step, int k, double dt, bool back, bool grows)
{
  const Pairs &p = step.links().pairs();
  const RowView rows = step.view();
  const double sign = back ? 1.0 : -1.0;
  const int i = p.i[k], j = p.j[k];
  const double *const rowI = rows_.row(i), *const rowJ = rows_.row(j);
  const int wayFrom = back ? velocityAt : wayAt;
  const double scale = back ? dt : 1.0;
  const Vector ofBox = grows ? wayOfBox(step, k) : Vector{0.0, 0.0, 0.0};
  const Vector apart = scale * vectorOf(rowJ + wayFrom) - scale * vectorOf(rowI + wayFrom) + ofBox;
  const bool rubs = !step.links().springs().empty();
  if (!rubs && !grows && staysApart(step, k, apart))
    return;
  const Vector distance = rows.place(p.placeJ[k]) - rows.place(p.placeI[k]);
  const Vector way = sign * apart;
  const PairLaw &law = step.law(k);
  const double other =
      normalStrain(step.laws().keepsVolume, length(distance - way) * law.invDiameter);

  double state[LinkList::maxStateSize];
  step.links().getState(k, !back, state);
  const bool linked = link::isLinked(state[0]);
  const ElasticStrain here = strainOf(step, k, !back);
  const double there = touchingStrain(linked, other - state[1]);
  const bool isApart = here.normal == 0.0 && strainOf(step, k, back).normal == 0.0;
  if (!linked && !isSheared(step, k) && isApart && there == 0.0 && !rubs && !grows)
    return; // apart at both ends
  const Vector turns = back ? dt * rows.spin(i) + dt * rows.spin(j)
                            : vectorOf(rowI + turnAt) + vectorOf(rowJ + turnAt);
  const PairMotion motion = pairMotion(distance, 1.0 / length(distance), way, 0.5 * sign * turns);
  const double growth = sign * dot(shearGrowth(motion), step.alongShear(k, 1.0));
  const double closer = sign * (here.normal - there);
  const ElasticStrain total = {sign * (p.eps[k] - other), growth};
  const ElasticStrain elastic = {closer, linked && isSheared(step, k) ? growth : 0.0};
  const double means[2] = {back ? rows.answer(i).mean : rowI[meanAt],
                           back ? rows.answer(j).mean : rowJ[meanAt]};
  const ContactStress s = step.contact(k);
  const double volume = law.area * law.diameter * step.share(k);
  // the force against lack of room is a gradient by itself
  auto lossOf = [&](const ElasticStrain &change, const ElasticStrain &strained) {
    return volume *
           stepLoss(law, s.normal - s.room - s.viscous, s.shear, here, means, change, strained);
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
    const Vector slip = slipOf(step.normal(k), apart, turns, arm);
    const double bySlip = slipLoss(law, step.slipStress(k), slip);
    viscous += bySlip;
    sums_[Slip] += bySlip * volume;
  }
  pay(step, k, loss, sums_);
  sums_[Viscous] += viscous * volume;
  if (back && rubs)
    bookFriction(step, k, shearGrowth(motion), volume);
  if (grows)
    sums_[Box] += 0.5 * dot(step.contactForce(k), ofBox) * step.share(k);
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
  return rows_.bytes() +
         static_cast<double>(external_.capacity() * sizeof(External) +
                             (changing_.capacity() + active_.capacity()) * sizeof(int) +
                             touched_.capacity());
}

} // namespace mca
