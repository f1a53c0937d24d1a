// SPDX-License-Identifier: GPL-2.0-or-later
// The passes over viscous contacts, for the plane and for space. Compiled once for each instruction
// set, as kernel.cpp is, but without contraction: all sets compute the same, to the last bit.
#include "kernel.h"
#include "kernel_few.h"
#include "kernel_plane.h"
#include "kernel_space.h"

namespace mca::MCA_ISA {
namespace {

// No block of bulk links that none leaves has one.
int findViscous(const Pairs &p, int *numbers)
{
  int count = 0;
  for (int first = 0; first < p.n; first += blockLength) {
    const Block &block = p.blocks[first / blockLength];
    if (block.bulk && !block.changes)
      continue;
    const double *const kind = p.now.kind + first, *const plastic = p.now.plastic + first;
    const double *const next = (block.changes ? p.next.kind : p.now.kind) + first;
    const double *const eps = p.eps + first;
    maskOf(lesser(blockLength, p.n - first), [=](int k) {
      const bool stays = link::isLinked(kind[k]) & link::isLinked(next[k]);
      return isPressed(eps[k] - plastic[k]) & !stays;
    }).each([&](int k) { numbers[count++] = first + k; });
  }
  return count;
}

inline Vector inSpace(const PlaneVector &v)
{
  return {v.x, v.y, 0.0};
}

inline Vector inSpace(const Vector &v)
{
  return v;
}

// NOLINTNEXTLINE(modernize-use-using): the attributes belong to the declared name
typedef int Int4 __attribute__((vector_size(16), may_alias));

// Whole numbers as gatherOne() has others; `to` is 16-byte aligned.
inline void gatherNumbers(const int *index, int n, const int *from, int *to)
{
  for (int k = 0; k < n; k += 4)
    *reinterpret_cast<Int4 *>(to + k) =
        Int4{from[index[k]], from[index[k + 1]], from[index[k + 2]], from[index[k + 3]]};
}

// Up to blockLength contacts, as columns; filled up to whole fours.
template<class D>
struct Contacts {
  alignas(64) int i[blockLength], j[blockLength], law[blockLength];
  Column ratio, normals[D::rows.dimension];

  // \param pi,pj  rows of both automata of all pairs
  void gather(const Pairs &p, const int *pair, int n, const int *pi, const int *pj)
  {
    gatherNumbers(pair, n, pi, i);
    gatherNumbers(pair, n, pj, j);
    gatherNumbers(pair, n, p.law, law);
    gatherOne<1>(pair, n, p.ratio, ratio);
    for (int m = 0; m < D::rows.dimension; m++)
      gatherOne<1>(pair, n, p.normal[m], normals[m]);
  }
  Vector normal(int k) const
  {
    return {normals[0][k], normals[1][k], D::rows.dimension == 2 ? 0.0 : normals[2][k]};
  }
};

// Forces and torques of automata, or of contacts on their first automaton.
template<class D>
struct Pushes {
  static constexpr bool plane = D::rows.dimension == 2;
  static constexpr int parts = plane ? 1 : 2;
  Columns<parts> row;

  Pushes() { row.clearFrom(plane ? 3 : 6); }
  Vector force(int k) const { return {row.c[0][k], row.c[1][k], plane ? 0.0 : row.c[2][k]}; }
  Vector torque(int k) const
  {
    if constexpr (plane)
      return {0.0, 0.0, row.c[2][k]};
    else
      return {row.c[3][k], row.c[4][k], row.c[5][k]};
  }
  void set(int k, const Vector &force, const Vector &torque)
  {
    row.c[0][k] = force.x;
    row.c[1][k] = force.y;
    if constexpr (plane) {
      row.c[2][k] = torque.z;
    } else {
      row.c[2][k] = force.z;
      row.c[3][k] = torque.x;
      row.c[4][k] = torque.y;
      row.c[5][k] = torque.z;
    }
  }
  // Those of automata; works on whole fours.
  void gather(const int *index, int n, const double *sums)
  {
    constexpr int stride = D::rows.force.length / 4;
    for (int part = 0; part < parts; part++)
      for (int k = 0; k < n; k += 4) {
        Row4 r[4];
        for (int m = 0; m < 4; m++)
          r[m] = *rowOf<Row4>(sums + D::rows.force.force, stride * index[k + m] + part);
        Column *const c = row.c + 4 * part;
        store(r, k, c[0], c[1], c[2], c[3]);
      }
  }
};

// Columns of n contacts as rows, one behind the other.
template<int PARTS>
inline void putRows(const Columns<PARTS> &columns, int n, double *to)
{
  Row4 rows[PARTS][4];
  const auto put = [&](int k, int m) {
    for (int part = 0; part < PARTS; part++)
      *rowOf<Row4>(to, PARTS * (k + m) + part) = rows[part][m];
  };
  int k = 0;
  for (; k + 4 <= n; k += 4) { // whole fours have a loop of their own, which is unrolled
    columns.rows(k, rows);
    for (int m = 0; m < 4; m++)
      put(k, m);
  }
  if (k < n) {
    columns.rows(k, rows);
    for (int m = 0; m < n - k; m++)
      put(k, m);
  }
}

// Slip velocities of contacts, from this one on.
template<class D>
struct Slips {
  double *x, *y, *z;

