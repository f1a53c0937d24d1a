// SPDX-License-Identifier: GPL-2.0-or-later
// The step of src/MCA/core/step.h alone, that which pair_style mca runs, without LAMMPS: for each
// instruction set that this processor runs, in the plane (hex) and in space (fcc), automaton-steps
// a second on a linked, periodic lattice that vibrates elastically.
#include "core/step.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace {

using Vector3i = std::array<int, 3>;

constexpr double dt = 5e-5; // ns

mca::Material steel()
{
  mca::Material m;
  m.youngsModulus = 206000;
  m.poissonsRatio = 0.3;
  m.density = 0.0078;
  m.strength = 92;
  m.elasticLimit = 0.554;
  m.yieldStrength = 0.870;
  m.yieldStrain = 0.015;
  m.breakingStrain = 0.04;
  m.viscosity = 410;
  m.diameter = 2.5;
  return m;
}

// A block of counts[0] x counts[1] x counts[2] periods of a lattice of one automaton a period, all
// neighbours linked, and its images over the periodic faces.
class Sample {
 public:
  Sample(const mca::Kernel &kernel, const mca::Packing &packing, const int (&counts)[3])
      : step_(kernel.dimension, &kernel), n_{counts[0], counts[1], counts[2]}
  {
    step_.setLaws({mca::LawSet(), {steel()}, 1.0, packing});
    placeAutomata(mca::latticeOf(packing));
    linkNeighbours(packing);
    const std::vector<int> types(own(), 0);
    step_.begin(own(), static_cast<int>(places_.size()), types.data(), 0);
    for (const double sign : {1.0, -1.0})
      for (const Vector &x : places_) {
        velocities_.push_back({sign * 0.01 * std::sin(x[1]), sign * 0.01 * std::cos(x[0]), 0.0});
        spins_.push_back({0.0, 0.0, sign * 0.001 * std::sin(x[0])});
      }
    groups_.assign(places_.size(), 1);
    zeros_.assign(places_.size(), 0.0);
    run(false);
  }

  int own() const { return n_[0] * n_[1] * n_[2]; }

  void run(bool advance)
  {
    turn_ = !turn_;
    const size_t first = turn_ ? places_.size() : 0;
    auto three = [](std::vector<Vector> &of, size_t from = 0) {
      return reinterpret_cast<const double(*)[3]>(of.data() + from);
    };
    mca::Automata a{};
    a.x = three(places_);
    a.v = three(velocities_, first);
    a.omega = three(spins_, first);
    a.groups = groups_.data();
    a.integrated = 1;
    a.held = 2;
    a.kappa = a.kept = zeros_.data();
    std::fill_n(a.lag, 3, zeros_.data());
    std::fill_n(a.rest, 3, zeros_.data());
    step_.run(a, dt, advance);
    benchmark::DoNotOptimize(step_.forces().data());
  }

 private:
  using Vector = std::array<double, 3>;
  mca::Step step_;
  int n_[3];
  std::vector<Vector> places_;
  std::vector<Vector> velocities_, spins_; // of all, then the opposite ones: shears go to and fro
  bool turn_ = false;
  std::vector<double> zeros_; // nothing flows
  std::vector<int> groups_;
  std::map<Vector3i, int> rows_; // by periods from the first automaton

  // First the automata, then the images around them.
  void placeAutomata(const mca::Lattice &lattice)
  {
    const double d = steel().diameter;
    const mca::Lattice::Point *e = lattice.edges;
    for (const bool image : {false, true})
      for (int a = -1; a <= n_[0]; a++)
        for (int b = -1; b <= n_[1]; b++)
          for (int c = -1; c <= n_[2]; c++) {
            if ((owner({a, b, c}) != Vector3i{a, b, c}) != image)
              continue;
            rows_[{a, b, c}] = static_cast<int>(places_.size());
            places_.push_back({d * (a * e[0].x + b * e[1].x + c * e[2].x),
                               d * (a * e[0].y + b * e[1].y + c * e[2].y),
                               d * (a * e[0].z + b * e[1].z + c * e[2].z)});
          }
  }

  Vector3i owner(const Vector3i &p) const
  {
    return {(p[0] + n_[0]) % n_[0], (p[1] + n_[1]) % n_[1], (p[2] + n_[2]) % n_[2]};
  }

  // Each pair once, from the automaton that comes first.
  void linkNeighbours(const mca::Packing &packing)
  {
    const double state[mca::LinkList::maxStateSize] = {mca::link::bulk};
    const int deep = packing.dimension == 3 ? 1 : 0;
    mca::LinkList &links = step_.links();
    links.reset(own() * packing.coordination / 2);
    for (int a = 0; a < n_[0]; a++)
      for (int b = 0; b < n_[1]; b++)
        for (int c = 0; c < n_[2]; c++)
          for (int m = 0; m < 27; m++) {
            const Vector3i there = {a + m / 9 - 1, b + m / 3 % 3 - 1, c + m % 3 - 1};
            if (!deep && there[2] != c)
              continue;
            const int i = rows_[{a, b, c}], place = rows_[there], j = rows_[owner(there)];
            const Vector &x = places_[i], &y = places_[place];
            const double r = std::hypot(y[0] - x[0], y[1] - x[1], y[2] - x[2]);
            if (j <= i || r > 1.1 * steel().diameter)
              continue;
            links.add(i, j, 0, state);
            links.setPlaces(i, place);
          }
  }
};

void run(benchmark::State &state, const mca::Kernel &kernel, const mca::Packing &packing,
         const std::array<int, 3> &counts)
{
  Sample sample(kernel, packing, {counts[0], counts[1], counts[2]});
  for (auto _ : state)
    sample.run(true);
  state.counters["automaton-steps/s"] = benchmark::Counter(
      static_cast<double>(sample.own()) * static_cast<double>(state.iterations()),
      benchmark::Counter::kIsRate);
}

} // namespace

int main(int argc, char **argv)
{
  const struct {
    const mca::Packing &packing;
    std::array<int, 3> counts;
  } cases[] = {{mca::packing::hex, {40, 40, 1}},
               {mca::packing::hex, {200, 200, 1}},
               {mca::packing::fcc, {16, 10, 10}},
               {mca::packing::fcc, {40, 40, 25}}};
  for (const auto &[packing, counts] : cases)
    for (const mca::Kernel *kernel : mca::supportedKernels(packing.dimension)) {
      const std::string name = std::string(kernel->name) + "/" + packing.name + "/" +
                               std::to_string(counts[0] * counts[1] * counts[2]);
      benchmark::RegisterBenchmark(name.c_str(), run, *kernel, packing, counts);
    }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
