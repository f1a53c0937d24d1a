// SPDX-License-Identifier: GPL-2.0-or-later
#include "step.h"

#include <algorithm>
#include <stdexcept>

namespace mca {

Step::Automaton Step::automaton(int i) const
{
  const AutomatonLaw &law = laws_.automata[types_.at(i)];
  const double average = mean(i);
  const StressTensor s = view().averaged(i, law);
  const bool inPlane = dimension() == 2 && laws_.keepsVolume;
  const double intensity = stressIntensity(inPlane ? flowStress(s.xx, s.yy, s.xy) : s);
  StressTensor whole = s;
  double room = 0.0;
  if (laws_.keepsVolume) {
    room = view().answer(i).room;
    for (double *normal : {&whole.xx, &whole.yy, &whole.zz})
      *normal -= room;
  }
  return {whole, average - room, intensity, energy(i)};
}

void Step::findSquares() const
{
  squares_.resize(own());
  squares_.clear();
  const Pairs &p = links_.pairs();
  const int shears = dimension() == 2 ? 1 : maxShears;
  for (int k = 0; k < p.n; k++) {
    const double e = p.eps[k] - p.now.plastic[k];
    double square = link::isLinked(p.now.kind[k]) || isPressed(e) ? e * e : 0.0;
    double shear = 0.0;
    for (int m = 0; m < shears; m++)
      shear += p.now.gamma[m][k] * p.now.gamma[m][k];
    square += shear;
    for (const int i : {p.i[k], p.j[k]})
      if (i < own())
        *squares_.row(i) += square;
  }
  squaresKnown_ = true;
}

double Step::energy(int i) const
{
  const int type = types_.at(i);
  const AutomatonLaw &law = laws_.automata[type];
  if (!squaresKnown_)
    findSquares();
  const double squares = *squares_.row(i);
  const Answer answer = view().answer(i);
  const double density =
      energyDensity(squares, answer.mean, law.shearModulus, law.bulkModulus, law.D, law.weight);
  return (density + roomEnergy(answer.room, law.bulkModulus)) * laws_.volumes[type] +
         friction_.energy(i);
}

Vector Step::force(int i) const
{
  return view().force(sums_.checked(i));
}

Vector Step::torque(int i) const
{
  return view().torque(sums_.checked(i));
}

Vector Step::place(int row) const
{
  return view().place(motion_.checked(row));
}

Vector Step::velocity(int row) const
{
  return view().velocity(motion_.checked(row));
}

Vector Step::spin(int row) const
{
  return view().spin(motion_.checked(row));
}

double Step::mean(int row) const
{
  return view().answer(response_.checked(row)).mean;
}

double Step::factor(int row) const
{
  return view().answer(response_.checked(row)).factor;
}

Vector Step::normal(int k) const
{
  return normalOf(links_.pairs(), k, dimension() == 2);
}

static Vector vectorAt(double *const *shears, int k)
{
  return {shears[0][k], shears[1][k], shears[2][k]};
}

// The elastic or the total shear; in the plane its only component is along t.
static double sizeOf(double *const *shears, int k, int dimension)
{
  return dimension == 2 ? shears[0][k] : length(vectorAt(shears, k));
}

double Step::shear(int k) const
{
  return sizeOf(links_.pairs().now.gamma, k, dimension());
}

double Step::totalShear(int k) const
{
  return sizeOf(links_.pairs().now.gammaTotal, k, dimension());
}

Vector Step::alongShear(int k, double size) const
{
  const Vector n = normal(k);
  if (dimension() == 2)
    return {-size * n.y, size * n.x, 0.0};
  double *const *of = links_.pairs().now.gamma;
  const Vector gamma = vectorAt(of, k);
  const double size0 = length(gamma);
  return size0 > 0.0 ? size / size0 * gamma : Vector{0.0, 0.0, 0.0};
}

ContactStress Step::contact(int k) const
{
  const Pairs &p = links_.pairs();
  const Answer i = view().answer(p.i[k]), j = view().answer(p.j[k]);
  const bool moves = p.blocks[k / blockLength].moves;
  const double kind = p.now.kind[k], left = returnedShare(i, j);
  Stretch stretch;
  if (laws_.keepsVolume && link::isLinked(kind))
    stretch = dimension() == 2
                  ? shearStretch(left, p.now.gamma[0][k], p.now.gammaTotal[0][k])
                  : shearStretch(left, vectorAt(p.now.gamma, k), vectorAt(p.now.gammaTotal, k));
  return contactStress(law(k),
                       {kind, p.ratio[k], p.eps[k], p.now.plastic[k], shear(k), totalShear(k),
                        p.separation[k], stretch},
                       i, j, moves ? p.next.kind[k] : kind);
}

Vector Step::slipStress(int k) const
{
  return laws_.resistsSlip ? mca::slipStress(law(k), viscous_.slip(k, dimension() == 2))
                           : Vector{0.0, 0.0, 0.0};
}

Vector Step::frictionShear(int k, bool next) const
{
  return springOf(links_, k, dimension() == 2, next);
}

Vector Step::contactForce(int k) const
{
  const ContactStress s = contact(k);
  const ActingAreas area = actingAreas(law(k), links_.pairs().ratio[k]);
  const Vector shear = alongShear(k, s.shear) + law(k).twoG * frictionShear(k, true);
  return s.normal * area.normal * normal(k) + area.shear * shear + law(k).area * slipStress(k);
}

double Step::distance(int k) const
{
  return law(k).diameter * links_.pairs().ratio[k];
}

double Step::share(int k) const
{
  return std::max(links_.i(k), links_.j(k)) < own() ? 1.0 : 0.5;
}

// The first automaton of a pair is the same on both ranks.
bool Step::isOurs(int k) const
{
  return links_.i(k) < own();
}

Step::Count Step::count() const
{
  Count c = events_;
  const Pairs &p = links_.pairs();
  for (int k = 0; k < p.n; k++) {
    if (link::isLinked(p.now.kind[k]))
      c.links += share(k);
    if (p.now.kind[k] == link::weld)
      c.welds += share(k);
  }
  return c;
}

double Step::bytes() const
{
  double sum =
      links_.bytes() + viscous_.bytes() + friction_.bytes() + spans_.bytes() + squares_.bytes();
  for (const RowArray *rows : {&motion_, &spin_, &strains_, &response_, &sums_, &taken_, &local_,
                               &kappaNext_, &kept_, &keptNext_, &linkChanges_})
    sum += rows->bytes();
  return sum;
}

} // namespace mca
