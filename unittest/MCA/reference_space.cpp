// SPDX-License-Identifier: GPL-2.0-or-later
#include "reference_space.h"

#include <algorithm>
#include <cmath>

namespace reference::space {

void Sample::updateImages()
{
  for (size_t k = owned; k < automata.size(); k++) {
    automata[k] = automata[owner[k]];
    automata[k].x += shift[k];
  }
}

namespace {

struct View { // geometry of a contact
  double r, d, eps, e;
  Vector3d n;
};

View view(const Sample &s, const ReferenceContact &c)
{
  const Automaton &a = s.automata[c.i], &b = s.automata[c.j];
  View w;
  w.r = (b.x - a.x).norm();
  w.n = (b.x - a.x) / w.r;
  w.d = (s.materials[a.type].diameter + s.materials[b.type].diameter) / 2;
  w.eps = normalStrain(s.laws, w.r / w.d);
  w.e = w.eps - c.now.plastic;
  return w;
}

bool linked(const State &state)
{
  return state.kind > 0;
}

bool touches(const ReferenceContact &c, const View &w)
{
  return linked(c.now) || pressed(w.e);
}

// its weight in the flow of its automata
double flows(const Sample &s, const ReferenceContact &c, const View &w)
{
  return flowWeight(s.laws, s.materials[s.automata[c.i].type], s.materials[s.automata[c.j].type],
                    c.now.kind, w.e);
}

// volume of a cell in units of d^3, from the packings' lattice constants
double cellVolume(const mca::Packing &p)
{
  return p.coordination == 12 ? std::pow(std::sqrt(2.0), 3) / 4 : 1;
}

void moveShear(const Sample &s, ReferenceContact &c, double dt)
{
  if (dt > 0)
    c.now = c.next;
  if (!linked(c.now)) {
    c.now.gamma = Vector3d::Zero(); // gammaTotal holds the plastic work while pressed together
    return;
  }
  const Automaton &a = s.automata[c.i], &b = s.automata[c.j];
  const Vector3d there = b.x - a.x, old = there - (b.v - a.v) * dt;
  const Vector3d phi = (a.omega + b.omega) / 2 * dt;
  Matrix3d turn = Matrix3d::Identity();
  if (phi.norm() > 0)
    turn = Eigen::AngleAxisd(phi.norm(), phi.normalized()).toRotationMatrix();
  const Vector3d from = turn * old.normalized(), to = there.normalized();
  const Matrix3d swing = Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
  const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
  const Vector3d way = to * from.dot(to) - from;
  const Vector3d growth = angle > 0 ? Vector3d(angle * way.normalized()) : Vector3d::Zero();
  for (Vector3d *shear : {&c.now.gamma, &c.now.gammaTotal})
    *shear = swing * (turn * *shear) + growth;
}

void collectMeans(Sample &s)
{
  for (auto &a : s.automata) {
    a.mean = a.energy = a.centre = a.taken = a.flowing = 0;
    a.stress.setZero();
    a.force.setZero();
    a.torque.setZero();
  }
  for (int k = 0; k < s.owned; k++)
    s.automata[k].sum = keepsVolume(s.laws) ? s.automata[k].kept : 0;
  for (const auto &c : s.contacts) {
    const View w = view(s, c);
    for (int side : {c.i, c.j}) {
      Automaton &a = s.automata[s.owner[side]];
      a.taken += roomTaken(w.r / w.d);
      if (touches(c, w))
        a.sum += w.e;
    }
  }
  for (auto &a : s.automata) {
    const mca::Material &m = s.materials[a.type];
    a.mean = bulkModulus(m) * 3 / s.packing.coordination * a.sum;
    a.room = roomPressure(s.laws, m, a.taken, 3, s.packing.coordination);
    a.keptNext = keptNext(s.laws, a.kept, a.sum);
  }
}

// elastic stresses of a touching contact: the mean of what both sides answer
void elasticStresses(const Sample &s, const ReferenceContact &c, const View &w, double &sigma,
                     Vector3d &tau)
{
  sigma = 0;
  tau.setZero();
  for (int side : {c.i, c.j}) {
    const Automaton &a = s.automata[s.owner[side]];
    const mca::Material &m = s.materials[a.type];
    sigma += (2 * shearModulus(m) * w.e + meanWeight(s.laws, m) * a.mean) / 2;
    tau += 2 * shearModulus(m) * c.now.gamma / 2;
  }
}

// of both automata of a contact
Matrix3d shareOf(const Sample &s, const View &w, double sigma, const Vector3d &tau)
{
  const Matrix3d share = w.n * (sigma * w.n + tau).transpose();
  return 3.0 / s.packing.coordination * (share + share.transpose()) / 2;
}

double intensityOf(const Matrix3d &stress)
{
  return std::sqrt(1.5) * (stress - stress.trace() / 3 * Matrix3d::Identity()).norm();
}

void collectStresses(Sample &s)
{
  const double weight = 3.0 / s.packing.coordination;
  for (const auto &c : s.contacts) {
    const View w = view(s, c);
    if (!touches(c, w))
      continue;
    double sigma;
    Vector3d tau;
    elasticStresses(s, c, w, sigma, tau);
    for (int side : {c.i, c.j}) {
      Automaton &a = s.automata[s.owner[side]];
      a.stress += shareOf(s, w, sigma, tau);
      a.energy +=
          weight * shearModulus(s.materials[a.type]) * (w.e * w.e + c.now.gamma.squaredNorm());
      a.flowing += flows(s, c, w);
      a.centre += flows(s, c, w) * sigma;
    }
  }
  for (int k = 0; k < s.owned; k++) {
    Automaton &a = s.automata[k];
    const mca::Material &m = s.materials[a.type];
    a.energy += (meanWeight(s.laws, m) * a.mean * a.mean + a.room * a.room) / 2 / bulkModulus(m);
    a.energy *= cellVolume(s.packing) * std::pow(m.diameter, 3);
    a.intensity = intensityOf(a.stress);
    const double limit = yieldStress(m, a.kappa);
    a.centre = a.flowing > 0 ? a.centre / a.flowing : 0;
    const bool yields = s.laws.plasticity.word() != "none" && a.flowing > 0 && a.intensity > limit;
    a.factor = yields ? std::fmax(limit / a.intensity, 1 - mostReturned(s.laws, m, 3)) : 1;
  }
}

// elastic stresses, and those of a contact that flows after the returns of both automata
// and the work of the stretch of shear, as of returnedSquares()
double contactStresses(const Sample &s, const ReferenceContact &c, const View &w, double &trial,
                       double &sigma, Vector3d &tau)
{
  const Automaton &a = s.automata[s.owner[c.i]], &b = s.automata[s.owner[c.j]];
  trial = sigma = 0;
  tau.setZero();
  if (!touches(c, w))
    return 0;
  elasticStresses(s, c, w, trial, tau);
  sigma = trial;
  const double weight = flows(s, c, w);
  if (weight == 0)
    return 0;
  sigma -= weight / 2 * ((1 - a.factor) * (trial - a.centre) + (1 - b.factor) * (trial - b.centre));
  const double left = (a.factor + b.factor) / 2;
  tau *= left;
  const LinkView l = {s.laws, s.materials[a.type], s.materials[b.type], 3};
  const double before = sigma;
  if (keepsVolume(s.laws) && linked(c.now))
    sigma = stretched(l, sigma,
                      (c.now.gammaTotal - left * c.now.gamma).squaredNorm() -
                          (c.now.gammaTotal - c.now.gamma).squaredNorm(),
                      (shearModulus(l.a) + shearModulus(l.b)) / 2 *
                          (c.now.gamma.squaredNorm() - (left * c.now.gamma).squaredNorm()));
  const double stretch = left < 1 ? before * (before - sigma) / (1 - left) : 0;
  if (!linked(c.now))
    sigma = flownUnlinked(l, sigma, trial, c.now.plastic);
  return stretch;
}

// the returns again, with the stresses as the first ones leave them
void yieldAgain(Sample &s)
{
  std::vector<Matrix3d> after(s.owned, Matrix3d::Zero());
  std::vector<double> squares(s.owned, 0);
  for (const auto &c : s.contacts) {
    const View w = view(s, c);
    double trial, sigma;
    Vector3d tau;
    const double stretch = contactStresses(s, c, w, trial, sigma, tau);
    for (int side : {c.i, c.j})
      after[s.owner[side]] += shareOf(s, w, sigma, tau);
    const double weight = touches(c, w) ? flows(s, c, w) : 0;
    if (weight == 0)
      continue;
    elasticStresses(s, c, w, trial, tau);
    for (int side : {c.i, c.j})
      squares[s.owner[side]] += weight * std::pow(trial - s.automata[s.owner[side]].centre, 2) +
                                tau.squaredNorm() + stretch;
  }
  for (int k = 0; k < s.owned; k++) {
    Automaton &a = s.automata[k];
    const mca::Material &m = s.materials[a.type];
    const bool corrected = s.laws.steps.word() == "corrected" && a.factor < 1;
    if (corrected) {
      const double taken = a.intensity - intensityOf(after[k]);
      const double times = taken > 0 ? (a.intensity - yieldStress(m, a.kappa)) / taken : 2;
      const double most = mostReturned(s.laws, m, 3);
      a.factor = std::fmax(1 - most, 1 - (1 - a.factor) * std::fmin(2, times));
    }
    const double strain =
        corrected && keepsVolume(s.laws)
            ? strainOfWork(squares[k] * 3 / s.packing.coordination, a.intensity, shearModulus(m))
            : std::fmin(1, a.flowing) * a.intensity / 3 / shearModulus(m);
    a.kappaNext = a.kappa + (1 - a.factor) * strain;
    a.work = plasticWork(m, a.kappaNext) - plasticWork(m, a.kappa);
  }
}

// stress tensor at the contact: what its normal and shear stress make, and in its face the mean of
// both automata, whose deviators the returns have shortened
Matrix3d localStress(const Sample &s, const ReferenceContact &c, const View &w, double sigma,
                     const Vector3d &tau)
{
  const Matrix3d face = Matrix3d::Identity() - w.n * w.n.transpose();
  Matrix3d mean = Matrix3d::Zero();
  for (int side : {c.i, c.j}) {
    const Automaton &a = s.automata[s.owner[side]];
    const Matrix3d pressure = a.stress.trace() / 3 * Matrix3d::Identity();
    mean += (pressure + a.factor * (a.stress - pressure)) / 2;
  }
  return face * mean * face + sigma * w.n * w.n.transpose() + w.n * tau.transpose() +
         tau * w.n.transpose();
}

// plastic work of both automata since they are pressed together
double workOf(const Sample &s, const ReferenceContact &c, const View &w)
{
  if (s.laws.linkWork.word() == "none" || linked(c.now) || !pressed(w.e))
    return 0;
  return c.now.gammaTotal.x() + (s.automata[s.owner[c.i]].work + s.automata[s.owner[c.j]].work) / 2;
}

double viscosity(const Sample &s, const ReferenceContact &c)
{
  const mca::Material &ma = s.materials[s.automata[c.i].type];
  const mca::Material &mb = s.materials[s.automata[c.j].type];
  return s.laws.viscosity.word() == "none" ? 0 : (ma.viscosity + mb.viscosity) / 2;
}

double contactArea(const Sample &s, const View &w)
{
  return 6 * cellVolume(s.packing) / s.packing.coordination * w.d * w.d;
}

void applyContact(Sample &s, ReferenceContact &c)
{
  const View w = view(s, c);
  Automaton &a = s.automata[s.owner[c.i]], &b = s.automata[s.owner[c.j]];
  const mca::Material &ma = s.materials[a.type], &mb = s.materials[b.type];
  double trial, sigma;
  Vector3d tau;
  contactStresses(s, c, w, trial, sigma, tau);
  const double twoG = shearModulus(ma) + shearModulus(mb);
  c.next = c.now;
  const double work = workOf(s, c, w);
  const LinkView load = {s.laws,
                         ma,
                         mb,
                         3,
                         w.eps,
                         linked(c.now) ? c.now.gammaTotal.norm() : 0,
                         w.e - (flows(s, c, w) > 0 ? (trial - sigma) / twoG : 0),
                         tau.norm() / twoG,
                         sigma,
                         tau.norm(),
                         a.mean,
                         b.mean,
                         localStress(s, c, w, sigma, tau)};
  const double room = roomStress(w.r / w.d, a.room, b.room);
  c.next.kind = nextKind(s.laws, ma, mb, c.now.kind, sigma, tau.norm(), bulkBreaks(load),
                         healedBreaks(load), work, w.eps < 0 ? room : 0);
  const bool far = w.eps >= std::fmax(ma.breakingStrain, mb.breakingStrain);
  c.next.kind = wornKind(s.laws, c.now.kind, c.next.kind, far);
  if (flows(s, c, w) > 0)
    c.next.plastic += (trial - sigma) / twoG;
  c.next.gamma = tau / twoG;
  if (!linked(c.now) || !linked(c.next))
    c.next.gamma = c.next.gammaTotal = Vector3d::Zero();
  if (!linked(c.next))
    c.next.gammaTotal.x() = work;
  if (linked(c.now) && !linked(c.next) && keepsVolume(s.laws))
    for (Automaton *side : {&a, &b})
      side->left += std::fmax(0, w.eps - c.next.plastic);
  else if (!linked(c.now) && w.e > 0 && w.eps < 0 && room < 0)
    c.next.plastic = w.eps; // dented, without room: they touch
  else if (!linked(c.next) && w.eps > std::fmax(c.next.plastic, 0))
    c.next.plastic = 0;
  if (c.next.kind != c.now.kind && (linked(c.now) || linked(c.next)))
    s.changed++;

  const double S = contactArea(s, w), area = actingArea(s.laws, S, w.r / w.d);
  // compression and viscosity of what is not linked any more, never tension
  Vector3d drag(0, 0, 0);
  if (!linked(c.now) || !linked(c.next)) {
    const double elastic = linked(c.now) ? trial : sigma;
    const double push = viscosity(s, c) * c.speed / w.d * S; // a force
    sigma = pressed(w.e) ? unlinkedStress(s.laws, elastic, push / area) : 0;
    tau.setZero();
    if (pressed(w.e) && s.laws.viscosity.word() == "both")
      drag = viscosity(s, c) / w.d * c.slip;
  }
  const Vector3d force = area * (sigma + room) * w.n + S * (w.d / w.r * tau + drag);
  const Vector3d torque = S * w.n.cross(w.d / 2 * tau + w.r / 2 * drag);
  a.force += force;
  b.force -= force;
  a.torque += torque;
  b.torque += torque;
}

void applyContacts(Sample &s)
{
  s.changed = 0;
  for (auto &a : s.automata) {
    a.force.setZero();
    a.torque.setZero();
    a.left = 0;
  }
  for (auto &c : s.contacts)
    applyContact(s, c);
}

// of both surfaces where they touch
void setSpeeds(ReferenceContact &c, const View &w, const Vector3d &v, const Vector3d &omegas)
{
  const Vector3d surface = v - w.r / 2 * omegas.cross(w.n);
  c.speed = surface.dot(w.n);
  c.slip = surface - c.speed * w.n;
}

// those of half a step ago
void setOldSpeeds(const Sample &s, ReferenceContact &c)
{
  const Automaton &a = s.automata[c.i], &b = s.automata[c.j];
  setSpeeds(c, view(s, c), b.v - a.v, a.omega + b.omega);
}

// the present ones, from the forces that the old ones make
void setPresentSpeeds(const Sample &s, ReferenceContact &c, double dt)
{
  const View w = view(s, c);
  double perMass = 0, perInertia = 0;
  Vector3d moved(0, 0, 0), turned(0, 0, 0);
  for (int side : {c.i, c.j}) {
    const Automaton &a = s.automata[s.owner[side]];
    const mca::Material &m = s.materials[a.type];
    const double mass = m.density * cellVolume(s.packing) * std::pow(m.diameter, 3);
    const double inertia = mass * m.diameter * m.diameter / 10;
    if (!a.held) {
      moved += (side == c.j ? 1 : -1) * a.force / mass * dt / 2;
      perMass += 1 / mass;
    }
    if (!a.heldSpin) {
      turned += a.torque / inertia * dt / 2;
      perInertia += 1 / inertia;
    }
  }
  // with slip three quarters of what damps the turning of all, in contacts' own parts of it
  const bool slips = s.laws.viscosity.word() == "both";
  const double many = slips ? 0.75 / (1.4 / (s.packing.coordination * 2 / 3.0)) : 1;
  const double damping = many * viscosity(s, c) * contactArea(s, w) / w.d;
  ReferenceContact kick;
  setSpeeds(kick, w, moved, turned);
  c.speed += kick.speed / (1 + damping * perMass * dt / 2);
  c.slip += kick.slip / (1 + damping * (perMass + w.r * w.r / 4 * perInertia) * dt / 2);
}

} // namespace

void step(Sample &s, double dt)
{
  for (auto &c : s.contacts)
    moveShear(s, c, dt);
  collectMeans(s);
  collectStresses(s);
  yieldAgain(s);
  for (auto &c : s.contacts)
    setOldSpeeds(s, c);
  applyContacts(s);
  if (s.laws.steps.word() == "corrected") {
    for (auto &c : s.contacts)
      setPresentSpeeds(s, c, dt);
    applyContacts(s);
  }
  for (int k = 0; k < s.owned; k++) { // the whole stress, and what the next state keeps
    Automaton &a = s.automata[k];
    a.keptNext += a.left;
    a.mean -= a.room;
    a.stress -= a.room * Matrix3d::Identity();
  }
}

} // namespace reference::space
