// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "base/random_number.h"
#include "contact/line/contact_interval.h"
#include "contact/normal_contact.h"
#include "contact_cases.h"
#include "shared/pi.h"

#include <Eigen/Dense>
#include <algorithm>
#include <gtest/gtest.h>

using namespace wheelrail;
using Vector = Eigen::VectorXd;
using contact_cases::cylinder;
using contact_cases::table2;

namespace {
using mcawr::pi;

/// What every solution has to fulfil, whatever the profile.
void expectOptimal(HalfPlane &plane, const NormalContactProblem &problem,
                   const NormalContactResult &result)
{
  const Vector gap =
      (problem.profile + plane.displacement(result.pressure)).array() - result.approach;
  EXPECT_NEAR(result.pressure.sum() / problem.load, 1.0, 1e-10);
  const double small = 1e-6 * problem.load;
  const bool isOne = problem.cellLimits.size() == 0;
  for (int i = 0; i < gap.size(); ++i) {
    const double limit = isOne ? problem.pressureLimit : problem.cellLimits[i];
    EXPECT_GE(result.pressure[i], 0.0);
    EXPECT_LE(result.pressure[i], limit);
    EXPECT_EQ(result.state[i] == CellState::Plastic, result.pressure[i] == limit);
    if (result.state[i] == CellState::Contact) {
      EXPECT_NEAR(gap[i], 0.0, small);
    }
    if (result.state[i] == CellState::Apart) {
      EXPECT_GT(gap[i], -small);
    }
    if (result.state[i] == CellState::Plastic) {
      EXPECT_LT(gap[i], small);
    }
  }
}

/// Slow reference: one cell a time joins or leaves, dense elimination on the set.
Vector denseContact(const NormalContactProblem &problem)
{
  const int n = static_cast<int>(problem.profile.size());
  std::vector<int> set(n);
  for (int i = 0; i < n; ++i)
    set[i] = i;
  while (true) {
    const int m = static_cast<int>(set.size());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(m + 1, m + 1);
    Vector b(m + 1);
    for (int i = 0; i < m; ++i) {
      for (int j = 0; j < m; ++j)
        a(i, j) = cellInfluence(set[i] - set[j]);
      a(i, m) = -1.0;
      a(m, i) = 1.0;
      b[i] = -problem.profile[set[i]];
    }
    b[m] = problem.load;
    const Vector x = a.fullPivLu().solve(b);
    Vector p = Vector::Zero(n);
    for (int i = 0; i < m; ++i)
      p[set[i]] = x[i];
    int worst = -1;
    for (int i = 0; i < n; ++i)
      if (p[i] < 0.0 && (worst < 0 || p[i] < p[worst]))
        worst = i;
    if (worst >= 0) {
      set.erase(std::find(set.begin(), set.end(), worst));
      continue;
    }
    double deepest = -1e-9;
    for (int i = 0; i < n; ++i) {
      double gap = problem.profile[i] - x[m];
      for (int j : set)
        gap += cellInfluence(i - j) * p[j];
      if (p[i] == 0.0 && gap < deepest) {
        deepest = gap;
        worst = i;
      }
    }
    if (worst < 0)
      return p;
    set.push_back(worst);
  }
}

/// A half-space over a patch of cells, with dense matrices: slow, and all that the solver may know.
class DensePatch : public HalfSpace {
 public:
  explicit DensePatch(const CellGrid &cells) : grid_(cells), compliance_(n(), n())
  {
    for (int i = 0; i < n(); ++i)
      for (int j = 0; j < n(); ++j)
        compliance_(i, j) = influence((i % grid_.nx - j % grid_.nx) * grid_.dx,
                                      (i / grid_.nx - j / grid_.nx) * grid_.dy);
    stiffness_ = compliance_.inverse();
  }

