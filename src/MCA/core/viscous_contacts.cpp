// SPDX-License-Identifier: GPL-2.0-or-later
#include "viscous_contacts.h"

#include <algorithm>

namespace mca {

void ViscousContacts::find(const Kernel &kernel, const Pairs &p)
{
  constexpr int more = 3; // that loops by fours read
  if (numbers_.size() < static_cast<size_t>(p.n) + more)
    numbers_.resize(p.n + more);
  ViscousColumns &c = columns_;
  c.n = kernel.viscous->find(p, numbers_.data());
  std::fill_n(numbers_.data() + c.n, more, 0);
  c.pair = numbers_.data();
  const RowLayout::Force &row = kernel.rows.force;
  const int length = row.length - row.force; // of what goes to an automaton
  constexpr int line = 8;
  const size_t column = (c.n + line - 1) / line * line;
  values_.reserve(column * (4 + length + 3));
  double *next = values_.get();
  const auto take = [&](int values) {
    double *const begin = next;
    next += column * values;
    return begin;
  };
  c.normal = take(4);
  c.along = take(length);
  for (double *&slip : c.slip)
    slip = take(1);
}

void ViscousContacts::resistSlip(const Kernel &kernel, const Pairs &p, const ViscousStep &step,
                                 double *forces)
{
  kernel.viscous->slip(p, columns_, step);
  kernel.viscous->addAlong(p, columns_, forces);
}

void ViscousContacts::centre(const Kernel &kernel, const Pairs &p, int first, int last, bool slips,
                             const ViscousStep &step)
{
  kernel.viscous->centre(p, columns_, first, last, slips, step);
}

void ViscousContacts::addCentred(const Kernel &kernel, const Pairs &p, int border, bool slips,
                                 double *forces) const
{
  kernel.viscous->addNormal(p, columns_, border, columns_.n, forces);
  kernel.viscous->addNormal(p, columns_, 0, border, forces);
  if (slips)
    kernel.viscous->addAlong(p, columns_, forces);
}

int ViscousContacts::before(int pair) const
{
  return static_cast<int>(std::lower_bound(begin(), end(), pair) - begin());
}

Vector ViscousContacts::slip(int k, bool plane) const
{
  const int at = before(k);
  if (at == columns_.n || numbers_[at] != k)
    return {0.0, 0.0, 0.0};
  return {columns_.slip[0][at], columns_.slip[1][at], plane ? 0.0 : columns_.slip[2][at]};
}

} // namespace mca
