// SPDX-License-Identifier: GPL-2.0-or-later
#include "link_list.h"

#include "laws/linking.h"

#include <algorithm>
#include <functional>

namespace mca {

// The kernel gathers in fours: the last pair is repeated.
static constexpr int padding = 3;

LinkList::LinkList(int shears) : shears_(shears), now_(stateSize()), next_(stateSize()) {}

void LinkList::reset(int n)
{
  // A pass reads the same place of many quantities, so they begin in different sets of the cache:
  // 5 lines apart modulo a page.
  constexpr size_t line = 8, page = 64 * line;
  const size_t stride = (static_cast<size_t>(n) + page - 1) / page * page + 5 * line;
  values_.reserve((7 + 2 * stateSize()) * stride);
  double *array = values_.get();
  auto take = [&]() {
    array += stride;
    return array - stride;
  };
  for (auto *list : {&i_, &j_, &placeI_, &placeJ_, &law_})
    list->resize(n + padding);
  original_.clear();
  original_.reserve(n);
  blocks_.clear();
  blocks_.reserve(n / blockLength + 1);
  view_ = {};
  stale_ = false;
  springs_.clear();
  view_.i = i_.data();
  view_.j = j_.data();
  view_.placeI = placeI_.data();
  view_.placeJ = placeJ_.data();
  view_.law = law_.data();
  view_.blocks = blocks_.data();
  for (double *&normal : view_.normal)
    normal = take();
  view_.ratio = take();
  view_.eps = take();
  view_.separation = take();
  view_.sigma = take();
  for (auto *of : {&now_, &next_}) {
    for (auto &values : *of)
      values = take();
    PairState &state = of == &now_ ? view_.now : view_.next;
    state.kind = (*of)[0];
    state.plastic = (*of)[1];
    for (int m = 0; m < shears_; m++) {
      state.gamma[m] = (*of)[2 + m];
      state.gammaTotal[m] = (*of)[2 + shears_ + m];
    }
  }
}

void LinkList::add(int i, int j, int law, const double *state)
{
  const int k = view_.n++;
  if (k % blockLength == 0) {
    Block first{};
    first.law = law;
    first.bulk = first.pristine = first.flows = first.crowded = first.near = true;
    blocks_.push_back(first);
  }
  Block &block = blocks_.back();
  if (law != block.law)
    block.law = Block::mixed;
  for (int m = 0; m <= padding; m++) {
    i_[k + m] = i;
    j_[k + m] = j;
  }
  setPlaces(i, j);
  law_[k] = law;
  for (double *normal : view_.normal)
    normal[k] = 0.0;
  view_.ratio[k] = 1.0;
  view_.eps[k] = view_.separation[k] = 0.0;
  original_.push_back(0.0);
  setState(k, state);
}

void LinkList::setPlaces(int placeI, int placeJ)
{
  for (int k = view_.n - 1; k < view_.n + padding; k++) {
    placeI_[k] = placeI;
    placeJ_[k] = placeJ;
  }
  const int last = view_.n - 1;
  if (placeI != i_[last] || placeJ != j_[last])
    blocks_.back().across = true;
}

// For blocks that never flowed (pristine) the kernel keeps the elastic shear only, since the total
// one equals it: arrays that need be neither read nor written for most of a sample. Readers get
// both: part(), by which the kernel comes in, marks the list as stale, and the first reader
// afterwards copies. A block stays pristine until its first change of state is taken over
// (advance()) or one of its links breaks, when the kernel copies (leavePristine()).
void LinkList::completeAll() const
{
  for (size_t b = 0; b < blocks_.size(); b++)
    if (blocks_[b].pristine)
      complete(static_cast<int>(b));
  stale_ = false;
}

void LinkList::complete(int block) const
{
  const int first = block * blockLength, n = std::min(blockLength, view_.n - first);
  for (int m = 0; m < shears_; m++)
    std::copy_n(view_.now.gamma[m] + first, n, view_.now.gammaTotal[m] + first);
}

Pairs LinkList::part(int first, int n)
{
  stale_ = true;
  Pairs p = view_;
  p.n = n;
  for (auto *rows : {&p.i, &p.j, &p.placeI, &p.placeJ, &p.law})
    *rows += first;
  for (double **values :
       {&p.normal[0], &p.normal[1], &p.normal[2], &p.ratio, &p.eps, &p.separation, &p.sigma})
    *values += first;
  for (PairState *state : {&p.now, &p.next}) {
    state->kind += first;
    state->plastic += first;
    for (int m = 0; m < shears_; m++) {
      state->gamma[m] += first;
      state->gammaTotal[m] += first;
    }
  }
  p.blocks += first / blockLength;
  return p;
}

// In space the shears turn round when both automata are exchanged; an unlinked pair has that of
// friction alone, and plastic work in the place of its total shear.
void LinkList::exchange(double *state) const
{
  if (shears_ != 3)
    return;
  if (link::isLinked(state[0]))
    std::transform(state + 2, state + stateSize(), state + 2, std::negate<>());
  else
    std::transform(state + 2, state + 2 + shears_, state + 2, [](double x) { return 0.0 - x; });
}

const LinkList::Spring *LinkList::spring(int k) const
{
  const auto found = std::lower_bound(springs_.begin(), springs_.end(), k,
                                      [](const Spring &s, int pair) { return s.pair < pair; });
  return found != springs_.end() && found->pair == k ? &*found : nullptr;
}

static bool isZero(const double *values, int n)
{
  return std::all_of(values, values + n, [](double value) { return value == 0.0; });
}

void LinkList::setNormal(int k, const Vector &normal)
{
  view_.normal[0][k] = normal.x;
  view_.normal[1][k] = normal.y;
  view_.normal[2][k] = normal.z;
}

void LinkList::addStored(int i, int j, int law, bool exchanged, const double *stored)
{
  double state[maxStateSize];
  std::copy_n(stored, stateSize(), state);
  if (exchanged)
    exchange(state);
  add(i, j, law, state);
  const double *more = stored + stateSize();
  original_.back() = more[0];
  for (int m = 0; m < 3; m++)
    view_.normal[m][view_.n - 1] = more[1 + m];
}

void LinkList::getStored(int k, bool next, bool exchanged, double *stored) const
{
  getState(k, next, stored);
  if (exchanged)
    exchange(stored);
  double *more = stored + stateSize();
  more[0] = original_[k];
  for (int m = 0; m < 3; m++)
    more[1 + m] = view_.normal[m][k];
}

bool LinkList::blank(int k, bool next) const
{
  double state[maxStateSize];
  getState(k, next, state);
  return isZero(state, stateSize());
}

// Where nothing flows, breaks, links or heals, the next state is the present one, whatever its
// arrays hold: such a block costs nothing here.
void LinkList::advance()
{
  for (size_t b = 0; b < blocks_.size(); b++) {
    if (!blocks_[b].moves)
      continue;
    blocks_[b].moves = blocks_[b].changes = blocks_[b].pristine = false;
    const int first = static_cast<int>(b) * blockLength;
    const int n = std::min(blockLength, view_.n - first);
    for (size_t m = 0; m < now_.size(); m++)
      std::copy_n(next_[m] + first, n, now_[m] + first);
    const double *kind = view_.now.kind + first;
    blocks_[b].bulk = std::all_of(kind, kind + n, [](double k) { return k == link::bulk; });
  }
  // those that let go, or became the shear of a link, end
  const auto ends = [this](const Spring &s) {
    return link::isLinked(view_.now.kind[s.pair]) || isZero(s.next, maxShears);
  };
  springs_.erase(std::remove_if(springs_.begin(), springs_.end(), ends), springs_.end());
  for (Spring &s : springs_)
    std::copy_n(s.next, maxShears, s.now);
}

void LinkList::getState(int k, bool next, double *state) const
{
  const Block &block = blocks_[k / blockLength];
  const auto &from = next && block.moves ? next_ : now_;
  for (size_t m = 0; m < from.size(); m++)
    state[m] = from[m][k];
  if (block.pristine && &from == &now_)
    std::copy_n(state + 2, shears_, state + 2 + shears_);
  if (springs_.empty() || link::isLinked(state[0]))
    return;
  if (const Spring *const s = spring(k))
    std::copy_n(next ? s->next : s->now, shears_, state + 2);
}

void LinkList::setState(int k, const double *given)
{
  double state[maxStateSize];
  std::copy_n(given, stateSize(), state);
  takeSpring(k, state);
  Block &block = blocks_[k / blockLength];
  if (block.pristine && stale_)
    complete(k / blockLength);
  for (size_t m = 0; m < now_.size(); m++) {
    now_[m][k] = state[m];
    if (block.moves)
      next_[m][k] = state[m];
  }
  block.bulk = block.bulk && state[0] == link::bulk;
  block.pristine = block.pristine && block.bulk && state[1] == 0.0 &&
                   std::equal(state + 2, state + 2 + shears_, state + 2 + shears_);
}

// From the state of a pair, which is left with none.
void LinkList::takeSpring(int k, double *state)
{
  const auto place = std::lower_bound(springs_.begin(), springs_.end(), k,
                                      [](const Spring &s, int pair) { return s.pair < pair; });
  const bool known = place != springs_.end() && place->pair == k;
  if (link::isLinked(state[0]) || isZero(state + 2, shears_)) {
    if (known)
      springs_.erase(place);
    return;
  }
  Spring s{k, {}, {}};
  std::copy_n(state + 2, shears_, s.now);
  std::copy_n(state + 2, shears_, s.next);
  std::fill_n(state + 2, shears_, 0.0);
  if (known)
    *place = s;
  else
    springs_.insert(place, s);
}

double LinkList::bytes() const
{
  return values_.bytes() + static_cast<double>(5 * i_.capacity() * sizeof(int)) +
         static_cast<double>(original_.capacity() * sizeof(double)) +
         static_cast<double>(springs_.capacity() * sizeof(Spring)) +
         static_cast<double>(blocks_.capacity() * sizeof(Block));
}

} // namespace mca