  const CellGrid &grid() const override { return grid_; }
  Vector displacement(const Vector &p) override { return compliance_ * p; }
  Vector tractionEstimate(const Vector &u) override { return stiffness_ * u; }
  double displacementScale(double sum) const override
  {
    return compliance_(0, 0) * sum / std::sqrt(n());
  }
  HalfSpace *coarser() override
  {
    if (grid_.nx < 20)
      return nullptr;
    coarser_ = std::make_unique<DensePatch>(
        CellGrid{grid_.nx / 2, grid_.ny / 2, 2.0 * grid_.dx, 2.0 * grid_.dy});
    return coarser_.get();
  }

 private:
  int n() const { return grid_.cells(); }
  /// Boussinesq's 1/(pi r) over a cell (Love 1929), E* = 1.
  double influence(double x, double y) const
  {
    double sum = 0.0;
    for (int a : {-1, 1})
      for (int b : {-1, 1}) {
        const double u = x + 0.5 * a * grid_.dx, v = y + 0.5 * b * grid_.dy;
        sum += a * b * (u * std::asinh(v / std::abs(u)) + v * std::asinh(u / std::abs(v)));
      }
    return sum / pi;
  }

  CellGrid grid_;
  Eigen::MatrixXd compliance_, stiffness_;
  std::unique_ptr<HalfSpace> coarser_;
};
} // namespace

TEST(NormalContact, HertzAt1024Cells)
{
  const int n = 1024;
  HalfPlane plane(n, Boundary::Free);
  const HertzContact hertz = table2();
  const double h = 4.0 * hertz.halfWidth / n;
  const NormalContactResult result = solveNormalContact(plane, cylinder(n));
  EXPECT_NEAR(result.peakPressure() * hertz.modulus / hertz.hertzPressure, 1.0, 3e-6);
  const auto intervals = contactIntervals(result, Boundary::Free);
  ASSERT_EQ(intervals.size(), 1u);
  EXPECT_NEAR(0.5 * contactLength(intervals) * h / hertz.halfWidth, 1.0, 1e-5);
  // The unknowns are the cells' uniform pressures, so Hertz' mean over each cell is their match;
  // his pressure at the cell centres differs from that mean by 6 % in the edge cells alone.
  const auto integral = [](double x) { // of sqrt(1 - x^2)
    const double inside = std::clamp(x, -1.0, 1.0);
    return 0.5 * (inside * std::sqrt(1.0 - inside * inside) + std::asin(inside));
  };
  double atCentres = 0.0, ofMeans = 0.0;
  for (int i = 0; i < n; ++i) {
    const double x = (i + 0.5 - 0.5 * n) * h, a = hertz.halfWidth;
    const double p = result.pressure[i] * hertz.modulus;
    const double mean =
        hertz.hertzPressure * (integral((x + 0.5 * h) / a) - integral((x - 0.5 * h) / a)) * a / h;
    ofMeans += std::abs(p - mean) * h / hertz.load;
    atCentres += std::abs(p - hertz.pressure(x)) * h / hertz.load;
  }
  EXPECT_LT(ofMeans, 2.1e-5);
  EXPECT_LT(atCentres, 3.1e-5);
  EXPECT_LT(result.iterations, 40);
}

TEST(NormalContact, GapOutsideIsHertz)
{
  const int n = 2048;
  HalfPlane plane(n, Boundary::Free);
  const HertzContact hertz = table2();
  const double h = 4.0 * hertz.halfWidth / n;
  const NormalContactResult result = solveNormalContact(plane, cylinder(n));
  for (double ratio : {1.1, 1.5, 1.9}) {
    const int cell = static_cast<int>(n / 2 + ratio * hertz.halfWidth / h);
    EXPECT_NEAR(result.gap[cell] * h * 1e6, hertz.gap((cell + 0.5 - n / 2) * h) * 1e6, 1e-3);
  }
}