  Slips(const ViscousColumns &c, int first)
      : x(c.slip[0] + first), y(c.slip[1] + first), z(c.slip[2] + first)
  {
  }
  Vector get(int k) const { return {x[k], y[k], D::rows.dimension == 2 ? 0.0 : z[k]}; }
  void set(int k, const Vector &slip) const
  {
    x[k] = slip.x;
    y[k] = slip.y;
    if (D::rows.dimension == 3)
      z[k] = slip.z;
  }
};

template<class D, bool ONE>
MCA_LOOP void slipLoop(const Contacts<D> &contacts, int n, const PairLaw *laws,
                       const typename D::Motion &motion, const Slips<D> &slips, Pushes<D> &along)
{
  const PairLaw one = laws[contacts.law[0]];
  auto answer = [=, &one, &contacts, &motion, &along](int k) {
    const PairLaw &law = ONE ? one : laws[contacts.law[k]];
    const double arm = 0.5 * law.diameter * contacts.ratio[k];
    const Vector normal = contacts.normal(k);
    const Vector slip = slipOf(normal, inSpace(motion.velocity(k)), motion.spin(k), arm);
    const Vector force = law.area * slipStress(law, slip);
    slips.set(k, slip);
    along.set(k, force, arm * cross(normal, force));
  };
#pragma omp simd
  for (int k = 0; k < n; k++)
    answer(k);
}

template<class D>
void slipPass(const Pairs &p, const ViscousColumns &c, const ViscousStep &step)
{
  Contacts<D> contacts;
  typename D::Motion motion;
  Pushes<D> along;
  for (int first = 0; first < c.n; first += blockLength) {
    const int n = lesser(blockLength, c.n - first);
    contacts.gather(p, c.pair + first, n, p.placeI, p.placeJ);
    motion.gather(contacts.i, contacts.j, n, step.rows.motion, step.rows.spins);
    const Slips<D> slips(c, first);
    if (step.oneLaw)
      slipLoop<D, true>(contacts, n, step.laws, motion, slips, along);
    else
      slipLoop<D, false>(contacts, n, step.laws, motion, slips, along);
    putRows(along.row, n, c.along + 4 * along.parts * first);
  }
}

// What the centring of contacts reads and writes beside their slip.
template<class D>
struct Centring {
  Contacts<D> contacts;
  alignas(64) int groupsI[blockLength], groupsJ[blockLength];
  Column kind, eps, plastic, separation; // of the pairs; the last is written
  typename D::Answers ofI, ofJ;
  Pushes<D> onI, onJ; // on the automata
  Columns<1> normal;  // what is added to the contact's own
  Pushes<D> along;

