// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/line/static_contact.h"

#include "base/errors.h"
#include "base/si.h"
#include "creep/line/line_contacts.h"

#include <chrono>
#include <fmt/format.h>

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;

/// Mean place of the intervals, in cells.
double centreOf(const std::vector<ContactInterval> &intervals)
{
  double moment = 0.0;
  for (const ContactInterval &interval : intervals)
    moment += 0.5 * (interval.left + interval.right) * interval.length();
  return moment / contactLength(intervals);
}

ContactFields fieldsOf(const ContactSetup &setup, const StaticTraction &result, const Vector &mu)
{
  ContactFields fields;
  fields.pressure = setup.normal.pressure * setup.hertz.modulus;
  fields.traction = result.traction * setup.hertz.modulus;
  fields.mu = mu;
  fields.slip = fields.temperature = Vector::Zero(setup.cells);
  fields.state.assign(setup.cells, Adhesion::Apart);
  for (int i = 0; i < setup.cells; ++i)
    if (setup.normal.pressure[i] > 0.0)
      fields.state[i] = Adhesion::Slip;
  for (const ContactInterval &interval : result.stick)
    for (int i = interval.first; i <= interval.last; ++i)
      fields.state[i] = Adhesion::Stick;
  return fields;
}

} // namespace

const std::vector<Column<StaticPoint>> &staticColumns()
{
  using P = StaticPoint;
  static const std::vector<Column<P>> table = {
      {"force_ratio", "1", 1.0, "T/(mu N)", kept<&P::forceRatio>, nowhere, nowhere, following(10)},
      {"traction_ratio", "1", 1.0, "T/N", kept<&P::tractionRatio>, nowhere, nowhere, following(10)},
      {"traction", "N/mm", newtonPerMm, "T", kept<&P::traction>, nowhere, nowhere, following(10)},
      {"mu", "1", 1.0, "friction coefficient", kept<&P::mu>, nowhere, nowhere, following(10)},
      {"stick_length", "mm", mm, "of all stick zones", kept<&P::stickLength>, nowhere, nowhere,
       following(10)},
      {"stick_centre", "mm", mm, "mean place of the stick zones", kept<&P::stickCentre>, nowhere,
       nowhere, following(6)}};
  return table;
}

StaticTraction staticTraction(HalfPlane &halfPlane, const NormalContactProblem &problem,
                              const NormalContactResult &normal, double mu, double forceRatio)
{
  if (!(forceRatio >= 0.0 && forceRatio < 1.0))
    throw Error(ExitCode::BadInput,
                fmt::format("static tangential force: T/(mu N) = {} is not in [0, 1)", forceRatio));
  if (forceRatio == 0.0)
    return {Vector::Zero(normal.pressure.size()), contactIntervals(normal, halfPlane.boundary())};
  // Pressure and traction have the same influence, and inside the contact under N - T/mu both
  // pressures follow the same profile: the difference moves it as a whole, so it sticks. Outside of
  // it |q| = mu p (Ciavarella, Int. J. Solids Struct. 35 (1998) 2349; Jaeger, J. Tribol. 120 (1998)
  // 677).
  NormalContactProblem unloaded = problem;
  unloaded.load *= 1.0 - forceRatio;
  const NormalContactResult stuck = solveNormalContact(halfPlane, unloaded);
  return {mu * (normal.pressure - stuck.pressure), contactIntervals(stuck, halfPlane.boundary())};
}

StaticCases solveStaticCases(const StaticSpecification &specification, const FrictionLaw &law,
                             const SweepOptions &options)
{
  const auto begin = std::chrono::steady_clock::now();
  const double limit = specification.physics.pressureLimit(law, 0.0);
  StaticCases cases;
  cases.contacts =
      prepareContacts(specification.contact, specification.surface, limit, false, options);
  cases.warnings = contactDoubts(cases.contacts, specification.contact,
                                 specification.physics.strengthInUse(law));
  const int total = static_cast<int>(cases.contacts.size() * specification.forceRatio.size());
  for (const ContactSetup &setup : cases.contacts) {
    HalfPlane halfPlane(setup.cells, setup.boundary);
    const Vector cold = Vector::Zero(setup.cells); // nothing slides, nothing heats
    const FrictionState state{setup.normal.pressure, 0.0, cold};
    const Vector mu = law.mu(state);
    cases.use.include(law.use(state));
    for (double force : specification.forceRatio) {
      if (options.stopped())
        throw Error(ExitCode::Interrupted,
                    "interrupted; mode static starts again from the beginning");
      const StaticTraction result =
          staticTraction(halfPlane, setup.problem(limit), setup.normal, mu[0], force);
      StaticPoint point;
      point.profile = setup.surface.profile;
      point.forceRatio = force;
      point.mu = mu[0];
      point.tractionRatio = force * mu[0];
      point.traction = result.traction.sum() * setup.hertz.modulus * setup.cellSize;
      point.stickLength = contactLength(result.stick) * setup.cellSize;
      point.stickCentre = setup.position(0) + centreOf(result.stick) * setup.cellSize;
      cases.points.push_back(point);
      const int number = static_cast<int>(cases.points.size());
      if (specification.fields.holds(number, total))
        cases.fields[number] = fieldsOf(setup, result, mu);
      if (options.progress)
        options.progress(static_cast<int>(cases.points.size()), total);
    }
  }
  if (const std::string warning = law.warning(cases.use); !warning.empty())
    cases.warnings.push_back(warning);
  cases.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return cases;
}

} // namespace wheelrail