TEST(NormalContact, WestergaardAt256Cells)
{
  // Johnson, sec. 13.2: contact length and peak of a wavy surface in partial contact
  const int n = 256;
  HalfPlane plane(n, Boundary::Periodic);
  const double amplitude = 0.01 * n, fullPressure = pi * amplitude / n;
  const double table[][3] = {{0.05, 0.1435662931, 0.4472136}, {0.10, 0.2048327647, 0.6324555},
                             {0.25, 0.3333333333, 1.0},       {0.50, 0.5, 1.4142136},
                             {0.75, 0.6666666667, 1.7320508}, {0.95, 0.8564337069, 1.9493589}};
  NormalContactProblem problem;
  problem.profile.resize(n);
  for (int i = 0; i < n; ++i)
    problem.profile[i] = amplitude * (1.0 - std::cos(2.0 * pi * (i + 0.5 - n / 2) / n));
  for (const auto &[load, length, peak] : table) {
    problem.load = load * fullPressure * n;
    const NormalContactResult result = solveNormalContact(plane, problem);
    expectOptimal(plane, problem, result);
    EXPECT_NEAR(contactLength(contactIntervals(result, Boundary::Periodic)) / n, length, 1e-3);
    EXPECT_NEAR(result.peakPressure() / fullPressure, peak, 1e-3 * peak);
  }
}

TEST(NormalContact, FullContactIsSinusoidal)
{
  const int n = 256;
  HalfPlane plane(n, Boundary::Periodic);
  const double amplitude = 0.01 * n, fullPressure = pi * amplitude / n;
  NormalContactProblem problem;
  problem.profile.resize(n);
  for (int i = 0; i < n; ++i)
    problem.profile[i] = -amplitude * std::cos(2.0 * pi * i / n);
  problem.load = 1.5 * fullPressure * n;
  const NormalContactResult result = solveNormalContact(plane, problem);
  EXPECT_EQ(result.contactCells(), n);
  for (int i = 0; i < n; ++i) // z = A cos needs p = E* k A/2 cos, = fullPressure cos
    EXPECT_NEAR(result.pressure[i] / fullPressure, 1.5 + std::cos(2.0 * pi * i / n), 2e-3);
}

TEST(NormalContact, EqualsDenseReference)
{
  for (std::uint64_t seed : {1, 2, 3}) {
    const int n = 90;
    HalfPlane plane(n, Boundary::Free);
    NormalContactProblem problem = cylinder(n);
    for (int i = 0; i < n; ++i)
      problem.profile[i] += 0.02 * uniformNumber(seed, static_cast<std::uint64_t>(i));
    const Vector p = solveNormalContact(plane, problem).pressure;
    const Vector reference = denseContact(problem);
    EXPECT_LT((p - reference).cwiseAbs().maxCoeff(), 1e-6 * reference.maxCoeff()) << seed;
  }
}

TEST(NormalContact, RoughSurfacesOfTheStandard)
{
  // Rms slopes 0.01, 0.02, 0.04: about 58, 37, 20 % real area, peaks 2.1, 3.4, 5.2 GPa; the bands
  // are what eight seeds scatter.
  const int n = 2048;
  HalfPlane plane(n, Boundary::Free);
  const double bands[][5] = {
      {0.01, 0.50, 0.68, 1.7, 2.6}, {0.02, 0.29, 0.44, 2.7, 4.4}, {0.04, 0.15, 0.27, 4.3, 7.6}};
  for (const auto &[slope, least, most, lowest, highest] : bands)
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const NormalContactProblem problem = cylinder(n, slope, seed);
      const NormalContactResult result = solveNormalContact(plane, problem);
      expectOptimal(plane, problem, result);
      const double area = contactLength(contactIntervals(result, Boundary::Free)) / (n / 2);
      EXPECT_GT(area, least);
      EXPECT_LT(area, most);
      const double peak = result.peakPressure() * table2().modulus * 1e-9;
      EXPECT_GT(peak, lowest);
      EXPECT_LT(peak, highest);
    }
}

