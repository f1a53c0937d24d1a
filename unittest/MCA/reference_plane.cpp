// SPDX-License-Identifier: GPL-2.0-or-later
#include "reference_plane.h"

#include <cmath>
#include <stdexcept>

namespace reference {

void Sample::add(const Automaton &a)
{
  if (owned != static_cast<int>(automata.size()))
    throw std::logic_error("images come last");
  owner.push_back(owned++);
  shiftX.push_back(0);
  shiftY.push_back(0);
  automata.push_back(a);
}

void Sample::addImage(int i, double sx, double sy)
{
  owner.push_back(i);
  shiftX.push_back(sx);
  shiftY.push_back(sy);
  automata.push_back(automata[i]);
  automata.back().x += sx;
  automata.back().y += sy;
}

void Sample::updateImages()
{
  for (size_t k = owned; k < automata.size(); k++) {
    automata[k] = automata[owner[k]];
    automata[k].x += shiftX[k];
    automata[k].y += shiftY[k];
  }
}

namespace {

struct View { // geometry of a contact
  double r, nx, ny, tx, ty, e, eps, d;
};

View view(const Sample &s, const ReferenceContact &c)
{
  const Automaton &a = s.automata[c.i], &b = s.automata[c.j];
  View w;
  w.r = std::hypot(b.x - a.x, b.y - a.y);
  w.nx = (b.x - a.x) / w.r;
  w.ny = (b.y - a.y) / w.r;
  w.tx = -w.ny;
  w.ty = w.nx;
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

// lambda of Hooke's law in the plane, sigma = 2G eps + lambda tr(eps)
double lame(const Sample &s, const mca::Material &m)
{
  const double E = m.youngsModulus, nu = m.poissonsRatio;
  if (s.laws.elasticity.word() == "pairwise")
    return 0;
  return s.laws.plane.word() == "stress" ? E * nu / (1 - nu * nu)
                                         : E * nu / (1 + nu) / (1 - 2 * nu);
}

void moveShear(const Sample &s, ReferenceContact &c, double dt)
{
  if (dt > 0)
    c.now = c.next;
  if (!linked(c.now)) {
    c.now.gamma = 0; // gammaTotal holds the plastic work while pressed together
    return;
  }
  const Automaton &a = s.automata[c.i], &b = s.automata[c.j];
  const double x = b.x - a.x, y = b.y - a.y;
  const double x0 = x - (b.vx - a.vx) * dt, y0 = y - (b.vy - a.vy) * dt;
  const double turn = std::atan2(x0 * y - y0 * x, x0 * x + y0 * y);
  const double dgamma = turn - (a.omega + b.omega) * dt / 2;
  c.now.gamma += dgamma;
  c.now.gammaTotal += dgamma;
}

void collectMeans(Sample &s)
{
  for (auto &a : s.automata)
    a.trace = a.mean = a.taken = a.xx = a.yy = a.xy = a.zz = a.energy = a.fx = a.fy = a.torque = 0;
  for (int k = 0; k < s.owned; k++)
    s.automata[k].trace = keepsVolume(s.laws) ? s.automata[k].kept / 3 : 0;
  for (const auto &c : s.contacts) {
    const View w = view(s, c);
    for (int side : {c.i, c.j}) {
      Automaton &a = s.automata[s.owner[side]];
      a.taken += roomTaken(w.r / w.d);
      if (touches(c, w))
        a.trace += w.e / 3;
    }
  }
  for (auto &a : s.automata) {
    const mca::Material &m = s.materials[a.type];
    a.mean = s.laws.plane.word() == "stress" ? 2.0 / 3 * (shearModulus(m) + lame(s, m)) * a.trace
                                             : bulkModulus(m) * a.trace;
    a.room = roomPressure(s.laws, m, a.taken, 2, 6);
    a.keptNext = keptNext(s.laws, a.kept, 3 * a.trace);
  }
}

// its weight in the flow of its automata
double flows(const Sample &s, const ReferenceContact &c, const View &w)
{
  return flowWeight(s.laws, s.materials[s.automata[c.i].type], s.materials[s.automata[c.j].type],
                    c.now.kind, w.e);
}

// elastic stresses of a touching contact: the mean of what both sides answer
void elasticStresses(const Sample &s, const ReferenceContact &c, const View &w, double &sigma,
                     double &tau)
{
  sigma = tau = 0;
  for (int side : {c.i, c.j}) {
    const Automaton &a = s.automata[s.owner[side]];
    const mca::Material &m = s.materials[a.type];
    sigma += (2 * shearModulus(m) * w.e + lame(s, m) * a.trace) / 2;
    tau += 2 * shearModulus(m) * c.now.gamma / 2;
  }
}

void addShare(Automaton &a, const View &w, double sigma, double tau)
{
  const double fx = sigma * w.nx + tau * w.tx, fy = sigma * w.ny + tau * w.ty;
  a.xx += w.nx * fx / 3;
  a.yy += w.ny * fy / 3;
  a.xy += (w.nx * fy + w.ny * fx) / 2 / 3;
}

// von Mises from the deviator, or from the largest shear in the plane
double intensityOf(const Sample &s, const Automaton &a)
{
  if (keepsVolume(s.laws))
    return std::sqrt(3.0) * std::hypot((a.xx - a.yy) / 2, a.xy);
  const double p = (a.xx + a.yy + a.zz) / 3;
  return std::sqrt(1.5 * (std::pow(a.xx - p, 2) + std::pow(a.yy - p, 2) + std::pow(a.zz - p, 2) +
                          2 * a.xy * a.xy));
}

void collectStresses(Sample &s)
{
  for (auto &a : s.automata)
    a.centre = a.flowing = 0;
  for (const auto &c : s.contacts) {
    const View w = view(s, c);
    if (!touches(c, w))
      continue;
    double sigma, tau;
    elasticStresses(s, c, w, sigma, tau);
    for (int side : {c.i, c.j}) {
      Automaton &a = s.automata[s.owner[side]];
      addShare(a, w, sigma, tau);
      a.energy += shearModulus(s.materials[a.type]) / 3 * (w.e * w.e + c.now.gamma * c.now.gamma);
      a.flowing += flows(s, c, w);
      a.centre += flows(s, c, w) * sigma;
    }
  }
  for (int k = 0; k < s.owned; k++) {
    Automaton &a = s.automata[k];
    const mca::Material &m = s.materials[a.type];
    a.energy += lame(s, m) * a.trace * a.trace / 2 + a.room * a.room / 2 / bulkModulus(m);
    a.energy *= std::sqrt(3.0) / 2 * m.diameter * m.diameter * s.thickness;
    a.zz = 3 * a.mean - a.xx - a.yy;
    a.intensity = intensityOf(s, a);
    a.centre = !keepsVolume(s.laws) ? a.mean : a.flowing > 0 ? a.centre / a.flowing : 0;
  }
}

struct Stress {
  double trial, sigma, tau;
  double stretch; // work of the stretch of shear, as of returnedSquares()
};

Stress contactStresses(const Sample &s, const ReferenceContact &c, const View &w)
{
  const Automaton &a = s.automata[s.owner[c.i]], &b = s.automata[s.owner[c.j]];
  Stress out{};
  if (!touches(c, w))
    return out;
  elasticStresses(s, c, w, out.trial, out.tau);
  out.sigma = out.trial;
  const double weight = flows(s, c, w);
  if (weight == 0)
    return out;
  out.sigma -= weight / 2 *
               ((1 - a.factor) * (out.trial - a.centre) + (1 - b.factor) * (out.trial - b.centre));
  const double left = (a.factor + b.factor) / 2;
  out.tau *= left;
  const LinkView l = {s.laws, s.materials[a.type], s.materials[b.type], 2};
  if (keepsVolume(s.laws) && linked(c.now)) {
    const double before = out.sigma;
    out.sigma = stretched(l, out.sigma,
                          std::pow(c.now.gammaTotal - left * c.now.gamma, 2) -
                              std::pow(c.now.gammaTotal - c.now.gamma, 2),
                          (shearModulus(l.a) + shearModulus(l.b)) / 2 *
                              (std::pow(c.now.gamma, 2) - std::pow(left * c.now.gamma, 2)));
    out.stretch = left < 1 ? before * (before - out.sigma) / (1 - left) : 0;
  }
  if (!linked(c.now))
    out.sigma = flownUnlinked(l, out.sigma, out.trial, c.now.plastic);
  return out;
}

// stress intensities with the contacts as they are after the returns
std::vector<double> returnedIntensities(const Sample &s)
{
  std::vector<Automaton> after(s.automata.begin(), s.automata.begin() + s.owned);
  for (auto &a : after)
    a.xx = a.yy = a.xy = 0;
  for (const auto &c : s.contacts) {
    const View w = view(s, c);
    const Stress p = contactStresses(s, c, w);
    for (int side : {c.i, c.j})
      addShare(after[s.owner[side]], w, p.sigma, touches(c, w) ? p.tau : 0);
  }
  std::vector<double> all;
  for (auto &a : after) {
    a.zz = 3 * a.mean - a.xx - a.yy;
    all.push_back(intensityOf(s, a));
  }
  return all;
}

// what the first returns set free, over (1-M)/4G S d: the squares of the stresses that flow, of
// normal ones against the centre, and the work of the stretch of shear
std::vector<double> returnedSquares(const Sample &s)
{
  std::vector<double> all(s.owned, 0);
  for (const auto &c : s.contacts) {
    const View w = view(s, c);
    const double weight = touches(c, w) ? flows(s, c, w) : 0;
    if (weight == 0)
      continue;
    double trial, tau;
    elasticStresses(s, c, w, trial, tau);
    for (int side : {c.i, c.j}) {
      const double apart = trial - s.automata[s.owner[side]].centre;
      all[s.owner[side]] += weight * apart * apart + tau * tau + contactStresses(s, c, w).stretch;
    }
  }
  return all;
}

void yield(Sample &s)
{
  for (int k = 0; k < s.owned; k++) {
    Automaton &a = s.automata[k];
    const double limit = yieldStress(s.materials[a.type], a.kappa);
    const bool yields = s.laws.plasticity.word() != "none" && a.flowing > 0 && a.intensity > limit;
    const double most = mostReturned(s.laws, s.materials[a.type], 2);
    a.factor = yields ? std::fmax(limit / a.intensity, 1 - most) : 1;
  }
  const std::vector<double> after = returnedIntensities(s), squares = returnedSquares(s);
  for (int k = 0; k < s.owned; k++) {
    Automaton &a = s.automata[k];
    const mca::Material &m = s.materials[a.type];
    const bool corrected = s.laws.steps.word() == "corrected" && a.factor < 1;
    if (corrected) {
      const double taken = a.intensity - after[k];
      const double times = taken > 0 ? (a.intensity - yieldStress(m, a.kappa)) / taken : 2;
      const double most = mostReturned(s.laws, m, 2);
      a.factor = std::fmax(1 - most, 1 - (1 - a.factor) * std::fmin(2, times));
    }
    const double strain = corrected && keepsVolume(s.laws)
                              ? strainOfWork(squares[k] / 3, a.intensity, shearModulus(m))
                              : std::fmin(1, a.flowing) * a.intensity / 3 / shearModulus(m);
    a.kappaNext = a.kappa + (1 - a.factor) * strain;
    a.work = plasticWork(m, a.kappaNext) - plasticWork(m, a.kappa);
  }
}

// stress tensor at the contact along n, t and across the plane
Eigen::Matrix3d localStress(const Sample &s, const ReferenceContact &c, const View &w,
                            const Stress &p)
{
  double along = 0, across = 0;
  for (int side : {c.i, c.j}) {
    const Automaton &b = s.automata[s.owner[side]];
    const double stress =
        b.xx * w.tx * w.tx + b.yy * w.ty * w.ty + 2 * b.xy * w.tx * w.ty; // before the return
    const bool inPlane = keepsVolume(s.laws); // what acts across it does not flow
    const double centre = inPlane ? (b.xx + b.yy) / 2 : b.mean;
    along += (centre + b.factor * (stress - centre)) / 2;
    across += (inPlane ? b.zz : b.mean + b.factor * (b.zz - b.mean)) / 2;
  }
  Eigen::Matrix3d tensor;
  tensor << p.sigma, p.tau, 0, p.tau, along, 0, 0, 0, across;
  return tensor;
}

// plastic work of both automata since they are pressed together
double workOf(const Sample &s, const ReferenceContact &c, const View &w)
{
  if (s.laws.linkWork.word() == "none" || linked(c.now) || !pressed(w.e))
    return 0;
  return c.now.gammaTotal + (s.automata[s.owner[c.i]].work + s.automata[s.owner[c.j]].work) / 2;
}

double contactArea(const Sample &s, const View &w)
{
  return w.d * s.thickness / std::sqrt(3.0);
}

double viscosity(const Sample &s, const ReferenceContact &c)
{
  const mca::Material &ma = s.materials[s.automata[c.i].type];
  const mca::Material &mb = s.materials[s.automata[c.j].type];
  return s.laws.viscosity.word() == "none" ? 0 : (ma.viscosity + mb.viscosity) / 2;
}

// compression and viscosity, never tension; also of a link that breaks in this step
double unlinkedNormal(const Sample &s, const ReferenceContact &c, const View &w, const Stress &p)
{
  if (!pressed(w.e))
    return 0;
  const double sigma = linked(c.now) ? p.trial : p.sigma;
  const double S = contactArea(s, w), drag = viscosity(s, c) * c.speed / w.d * S; // a force
  return unlinkedStress(s.laws, sigma, drag / actingArea(s.laws, S, w.r / w.d));
}

// along t, of the second surface's motion past the first
double slipStress(const Sample &s, const ReferenceContact &c, const View &w)
{
  return s.laws.viscosity.word() == "both" && pressed(w.e) ? viscosity(s, c) * c.slip / w.d : 0;
}

void applyContact(Sample &s, ReferenceContact &c)
{
  const View w = view(s, c);
  const Stress p = contactStresses(s, c, w);
  const mca::Material &ma = s.materials[s.automata[c.i].type];
  const mca::Material &mb = s.materials[s.automata[c.j].type];
  const double twoG = shearModulus(ma) + shearModulus(mb);

  c.next = c.now;
  const LinkView load = {s.laws,
                         ma,
                         mb,
                         2,
                         w.eps,
                         linked(c.now) ? c.now.gammaTotal : 0,
                         w.e - (flows(s, c, w) > 0 ? (p.trial - p.sigma) / twoG : 0),
                         p.tau / twoG,
                         p.sigma,
                         p.tau,
                         s.automata[s.owner[c.i]].mean,
                         s.automata[s.owner[c.j]].mean,
                         localStress(s, c, w, p)};
  const double room =
      roomStress(w.r / w.d, s.automata[s.owner[c.i]].room, s.automata[s.owner[c.j]].room);
  c.next.kind = nextKind(s.laws, ma, mb, c.now.kind, p.sigma, p.tau, bulkBreaks(load),
                         healedBreaks(load), workOf(s, c, w), w.eps < 0 ? room : 0);
  const bool far = w.eps >= std::fmax(ma.breakingStrain, mb.breakingStrain);
  c.next.kind = wornKind(s.laws, c.now.kind, c.next.kind, far);
  if (flows(s, c, w) > 0)
    c.next.plastic += (p.trial - p.sigma) / twoG;
  c.next.gamma = p.tau / twoG;
  if (!linked(c.now) || !linked(c.next))
    c.next.gamma = c.next.gammaTotal = 0;
  if (!linked(c.next))
    c.next.gammaTotal = workOf(s, c, w);
  const bool leaves = linked(c.now) && !linked(c.next) && keepsVolume(s.laws);
  if (leaves)
    for (int side : {c.i, c.j})
      s.automata[s.owner[side]].left += std::fmax(0, w.eps - c.next.plastic);
  else if (!linked(c.now) && w.e > 0 && w.eps < 0 && room < 0)
    c.next.plastic = w.eps; // dented, without room: they touch
  else if (!linked(c.next) && w.eps > std::fmax(c.next.plastic, 0))
    c.next.plastic = 0;
  if (c.next.kind != c.now.kind && (linked(c.now) || linked(c.next)))
    s.changed++;

  const double S = contactArea(s, w);
  const bool holds = linked(c.now) && linked(c.next);
  const double normal = holds ? p.sigma : unlinkedNormal(s, c, w, p), tau = holds ? p.tau : 0;
  const double fn = (normal + room) * actingArea(s.laws, S, w.r / w.d), ft = tau * S * w.d / w.r;
  const double drag = holds ? 0 : slipStress(s, c, w) * S;
  const double fx = fn * w.nx + (ft + drag) * w.tx, fy = fn * w.ny + (ft + drag) * w.ty;
  Automaton &a = s.automata[s.owner[c.i]], &b = s.automata[s.owner[c.j]];
  a.fx += fx;
  a.fy += fy;
  b.fx -= fx;
  b.fy -= fy;
  a.torque += w.d / 2 * tau * S + w.r / 2 * drag;
  b.torque += w.d / 2 * tau * S + w.r / 2 * drag;
}

void applyContacts(Sample &s)
{
  s.changed = 0;
  for (auto &a : s.automata)
    a.fx = a.fy = a.torque = a.left = 0;
  for (auto &c : s.contacts)
    applyContact(s, c);
}

// those of half a step ago
void setOldSpeeds(const Sample &s, ReferenceContact &c)
{
  const View w = view(s, c);
  const Automaton &a = s.automata[c.i], &b = s.automata[c.j];
  c.speed = (b.vx - a.vx) * w.nx + (b.vy - a.vy) * w.ny;
  c.slip = (b.vx - a.vx) * w.tx + (b.vy - a.vy) * w.ty - w.r / 2 * (a.omega + b.omega);
}

// the present ones, from the forces that the old ones make
void setPresentSpeeds(const Sample &s, ReferenceContact &c, double dt)
{
  const View w = view(s, c);
  double kick = 0, perMass = 0, slipKick = 0, perInertia = 0;
  for (int side : {c.i, c.j}) {
    const Automaton &a = s.automata[s.owner[side]];
    const mca::Material &m = s.materials[a.type];
    const double mass = m.density * std::sqrt(3.0) / 2 * m.diameter * m.diameter * s.thickness;
    const double inertia = mass * m.diameter * m.diameter / 8, sign = side == c.j ? 1 : -1;
    if (!a.held) {
      kick += sign * (a.fx * w.nx + a.fy * w.ny) / mass * dt / 2;
      slipKick += sign * (a.fx * w.tx + a.fy * w.ty) / mass * dt / 2;
      perMass += 1 / mass;
    }
    if (!a.heldSpin) {
      slipKick -= w.r / 2 * a.torque / inertia * dt / 2;
      perInertia += 1 / inertia;
    }
  }
  // with slip three times a contact's own, a quarter of what damps the turning of all
  const double many = s.laws.viscosity.word() == "both" ? 3 : 1;
  const double damping = many * viscosity(s, c) * contactArea(s, w) / w.d;
  const double rate = damping * perMass;
  const double slipRate = damping * (perMass + w.r * w.r / 4 * perInertia);
  c.speed += kick / (1 + rate * dt / 2);
  c.slip += slipKick / (1 + slipRate * dt / 2);
}

} // namespace

// the whole stress of an automaton, and what the next state keeps
static void finish(Sample &s)
{
  for (int k = 0; k < s.owned; k++) {
    Automaton &a = s.automata[k];
    a.keptNext += a.left;
    for (double *stress : {&a.mean, &a.xx, &a.yy, &a.zz})
      *stress -= a.room;
  }
}

void step(Sample &s, double dt)
{
  for (auto &c : s.contacts)
    moveShear(s, c, dt);
  collectMeans(s);
  collectStresses(s);
  yield(s);
  for (auto &c : s.contacts)
    setOldSpeeds(s, c);
  applyContacts(s);
  if (s.laws.steps.word() == "corrected") {
    for (auto &c : s.contacts)
      setPresentSpeeds(s, c, dt);
    applyContacts(s);
  }
  finish(s);
}

} // namespace reference