  Centring() { normal.clearFrom(D::rows.dimension); }
  void gather(const Pairs &p, const int *pair, int n, const ViscousStep &step)
  {
    contacts.gather(p, pair, n, p.i, p.j);
    gatherNumbers(contacts.i, n, step.groups, groupsI);
    gatherNumbers(contacts.j, n, step.groups, groupsJ);
    gatherOne<1>(pair, n, p.now.kind, kind);
    gatherOne<1>(pair, n, p.eps, eps);
    gatherOne<1>(pair, n, p.now.plastic, plastic);
    gatherOne<1>(pair, n, p.separation, separation);
    ofI.gather(contacts.i, n, step.rows.response);
    ofJ.gather(contacts.j, n, step.rows.response);
    onI.gather(contacts.i, n, step.rows.sums);
    onJ.gather(contacts.j, n, step.rows.sums);
  }
};

template<class D, bool ONE, bool SLIPS>
MCA_LOOP void centreLoop(Centring<D> &c, int n, const ViscousStep &step, const Slips<D> &slips)
{
  const PairLaw *const laws = step.laws, one = laws[c.contacts.law[0]];
  const int integrated = step.integrated, held = step.held, heldSpins = step.heldSpins;
  // half a step of automata that follow forces or torques
  auto halfOf = [=, half = 0.5 * step.dt](int groups, int others) {
    const bool follows = ((groups & integrated) != 0) & ((groups & others) == 0);
    return follows ? half : 0.0;
  };
  auto centre = [=, &one, &c](int k) {
    const PairLaw &law = ONE ? one : laws[c.contacts.law[k]];
    const double halfI = halfOf(c.groupsI[k], held), halfJ = halfOf(c.groupsJ[k], held);
    const double moveI = halfI * law.invMassI, moveJ = halfJ * law.invMassJ;
    const Vector normal = c.contacts.normal(k);
    const Vector moved = moveJ * c.onJ.force(k) - moveI * c.onI.force(k);
    const double damping =
        law.centring * law.viscosity * law.area * law.invDiameter * (moveI + moveJ);
    const double before = c.separation[k], ratio = c.contacts.ratio[k];
    const double after = centredSeparation(before, dot(normal, moved), damping);
    const double sigma = viscousStress(law, c.kind[k], c.eps[k], c.plastic[k], c.ofI[k], c.ofJ[k]);
    const double inverse = viscousInverse(law, ratio);
    const double more = unlinkedStress(sigma, law.viscosity, after, inverse, law.keepsEnergy) -
                        unlinkedStress(sigma, law.viscosity, before, inverse, law.keepsEnergy);
    const Vector push = more * actingAreas(law, ratio).normal * normal;
    c.separation[k] = after;
    c.normal.c[0][k] = push.x;
    c.normal.c[1][k] = push.y;
    if (D::rows.dimension == 3)
      c.normal.c[2][k] = push.z;
    if constexpr (SLIPS) {
      const double arm = 0.5 * law.diameter * ratio;
      const double turnI = halfOf(c.groupsI[k], heldSpins) * law.invInertiaI;
      const double turnJ = halfOf(c.groupsJ[k], heldSpins) * law.invInertiaJ;
      const Vector turned = turnI * c.onI.torque(k) + turnJ * c.onJ.torque(k);
      const double slipDamping = law.centring * (law.viscosity * law.invDiameter) * law.area *
                                 (moveI + moveJ + arm * arm * (turnI + turnJ));
      const Vector old = slips.get(k);
      const Vector slip = centred(old, slipOf(normal, moved, turned, arm), slipDamping);
      const Vector force = law.area * slipStress(law, slip) - law.area * slipStress(law, old);
      slips.set(k, slip);
      c.along.set(k, force, arm * cross(normal, force));
    }
  };
#pragma omp simd
  for (int k = 0; k < n; k++)
    centre(k);
}

template<class D, bool SLIPS>
void centreContacts(const Pairs &p, const ViscousColumns &c, int from, int to,
                    const ViscousStep &step)
{
  Centring<D> now;
  for (int first = from; first < to; first += blockLength) {
    const int n = lesser(blockLength, to - first);
    now.gather(p, c.pair + first, n, step);
    const Slips<D> slips(c, first);
    if (step.oneLaw)
      centreLoop<D, true, SLIPS>(now, n, step, slips);
    else
      centreLoop<D, false, SLIPS>(now, n, step, slips);
    for (int k = 0; k < n; k++)
      p.separation[c.pair[first + k]] = now.separation[k];
    putRows(now.normal, n, c.normal + 4 * first);
    if (SLIPS)
      putRows(now.along.row, n, c.along + 4 * now.along.parts * first);
  }
}

template<class D>
void centrePass(const Pairs &p, const ViscousColumns &c, int first, int last, bool slips,
                const ViscousStep &step)
{
  if (slips)
    centreContacts<D, true>(p, c, first, last, step);
  else
    centreContacts<D, false>(p, c, first, last, step);
}

// In the order of the contacts, since an automaton may be in several of them. To add 0 to what a
// row does not change is nothing, as no sum is -0.
// \tparam PARTS  a row of a contact has so many fours
template<class D, int PARTS>
void addRowsOf(const Pairs &p, const ViscousColumns &c, int first, int last, const double *values,
               double *sums)
{
  constexpr int stride = D::rows.force.length / 4;
  Row4 signs[PARTS];
  for (int m = 0; m < 4 * PARTS; m++)
    signs[m / 4][m % 4] = signOf<D::rows.dimension>(m);
  double *const forces = sums + D::rows.force.force;
  for (int at = first; at < last; at++) {
    const int k = c.pair[at];
    for (int part = 0; part < PARTS; part++) {
      const Row4 row = *rowOf<Row4>(values, PARTS * at + part);
      *rowOf<Row4>(forces, stride * p.i[k] + part) += row;
      *rowOf<Row4>(forces, stride * p.j[k] + part) += signs[part] * row;
    }
  }
}

template<class D>
void addNormalPass(const Pairs &p, const ViscousColumns &c, int first, int last, double *sums)
{
  addRowsOf<D, 1>(p, c, first, last, c.normal, sums);
}

template<class D>
void addAlongPass(const Pairs &p, const ViscousColumns &c, double *sums)
{
  addRowsOf<D, Pushes<D>::parts>(p, c, 0, c.n, c.along, sums);
}

template<class D>
constexpr ViscousPasses passesOf()
{
  return {findViscous, slipPass<D>, centrePass<D>, addNormalPass<D>, addAlongPass<D>};
}

} // namespace

extern const ViscousPasses planeViscous = passesOf<Plane>();
extern const ViscousPasses planeIsochoricViscous = passesOf<PlaneIsochoric>();
extern const ViscousPasses spaceViscous = passesOf<Space>();
extern const ViscousPasses spaceIsochoricViscous = passesOf<SpaceIsochoric>();

} // namespace mca::MCA_ISA