TEST(NormalContact, EdgesLieInsideCells)
{
  // Hertzian contacts of any width and place: counting cells is 0.35 too many on average and off by
  // up to 0.8, edges inside cells are right to a tenth
  double counted = 0.0, placed = 0.0;
  int trials = 0;
  for (double length : {2.0, 3.0, 5.0, 8.0, 13.0, 21.0, 150.0})
    for (int k = 0; k < 20; ++k, ++trials) {
      const double wanted = length * (1.0 + 0.05 * uniformNumber(7, trials));
      const double centre = uniformNumber(8, trials);
      const int n = 16 + 2 * static_cast<int>(length);
      HalfPlane plane(n, Boundary::Free);
      NormalContactProblem problem; // p0 = a/(2 R) = 1, load pi a p0/2
      problem.load = pi * wanted / 4.0;
      problem.profile.resize(n);
      for (int i = 0; i < n; ++i)
        problem.profile[i] = 2.0 * std::pow(i - 0.5 * n - centre, 2) / wanted;
      const NormalContactResult result = solveNormalContact(plane, problem);
      const auto intervals = contactIntervals(result, Boundary::Free);
      ASSERT_EQ(intervals.size(), 1u);
      EXPECT_NEAR(intervals[0].length(), wanted, 0.3);
      EXPECT_NEAR(intervals[0].left, 0.5 * n + centre - 0.5 * wanted, 0.25);
      counted += result.contactCells() - wanted;
      placed += intervals[0].length() - wanted;
    }
  EXPECT_GT(counted / trials, 0.25);
  EXPECT_NEAR(placed / trials, 0.0, 0.06);
}

TEST(NormalContact, HardnessLimitsThePressure)
{
  const int n = 2048;
  HalfPlane plane(n, Boundary::Free);
  NormalContactProblem problem = cylinder(n, 0.04);
  const double elasticArea = solveNormalContact(plane, problem).contactCells();
  problem.pressureLimit = 3e9 / table2().modulus;
  const NormalContactResult result = solveNormalContact(plane, problem);
  expectOptimal(plane, problem, result);
  EXPECT_DOUBLE_EQ(result.peakPressure(), problem.pressureLimit);
  EXPECT_GT(result.plasticDepth.maxCoeff(), 0.0);
  EXPECT_GT(result.contactCells(), elasticArea);
}

TEST(NormalContact, LimitsOfCellsThatAreAlikeAreOneLimit)
{
  const int n = 1024;
  HalfPlane plane(n, Boundary::Free);
  NormalContactProblem problem = cylinder(n, 0.04);
  problem.pressureLimit = 3e9 / table2().modulus;
  const NormalContactResult one = solveNormalContact(plane, problem);
  problem.cellLimits = Vector::Constant(n, problem.pressureLimit);
  problem.pressureLimit = 1.0; // is not read
  const NormalContactResult each = solveNormalContact(plane, problem);
  EXPECT_EQ(each.pressure, one.pressure);
  EXPECT_GT(one.plasticDepth.maxCoeff(), 0.0);
  problem.cellLimits *= 0.5 * problem.load / problem.cellLimits.sum();
  EXPECT_THROW(solveNormalContact(plane, problem), Error);
  problem.cellLimits = Vector::Constant(n - 1, 1.0);
  EXPECT_THROW(solveNormalContact(plane, problem), Error);
}

TEST(NormalContact, AnyProfileAndLimitConverges)
{
  // Where peers fail: near full contact and with the limit almost everywhere active.
  std::uint64_t index = 0;
  const auto random = [&] { return uniformNumber(99, index++); };
  for (int trial = 0; trial < 300; ++trial) {
    const int n = 16 + static_cast<int>(random() * 300);
    HalfPlane plane(n, random() < 0.5 ? Boundary::Periodic : Boundary::Free);
    NormalContactProblem problem;
    problem.profile = Vector::Zero(n);
    const double hurst = 1.2 * random() - 0.1, slope = std::pow(10.0, -4.0 + 3.5 * random());
    for (int k = 1; k <= 1 + n / 3; ++k) {
      const double phase = 2.0 * pi * random();
      for (int i = 0; i < n; ++i)
        problem.profile[i] +=
            slope * n * 0.1 * std::pow(k, -hurst - 0.5) * std::cos(2.0 * pi * k * i / n + phase);
    }
    problem.load = n * slope * std::pow(10.0, -3.0 + 4.0 * random());
    if (random() < 0.6)
      problem.pressureLimit = problem.load / n * (1.0 + std::pow(10.0, -3.0 + 4.0 * random()));
    if (trial % 3 == 0 && std::isfinite(problem.pressureLimit))
      problem.cellLimits =
          Vector::NullaryExpr(n, [&] { return problem.pressureLimit * std::pow(10.0, random()); });
    expectOptimal(plane, problem, solveNormalContact(plane, problem));
    if (HasFailure())
      FAIL() << "trial " << trial;
  }
}

