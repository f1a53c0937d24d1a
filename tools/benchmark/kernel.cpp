// The passes of src/MCA/core/kernel.h alone, on a linked hexagonal lattice, for each instruction
// set that this processor runs: automaton-steps a second of each pass and of all five.
#include "laws/law_set.h"
#include "link_list.h"

#include <benchmark/benchmark.h>
#include <cmath>
#include <string>

namespace {

constexpr double dt = 5e-5; // ns

mca::Material steel()
{
  mca::Material m;
  m.youngs_modulus = 206000;
  m.poissons_ratio = 0.3;
  m.density = 0.0078;
  m.strength = 92;
  m.elastic_limit = 0.554;
  m.yield_strength = 0.870;
  m.yield_strain = 0.015;
  m.breaking_strain = 0.04;
  m.viscosity = 410;
  m.diameter = 2.5;
  return m;
}

// A block of columns x rows automata, linked, with a small periodic displacement and motion.
struct Sample {
  int n;
  mca::LinkList pairs;
  mca::AlignedArray motion, strains, stresses, response, forces;
  std::vector<int> type;
  std::vector<double> spin, kappa, kappaNext;
  std::vector<mca::PairLaw> pairLaws;
  std::vector<mca::AutomatonLaw> laws;

  explicit Sample(int columns, int rows)
      : n(columns * rows), type(n, 1), spin(n), kappa(n, 0.0), kappaNext(n)
  {
    const mca::Material m = steel();
    const mca::LawSet set;
    pairLaws.assign(4, mca::makePairLaw(set, m, m, 1.0));
    laws.assign(2, {m.bulkModulus(), m.shearModulus(), m.meanStressWeight(), 1.0,
                    mca::YieldCurve(m), mca::packing::hex.stressWeight()});
    motion.reserve(static_cast<size_t>(n) * mca::planeRows.motion.length);
    strains.reserve(static_cast<size_t>(n) * mca::planeRows.strain.length);
    stresses.reserve(static_cast<size_t>(n) * mca::planeRows.stress.length);
    response.reserve(static_cast<size_t>(n) * mca::planeRows.response.length);
    forces.reserve(static_cast<size_t>(n) * mca::planeRows.force.length);
    pairs.reset(3 * n);
    const double state[] = {mca::link::bulk, 0.0, 0.0, 0.0};
    for (int r = 0; r < rows; r++)
      for (int c = 0; c < columns; c++) {
        const int i = r * columns + c;
        const double x = m.diameter * (c + 0.5 * (r % 2)), y = m.diameter * std::sqrt(0.75) * r;
        double *row = motion.get() + i * mca::planeRows.motion.length;
        row[0] = x + 1e-5 * std::sin(x + y);
        row[1] = y + 1e-5 * std::cos(x - y);
        row[2] = 0.01 * std::sin(y);
        row[3] = 0.01 * std::cos(x);
        spin[i] = 0.001 * std::sin(x);
        if (c + 1 < columns)
          pairs.add(i, i + 1, 3, state);
        if (r + 1 == rows)
          continue;
        const int up = i + columns - (r % 2 ? 0 : 1);
        if (r % 2 || c > 0)
          pairs.add(i, up, 3, state);
        if (!(r % 2) || c + 1 < columns)
          pairs.add(i, up + 1, 3, state);
      }
  }

  static void clear(mca::AlignedArray &a, size_t size) { std::fill_n(a.get(), size, 0.0); }

  void strain(const mca::Kernel &k)
  {
    clear(strains, static_cast<size_t>(n) * mca::planeRows.strain.length);
    k.strain(pairs.pairs(), dt, true, pairLaws.data(), motion.get(), spin.data(), strains.get());
  }
  void mean(const mca::Kernel &k)
  {
    k.mean(n, type.data(), laws.data(), true, strains.get(), response.get());
  }
  void stress(const mca::Kernel &k)
  {
    clear(stresses, static_cast<size_t>(n) * mca::planeRows.stress.length);
    k.stress(pairs.pairs(), pairLaws.data(), response.get(), stresses.get());
  }
  void yield(const mca::Kernel &k)
  {
    k.yield(n, type.data(), laws.data(), true, strains.get(), stresses.get(), kappa.data(),
            kappaNext.data(), response.get());
  }
  void force(const mca::Kernel &k)
  {
    clear(forces, static_cast<size_t>(n) * mca::planeRows.force.length);
    benchmark::DoNotOptimize(
        k.force(pairs.pairs(), pairLaws.data(), response.get(), nullptr, forces.get()));
  }
};

using Part = void (Sample::*)(const mca::Kernel &);

void run(benchmark::State &state, const mca::Kernel &kernel, std::vector<Part> parts, int columns)
{
  Sample sample(columns, columns);
  for (Part part :
       {&Sample::strain, &Sample::mean, &Sample::stress, &Sample::yield, &Sample::force})
    (sample.*part)(kernel);
  for (auto _ : state)
    for (Part part : parts)
      (sample.*part)(kernel);
  state.counters["automaton-steps/s"] =
      benchmark::Counter(static_cast<double>(sample.n) * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate);
}

} // namespace

int main(int argc, char **argv)
{
  const std::vector<Part> all = {&Sample::strain, &Sample::mean, &Sample::stress, &Sample::yield,
                                 &Sample::force};
  const char *names[] = {"strain", "mean", "stress", "yield", "force"};
  for (const mca::Kernel *kernel : mca::supportedKernels(2)) {
    const std::string isa = kernel->name;
    for (const int columns : {40, 200}) {
      const std::string size = "/" + std::to_string(columns * columns);
      for (size_t k = 0; k < all.size(); k++)
        benchmark::RegisterBenchmark((isa + "/" + names[k] + size).c_str(), run, *kernel,
                                     std::vector<Part>{all[k]}, columns);
      benchmark::RegisterBenchmark((isa + "/all" + size).c_str(), run, *kernel, all, columns);
    }
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
