// SPDX-License-Identifier: GPL-2.0-or-later
// The sequence of passes. What a step answers afterwards stands in step_results.cpp.
#include "step.h"

#include "local_stress.h"

#include <algorithm>
#include <cstring>

namespace mca {

static Exchange nobody; // of a step that is alone

// Calls use(k) for the pairs of blocks in which one changes its kind.
template<class Use>
static void eachPairOfChangingBlocks(const Pairs &p, const Use &use)
{
  for (int first = 0, b = 0; first < p.n; first += blockLength, b++)
    if (p.blocks[b].changes)
      for (int k = first; k < std::min(first + blockLength, p.n); k++)
        use(k);
}

Step::Step(int dimension, const Kernel *kernel)
    : usual_(kernel ? kernel : &bestKernel(dimension)), kernel_(usual_), exchange_(&nobody),
      links_(dimension == 2 ? 1 : 3), motion_(layout().motion.length),
      strains_(layout().strain.length), response_(layout().response.length),
      sums_(layout().stress.length), taken_(layout().taken.length), local_(layout().local.length),
      linkChanges_(2)
{
}

void Step::setLaws(LawTables tables)
{
  laws_ = std::move(tables);
  kernel_ = laws_.keepsVolume ? usual_->keepsVolume : usual_;
  for (const auto &[of, length] :
       {std::pair(&strains_, layout().strain.length),
        std::pair(&response_, layout().response.length), std::pair(&sums_, layout().stress.length),
        std::pair(&taken_, layout().taken.length)})
    if (of->length() != length)
      *of = RowArray(length);
}

void Step::begin(int own, int all, const int *types, int border)
{
  begun_ = committed_ = true;
  changing_ = 0.0;
  types_.assign(types, types + own);
  border_ = std::min((border + blockLength - 1) / blockLength * blockLength, links_.size());
  const int summed = exchange_->alone() ? own : all; // images only give places
  for (RowArray *of : {&motion_, &spin_})
    of->resize(all);
  for (RowArray *of : {&strains_, &response_, &sums_})
    of->resize(summed);
  local_.resize(laws_.needsLocal ? summed : 0);
  taken_.resize(laws_.returnsTwice ? summed : 0);
  kappaNext_.resize(own);
  for (RowArray *of : {&kept_, &keptNext_})
    of->resize(laws_.keepsVolume ? own : 0);
  linkChanges_.resize(own);
  for (RowArray *of : {&kept_, &keptNext_, &linkChanges_})
    of->clear();
  spans_.begin(links_.part(0, links_.size()), own, summed);
  flows_.assign(spans_.size(), true); // guests always may
  crowded_.assign(spans_.size(), laws_.keepsVolume);
  keeps_.assign(spans_.own(), false);
}

// What other ranks need is on its way while the inside of the sample is worked on; the pairs at the
// borders, which need what the others answer, come last in a pass. They are the first of the list,
// rounded up to whole blocks, and all pairs of an automaton that a rank shares are among them: its
// sums are complete on its owner, so that no part of a sum goes between ranks. The strain
// pass needs no message: places and velocities of ghosts came with LAMMPS's own. Messages are: mean
// stresses; the returns, and once more where they are done twice; what criteria of local stress
// see; forces, where viscous contacts see the velocity of their step. All ranks have the same laws,
// so that all send the same ones.
void Step::run(const Automata &a, double dt, bool advance)
{
  if (advance) {
    commit(a);
    links_.advance();
  }
  committed_ = squaresKnown_ = false;

  const PairLaw *laws = laws_.pairs.data();
  const RowLayout::Response &row = layout().response;
  double *const response = response_.data(), *const answers = response + row.factor;
  const Pairs border = links_.part(0, border_);
  const Pairs inside = links_.part(border_, links_.size() - border_);
  packMotion(a, advance);

  strains_.clear();
  addKept(a.kept);
  kernel_->strain(links_.part(0, links_.size()), dt, advance, laws, motion_.data(), spin_.data(),
                  strains_.data());
  findMeans();
  exchange_->begin(response, row.length, row.means);

  sums_.clear();
  kernel_->stress(inside, laws, response, sums_.data());
  exchange_->finish(response, row.length, row.means);
  kernel_->stress(border, laws, response, sums_.data());

  findReturns(a);
  if (laws_.returnsTwice)
    yieldAgain(a, border, inside);
  const double *around = showLocal(a);
  exchange_->begin(answers, row.length, row.answers);

  changing_ = kernel_->force(inside, laws, response, laws_.returnsTwice, around, sums_.data());
  exchange_->finish(answers, row.length, row.answers);
  changing_ += kernel_->force(border, laws, response, laws_.returnsTwice, around, sums_.data());
  findKept();
  const bool rubs = laws_.rubs || !links_.springs().empty();
  friction_.clear();
  if (!laws_.resistsSlip && !laws_.centresViscosity && !rubs)
    return;
  const Pairs pairs = links_.part(0, links_.size());
  viscous_.find(*kernel_, pairs);
  ViscousStep now;
  now.rows = view();
  now.laws = laws;
  now.oneLaw = laws_.pairs.size() == 1;
  now.dt = dt;
  now.groups = a.groups;
  now.integrated = a.integrated;
  now.held = a.held;
  now.heldSpins = a.heldSpins;
  if (laws_.resistsSlip)
    viscous_.resistSlip(*kernel_, pairs, now, sums_.data());
  if (laws_.centresViscosity)
    centreViscosity(pairs, now);
  if (rubs)
    rub(dt, advance);
}

// Within a step forces see the velocities of half a step ago. In set-up the lag that they had when
// the forces of this step were computed gives them again, so that viscous forces do not change; the
// rest makes that exact, where the lag is a rounded difference. Angular velocities matter to a
// set-up only where laws see slip.
void Step::packMotion(const Automata &a, bool advance)
{
  dimension() == 2 ? packPlane(a, advance) : packSpace(a, advance);
  for (int m = 0; m < 3 && laws_.resistsSlip && !advance; m++)
    if (const double *lag = a.spinLag[m], *rest = a.spinRest[m]; lag)
      for (int i = 0; i < spin_.rows(); i++)
        spinOf(i, m) = spinOf(i, m) - lag[i] - rest[i];
}

double &Step::spinOf(int row, int component)
{
  return component == 2 ? *spin_.row(row) : motion_.row(row)[layout().motion.spin + component];
}

void Step::packPlane(const Automata &a, bool advance)
{
  constexpr RowLayout::Motion at = planeRows.motion;
  double *row = motion_.data(), *turn = spin_.data();
  const double *lagX = a.lag[0], *lagY = a.lag[1], *restX = a.rest[0], *restY = a.rest[1];
  const int all = motion_.rows();
  for (int i = 0; i < all; i++, row += at.length) {
    row[at.place] = a.x[i][0];
    row[at.place + 1] = a.x[i][1];
    row[at.velocity] = advance ? a.v[i][0] : a.v[i][0] - lagX[i] - restX[i];
    row[at.velocity + 1] = advance ? a.v[i][1] : a.v[i][1] - lagY[i] - restY[i];
    turn[i] = a.omega[i][2];
  }
}

void Step::packSpace(const Automata &a, bool advance)
{
  constexpr RowLayout::Motion at = spaceRows.motion;
  double *row = motion_.data(), *turn = spin_.data();
  const int all = motion_.rows();
  for (int i = 0; i < all; i++, row += at.length) {
    for (int m = 0; m < 3; m++) {
      row[at.place + m] = a.x[i][m];
      row[at.velocity + m] = a.v[i][m];
    }
    row[at.spin] = a.omega[i][0];
    row[at.spin + 1] = a.omega[i][1];
    turn[i] = a.omega[i][2];
  }
  for (int m = 0; m < 3 && !advance; m++) {
    const double *lag = a.lag[m], *rest = a.rest[m];
    row = motion_.data() + at.velocity + m;
    for (int i = 0; i < all; i++, row += at.length)
      *row = *row - lag[i] - rest[i];
  }
}

static double component(const Vector &v, int m)
{
  return m == 0 ? v.x : m == 1 ? v.y : v.z;
}

void Step::keepLag(const Automata &a) const
{
  for (int m = 0; m < dimension(); m++) {
    const double *row = motion_.data() + layout().motion.velocity + m;
    for (int i = 0; i < own(); i++, row += motion_.length()) {
      a.lag[m][i] = a.v[i][m] - *row;
      a.rest[m][i] = a.v[i][m] - a.lag[m][i] - *row;
    }
  }
  for (int m = 0; m < 3; m++)
    if (double *lag = a.spinLag[m], *rest = a.spinRest[m]; lag)
      for (int i = 0; i < own(); i++) {
        const double seen = component(spin(i), m);
        lag[i] = a.omega[i][m] - seen;
        rest[i] = a.omega[i][m] - lag[i] - seen;
      }
}

void Step::findMeans()
{
  for (int s = 0; s < spans_.own(); s++) {
    const int from = spans_.first(s);
    crowded_[s] = kernel_->mean(spans_.last(s) - from, types_.data() + from, laws_.automata.data(),
                                laws_.oneMaterial, strains_.row(from), response_.row(from)) > 0.0;
  }
}

// The return mapping is explicit: an automaton's trial stress and its yield stress give M, and each
// bulk link takes the mean of what M of both sides answers, in the force pass. No automaton waits
// for the outcome of its neighbours; steps corrected repeats it once with what that outcome was
// (yieldAgain()). kappa grows in the next state, so that all automata flow by the same present one.
void Step::findReturns(const Automata &a)
{
  for (int s = 0; s < spans_.own(); s++)
    flows_[s] = yield(a.kappa, flows_[s], spans_.first(s), spans_.last(s));
  const Pairs p = links_.part(0, links_.size());
  for (int b = 0; b * blockLength < p.n; b++) {
    const RowSpans::Range spans = spans_.of(b);
    p.blocks[b].flows = std::any_of(spans.begin(), spans.end(), [&](int s) { return flows_[s]; });
    p.blocks[b].crowded =
        std::any_of(spans.begin(), spans.end(), [&](int s) { return crowded_[s]; });
  }
}

// Radial returns of a span of automata; whether any flows. Where none does, which is most of a
// sample, kappaNext is not written: the present state stays.
bool Step::yield(const double *kappa, bool flowed, int from, int to)
{
  double next[RowSpans::length];
  const bool flows = kernel_->yield(to - from, types_.data() + from, laws_.automata.data(),
                                    laws_.oneMaterial, flowed, strains_.row(from), sums_.row(from),
                                    kappa + from, next, response_.row(from)) > 0.0;
  if (flows || laws_.needsLocal)
    std::copy_n(flows ? next : kappa + from, to - from, kappaNext_.row(from));
  return flows;
}

// Yields once more, now that the returns of neighbours are known; these are on their way. What
// flows on this rank is a neighbour's affair, too, hence only one rank alone may pass over it.
void Step::yieldAgain(const Automata &a, const Pairs &border, const Pairs &inside)
{
  const bool flow = std::any_of(flows_.begin(), flows_.end(), [](char flows) { return flows; });
  if (exchange_->alone() && !flow)
    return;
  const RowLayout::Response &row = layout().response;
  double *const response = response_.data(), *const answers = response + row.factor;
  exchange_->begin(answers, row.length, row.answers);
  clearTaken();
  kernel_->returns(inside, laws_.pairs.data(), response, taken_.data());
  exchange_->finish(answers, row.length, row.answers);
  kernel_->returns(border, laws_.pairs.data(), response, taken_.data());
  for (int s = 0; s < spans_.own(); s++)
    if (const int from = spans_.first(s); flows_[s])
      kernel_->yieldAgain(spans_.last(s) - from, types_.data() + from, laws_.automata.data(),
                          strains_.row(from), sums_.row(from), taken_.row(from), a.kappa + from,
                          kappaNext_.row(from), response_.row(from));
}

// Sums of the return pass, of the automata that its blocks touch.
void Step::clearTaken()
{
  touched_.assign(spans_.size(), false);
  const Pairs p = links_.part(0, links_.size());
  for (int b = 0; b * blockLength < p.n; b++)
    if (p.blocks[b].flows)
      for (const int s : spans_.of(b))
        touched_[s] = true;
  for (int s = 0; s < spans_.size(); s++)
    if (touched_[s])
      std::fill(taken_.row(spans_.first(s)), taken_.row(spans_.last(s)), 0.0);
}

// Where links have broken, the mean stress begins with what they left to it. Most automata have
// kept nothing, and then all is 0 already.
void Step::addKept(const double *kept)
{
  if (!laws_.keepsVolume)
    return;
  const int length = layout().strain.length;
  for (int s = 0; s < spans_.own(); s++) {
    const int from = spans_.first(s), to = spans_.last(s);
    static constexpr double nothing[RowSpans::length] = {};
    const bool keeps = std::memcmp(kept + from, nothing, (to - from) * sizeof(double)) != 0;
    if (!keeps && !keeps_[s])
      continue;
    keeps_[s] = keeps;
    std::copy_n(kept + from, to - from, kept_.row(from));
    std::fill_n(keptNext_.row(from), to - from, 0.0);
    double *row = strains_.row(from) + layout().strain.sum;
    for (int i = from; i < to; i++, row += length)
      *row = kept[i];
  }
}

// What of it the next state has: what lets go of it, and what links that break now leave.
void Step::findKept()
{
  if (!laws_.keepsVolume)
    return;
  const int length = layout().response.length;
  for (int s = 0; s < spans_.own(); s++) {
    if (!keeps_[s])
      continue;
    const int from = spans_.first(s), n = spans_.last(s) - from;
    const double *const means = response_.row(from) + layout().response.mean;
    const double *const now = kept_.row(from);
    double *const next = keptNext_.row(from);
    for (int i = 0; i < n; i++) {
      if (now[i] == 0.0) // it stays 0
        continue;
      const AutomatonLaw &law = laws_.automata[types_[from + i]];
      next[i] = keptStrain(now[i], means[length * i] / (law.bulkModulus * law.weight));
    }
  }
  if (changing_ > 0.0)
    leaveStrains();
}

void Step::leaveStrains()
{
  const Pairs p = links_.part(0, links_.size());
  eachPairOfChangingBlocks(p, [&](int k) {
    if (link::isLinked(p.now.kind[k]) && !link::isLinked(p.next.kind[k]))
      for (const int i : {p.i[k], p.j[k]})
        if (i < own()) {
          *keptNext_.row(i) += strainLeft(p.eps[k] - p.next.plastic[k]);
          keeps_[i / RowSpans::length] = true;
        }
  });
}

// What automata show to the criteria of their contacts; nullptr where these need nothing.
const double *Step::showLocal(const Automata &a)
{
  if (!laws_.needsLocal)
    return nullptr;
  mca::showLocal(view(), laws_.keepsVolume, own(), types_.data(), laws_.automata.data(), a.kappa,
                 kappaNext_.data(), local_.data());
  exchange_->begin(local_.data(), local_.length(), local_.length());
  exchange_->finish(local_.data(), local_.length(), local_.length());
  return local_.data();
}

RowView Step::view() const
{
  RowView rows;
  rows.layout = &layout();
  rows.motion = motion_.data();
  rows.spins = spin_.data();
  rows.sums = sums_.data();
  rows.response = response_.data();
  return rows;
}

// Last, since friction knows the whole normal force.
void Step::rub(double dt, bool moves)
{
  const PairLaw *const laws = laws_.pairs.data();
  friction_.find(links_, viscous_, view(), laws, own(), dt, moves);
  friction_.addForces(links_, layout(), laws, sums_.data());
}

// What forces change in half a step, of both automata of a viscous contact; torques, too, where it
// resists slip.
void Step::centreViscosity(const Pairs &pairs, const ViscousStep &now)
{
  const RowLayout::Force &row = layout().force;
  const bool slips = laws_.resistsSlip;
  double *const sums = sums_.data(), *const forces = sums + row.force;
  const int torques = dimension() == 2 ? 1 : 3;
  const int needed = slips ? row.torque - row.force + torques : dimension();
  const int border = viscous_.before(border_);
  exchange_->begin(forces, row.length, needed);
  viscous_.centre(*kernel_, pairs, border, viscous_.size(), slips, now);
  exchange_->finish(forces, row.length, needed);
  viscous_.centre(*kernel_, pairs, 0, border, slips, now);
  viscous_.addCentred(*kernel_, pairs, border, slips, sums);
}

// Changes count when their step's outcome is taken over: once, also those of the first step,
// whatever runs and restart files the steps belong to.
bool Step::commit(const Automata &a)
{
  if (committed_)
    return false;
  changed_.clear();
  if (changing_ > 0.0)
    findChanges();
  changing_ = 0.0;
  for (int s = 0; s < spans_.own(); s++) {
    const int from = spans_.first(s), n = spans_.last(s) - from;
    if (flows_[s])
      std::copy_n(kappaNext_.row(from), n, a.kappa + from);
    if (keeps_[s])
      std::copy_n(keptNext_.row(from), n, a.kept + from);
  }
  return committed_ = true;
}

// Events are found here and not in the force pass, whose loops only count them: most steps have
// none, and then no pair is looked at. Both ranks of a pair find the same change, each counts its
// share, and each counts the ends that it owns.
void Step::findChanges()
{
  const Pairs p = links_.part(0, links_.size());
  eachPairOfChangingBlocks(p, [&](int k) {
    const double before = p.now.kind[k], after = p.next.kind[k];
    const bool was = link::isLinked(before), is = link::isLinked(after);
    if (before == after || (!was && !is))
      return;
    (was && is ? events_.healed : was ? events_.broken : events_.formed) += share(k);
    if (!is)
      links_.setOriginal(k, false);
    if (was != is)
      for (const int i : {p.i[k], p.j[k]})
        if (i < own()) // else the owner holds the pair, too
          linkChanges_.row(i)[was ? 0 : 1] += 1.0;
    changed_.push_back({k, before, after});
  });
}

void Step::takeChanges(double *broken, double *formed)
{
  for (int i = 0; i < own(); i++) {
    broken[i] += linkChanges_.row(i)[0];
    formed[i] += linkChanges_.row(i)[1];
  }
  linkChanges_.clear();
}

} // namespace mca