TEST(NormalContact, DoesNotDependOnTheStart)
{
  HalfPlane plane(1024, Boundary::Free);
  const NormalContactProblem problem = cylinder(1024, 0.02);
  const Vector cold = solveNormalContact(plane, problem).pressure;
  NormalContactOptions warm;
  warm.start = cold.reverse();
  const Vector again = solveNormalContact(plane, problem, warm).pressure;
  EXPECT_LT((again - cold).cwiseAbs().maxCoeff(), 1e-6 * cold.maxCoeff());
}

TEST(NormalContact, MirroredProfileMirrorsThePressure)
{
  HalfPlane plane(1024, Boundary::Free);
  NormalContactProblem problem = cylinder(1024, 0.02);
  const Vector pressure = solveNormalContact(plane, problem).pressure;
  problem.profile.reverseInPlace();
  const Vector mirrored = solveNormalContact(plane, problem).pressure.reverse();
  EXPECT_LT((mirrored - pressure).cwiseAbs().maxCoeff(), 1e-6 * pressure.maxCoeff());
}

TEST(NormalContact, RefusesALoadBeyondTheLimit)
{
  HalfPlane plane(64, Boundary::Free);
  NormalContactProblem problem = cylinder(64);
  problem.pressureLimit = 0.5 * problem.load / 64;
  EXPECT_THROW(solveNormalContact(plane, problem), Error);
  problem.load = 0.0;
  EXPECT_THROW(solveNormalContact(plane, problem), Error);
}

TEST(NormalContact, ServesAPatchOfCells)
{
  // Hertz's sphere: a^3 = 3 N R/(4 E*), p0 = 3 N/(2 pi a^2), approach a^2/R; cells are not square
  const double a = 1.0, radius = 40.0, force = 4.0 * a * a * a / (3.0 * radius);
  const CellGrid grid{32, 24, 2.4 / 32, 2.4 / 24};
  DensePatch patch(grid);
  NormalContactProblem problem;
  problem.profile.resize(grid.cells());
  for (int iy = 0; iy < grid.ny; ++iy)
    for (int ix = 0; ix < grid.nx; ++ix)
      problem.profile[grid.index(ix, iy)] =
          (std::pow((ix + 0.5) * grid.dx - 1.2, 2) + std::pow((iy + 0.5) * grid.dy - 1.2, 2)) /
          (2.0 * radius);
  problem.load = force / (grid.dx * grid.dy);
  const NormalContactResult result = solveNormalContact(patch, problem);
  EXPECT_NEAR(result.pressure.sum(), problem.load, 1e-10 * problem.load);
  EXPECT_NEAR(result.peakPressure() / (1.5 * force / (pi * a * a)), 1.0, 0.01);
  EXPECT_NEAR(result.approach / (a * a / radius), 1.0, 0.01);
  EXPECT_NEAR(result.contactCells() * grid.dx * grid.dy / (pi * a * a), 1.0, 0.05);

  problem.pressureLimit = 0.8 * result.peakPressure();
  const NormalContactResult limited = solveNormalContact(patch, problem);
  EXPECT_NEAR(limited.pressure.sum(), problem.load, 1e-10 * problem.load);
  EXPECT_DOUBLE_EQ(limited.peakPressure(), problem.pressureLimit);
  EXPECT_GT(limited.plasticDepth.maxCoeff(), 0.0);
}
