#include "link_list.h"

namespace mca {

void LinkList::reset(int n)
{
  for (auto &a : arrays_)
    a.reserve(n);
  i_.clear();
  j_.clear();
  law_.clear();
  i_.reserve(n);
  j_.reserve(n);
  law_.reserve(n);
  auto state = [&](int first) -> PairState {
    return {arrays_[first].get(), arrays_[first + 1].get(), arrays_[first + 2].get(),
            arrays_[first + 3].get()};
  };
  view_ = {0,        i_.data(),        j_.data(),        law_.data(),       state(0),
           state(4), arrays_[8].get(), arrays_[9].get(), arrays_[10].get(), arrays_[11].get()};
}

void LinkList::add(int i, int j, int law, const double *state)
{
  i_.push_back(i);
  j_.push_back(j);
  law_.push_back(law);
  const int k = view_.n++;
  view_.nx[k] = view_.ny[k] = view_.eps[k] = view_.separation[k] = 0.0;
  setState(k, state);
}

void LinkList::getState(int k, bool next, double *state) const
{
  const PairState &from = next ? view_.next : view_.now;
  state[0] = from.kind[k];
  state[1] = from.plastic[k];
  state[2] = from.gamma[k];
  state[3] = from.gammaTotal[k];
}

void LinkList::setState(int k, const double *state)
{
  for (const PairState &to : {view_.now, view_.next}) {
    to.kind[k] = state[0];
    to.plastic[k] = state[1];
    to.gamma[k] = state[2];
    to.gammaTotal[k] = state[3];
  }
}

double LinkList::bytes() const
{
  double sum = static_cast<double>(3 * i_.capacity() * sizeof(int));
  for (const auto &a : arrays_)
    sum += a.bytes();
  return sum;
}

} // namespace mca
