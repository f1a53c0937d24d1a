// SPDX-License-Identifier: GPL-2.0-or-later
// The rules for contacts whose link broke: a pair that is pressed, slides, is unloaded and parts,
// by the kernel and by the reference.
#include "sample.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>

namespace {

constexpr double worn = -1, none = 0, bulk = 1, weld = 2;
constexpr double dt = 1e-5;

/// A pair on a circle: its kinds from step to step.
class Pair {
 public:
  /// \param kind  at the beginning
  Pair(const std::string &rule, double kind) : slow_(hexagonalBlock(steel(), 2, 1, kind))
  {
    slow_.laws.flow = "links"; // a pair alone that flows is never pressed up to the hardness
    slow_.laws.worn = rule;
    fast_ = slow_;
    run_ = std::make_unique<KernelRun>(mca::bestKernel(2), fast_, false);
  }

  /// A step that ends with the elastic normal strain e and slides by `way` diameters.
  /// \return the kind that it leads to
  double step(double e, double way = 0.0)
  {
    angle_ += way / (1.0 + e);
    const double r = 2.5 * (1.0 + e), x = r * std::cos(angle_), y = r * std::sin(angle_);
    for (reference::Sample *s : {&slow_, &fast_}) {
      reference::Automaton &b = s->automata[1];
      b.vx = -2.5 * way / dt * std::sin(angle_);
      b.vy = 2.5 * way / dt * std::cos(angle_);
      b.x = x;
      b.y = y;
    }
    reference::step(slow_, dt);
    run_->step(fast_, dt);
    EXPECT_EQ(fast_.contacts[0].next.kind, slow_.contacts[0].next.kind);
    EXPECT_NEAR(fast_.contacts[0].next.gammaTotal, slow_.contacts[0].next.gammaTotal, 1e-12);
    EXPECT_EQ(fast_.changed, slow_.changed);
    return fast_.contacts[0].next.kind;
  }

 private:
  reference::Sample slow_, fast_;
  std::unique_ptr<KernelRun> run_;
  double angle_ = 0.0;
};

// 198 GPa times the strain: linking at 51 MPa, the hardness is 240 MPa
constexpr double linking = -5e-4, unloaded = -1e-4, apart = 1e-4, healing = -2e-3;

TEST(WornContacts, ABrokenLinkIsWorn)
{
  for (const char *rule : {"unloaded", "never"}) {
    Pair pair(rule, weld);
    EXPECT_EQ(pair.step(linking), weld) << rule;
    EXPECT_EQ(pair.step(linking, 0.02), worn) << rule; // it breaks by shear
    EXPECT_EQ(pair.step(linking), worn) << rule;
  }
}

TEST(WornContacts, LinkAgainOnceUnloadedOrNever)
{
  for (const auto &[rule, kind] : {std::pair("unloaded", none), std::pair("never", worn)}) {
    Pair pair(rule, worn);
    EXPECT_EQ(pair.step(linking, 1.5), worn) << rule; // however far it slides
    EXPECT_EQ(pair.step(unloaded), kind) << rule;
    EXPECT_EQ(pair.step(apart), kind) << rule;
    EXPECT_EQ(pair.step(linking), kind == none ? weld : worn) << rule;
  }
}

TEST(WornContacts, AreForgottenAtTheBreakingDistance)
{
  Pair pair("never", worn);
  EXPECT_EQ(pair.step(std::exp(0.0399) - 1), worn); // the breaking strain is 0.04
  EXPECT_EQ(pair.step(linking), worn);
  EXPECT_EQ(pair.step(std::exp(0.0401) - 1), none);
  EXPECT_EQ(pair.step(linking), weld);
}

TEST(WornContacts, HealUnlessNever)
{
  EXPECT_EQ(Pair("unloaded", worn).step(healing), bulk);
  EXPECT_EQ(Pair("never", worn).step(healing), worn);
}

} // namespace
