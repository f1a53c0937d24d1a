// SPDX-License-Identifier: GPL-2.0-or-later
// The step as a whole: on several ranks as on one, in set-up as in the step before, and its energy.
// Samples of two blocks, one of which slides on the other: links flow, break and form.
#include "core/energy_account.h"
#include "core/step.h"

#include "sample.h"
#include "sample_space.h"

#include <gtest/gtest.h>

#include <array>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <random>
#include <thread>

namespace {

using Point = std::array<double, 3>;

/// A sample as no rank knows it: automata by their IDs.
struct World {
  int dimension;
  mca::Packing packing;
  mca::LawSet laws;
  mca::Material material = steel();
  std::vector<Point> x, v, omega;
  struct Pair {
    int i, j;
    double kind;
  };
  std::vector<Pair> pairs; // in the order of IDs

  int size() const { return static_cast<int>(x.size()); }
  mca::Cell cell() const { return {packing, steel().diameter, 1.0}; }
};

/// The upper half moves to the right and down, and everything trembles.
void setInMotion(World &w, double speed)
{
  double top = 0;
  for (const Point &x : w.x)
    top = std::max(top, x[1]);
  std::mt19937 random(7);
  std::uniform_real_distribution<> tremble(-0.5, 0.5);
  for (const Point &x : w.x) {
    const bool upper = x[1] > 0.5 * top;
    w.v.push_back({tremble(random) + (upper ? speed : 0.0), tremble(random) - (upper ? speed : 0.0),
                   w.dimension == 3 ? tremble(random) : 0.0});
    Point spin = {0.0, 0.0, 0.1 * tremble(random)};
    if (w.dimension == 3)
      spin[0] = 0.1 * tremble(random);
    w.omega.push_back(spin);
  }
  // links inside the halves only
  for (auto &pair : w.pairs) {
    const Point &a = w.x[pair.i], &b = w.x[pair.j];
    const bool near = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) < 1.1 * steel().diameter;
    const bool same = (a[1] > 0.5 * top) == (b[1] > 0.5 * top);
    pair.kind = near && same ? mca::link::bulk : mca::link::none;
  }
}

World makeWorld(int dimension, const std::vector<std::string> &words, double speed = 20.0)
{
  World w;
  w.dimension = dimension;
  w.packing = dimension == 2 ? mca::packing::hex : mca::packing::fcc;
  EXPECT_EQ(w.laws.parse(words), "");
  if (w.laws.resistsSlip())
    w.material.viscosity /= 5.0; // steps as long as those of the other laws
  if (dimension == 2) {
    const reference::Sample s = hexagonalBlock(steel(), 16, 12, 1, 1.8);
    for (const auto &a : s.automata)
      w.x.push_back({a.x, a.y, 0.0});
    for (const auto &c : s.contacts)
      w.pairs.push_back({c.i, c.j, 1});
  } else {
    const reference::space::Sample s = block(w.packing, steel(), 6, 1, false, 1.5);
    for (const auto &a : s.automata)
      w.x.push_back({a.x.x(), a.x.y(), a.x.z()});
    for (const auto &c : s.contacts)
      w.pairs.push_back({c.i, c.j, 1});
  }
  setInMotion(w, speed);
  return w;
}

/// An exchange between two threads, each in the place of a rank.
class Threads : public mca::Exchange {
 public:
  std::vector<int> needed, guests; ///< rows of own automata, of guests, in the order of IDs
  Threads *other = nullptr;

  bool alone() const override { return false; }
  void begin(const double *rows, int stride, int count) override
  {
    std::vector<double> message;
    for (const int row : needed)
      message.insert(message.end(), rows + row * stride, rows + row * stride + count);
    const std::lock_guard<std::mutex> hold(other->mutex_);
    other->box_.push_back(message);
    other->arrived_.notify_one();
  }
  void finish(double *rows, int stride, int count) override
  {
    std::unique_lock<std::mutex> hold(mutex_);
    arrived_.wait(hold, [this]() { return !box_.empty(); });
    ASSERT_EQ(box_.front().size(), guests.size() * count);
    const double *value = box_.front().data();
    for (const int row : guests)
      for (int m = 0; m < count; m++)
        rows[row * stride + m] = *value++;
    box_.pop_front();
  }

 private:
  std::mutex mutex_;
  std::condition_variable arrived_;
  std::deque<std::vector<double>> box_;
};

/// The edges of a box that does not change.
const mca::EnergyAccount::Edges still = {{1, 1, 1, 0, 0, 0}};

/// What one rank holds of the world.
struct Part {
  const World &world;
  mca::Step step;
  mca::EnergyAccount account;
  Threads exchange;
  std::vector<int> ids, rows; ///< of rows; of IDs, or -1
  std::vector<int> listed;    ///< numbers of the pairs in the world
  StepArrays arrays;

  /// \param owns  of each ID
  Part(const World &w, const std::vector<bool> &owns, bool alone)
      : world(w), step(w.dimension), rows(w.size(), -1)
  {
    auto take = [&](int id) {
      rows[id] = static_cast<int>(ids.size());
      ids.push_back(id);
    };
    for (int id = 0; id < w.size(); id++)
      if (owns[id])
        take(id);
    const int own = static_cast<int>(ids.size());
    std::vector<bool> needed(w.size()), guest(w.size());
    for (const auto &p : w.pairs)
      if (owns[p.i] != owns[p.j]) {
        needed[owns[p.i] ? p.i : p.j] = true;
        guest[owns[p.i] ? p.j : p.i] = true;
      }
    for (int id = 0; id < w.size(); id++) {
      if (needed[id])
        exchange.needed.push_back(rows[id]);
      if (guest[id]) {
        take(id);
        exchange.guests.push_back(rows[id]);
      }
    }
    if (!alone)
      step.setExchange(exchange);
    int border = 0;
    for (const bool first : {true, false})
      for (size_t k = 0; k < w.pairs.size(); k++) {
        const auto &p = w.pairs[k];
        if ((owns[p.i] || owns[p.j]) && (needed[p.i] || needed[p.j]) == first) {
          listed.push_back(static_cast<int>(k));
          border += first;
        }
      }
    step.setLaws({w.laws, {w.material}, 1.0, w.packing});
    step.links().reset(static_cast<int>(listed.size()));
    for (const int k : listed) {
      const double state[mca::LinkList::maxStateSize] = {w.pairs[k].kind};
      step.links().add(rows[w.pairs[k].i], rows[w.pairs[k].j], 0, state);
    }
    arrays = StepArrays(ids.size());
    step.begin(own, static_cast<int>(ids.size()), arrays.types.data(), border);
    for (size_t row = 0; row < ids.size(); row++)
      show(static_cast<int>(row), w.x[ids[row]], w.v[ids[row]], w.omega[ids[row]]);
  }

  void show(int row, const Point &x, const Point &v, const Point &omega)
  {
    std::copy_n(x.data(), 3, arrays.x()[row]);
    std::copy_n(v.data(), 3, arrays.v()[row]);
    std::copy_n(omega.data(), 3, arrays.omega()[row]);
  }

  void kick(double dt)
  {
    const double mass = world.cell().mass(steel().density);
    const double inertia = world.cell().inertia(steel().density);
    for (int i = 0; i < step.own(); i++) {
      const mca::Vector f = step.force(i), t = step.torque(i);
      const double force[] = {f.x, f.y, f.z}, torque[] = {t.x, t.y, t.z};
      for (int m = 0; m < 3; m++) {
        arrays.v()[i][m] += 0.5 * dt / mass * force[m];
        arrays.omega()[i][m] += 0.5 * dt / inertia * torque[m];
      }
    }
  }

  void drift(double dt)
  {
    for (int i = 0; i < step.own(); i++)
      for (int m = 0; m < 3; m++)
        arrays.x()[i][m] += dt * arrays.v()[i][m];
  }

  void keepAccount()
  {
    std::vector<double> forces, torques;
    for (int i = 0; i < step.own(); i++) {
      const mca::Vector f = step.force(i), t = step.torque(i);
      forces.insert(forces.end(), {f.x, f.y, f.z});
      torques.insert(torques.end(), {t.x, t.y, t.z});
    }
    account.keep(step, arrays.x(), reinterpret_cast<double(*)[3]>(forces.data()),
                 reinterpret_cast<double(*)[3]>(torques.data()), still);
  }

  /// Kinetic energy of the half steps and elastic energy of own automata.
  double energy(double dt)
  {
    const double mass = world.cell().mass(steel().density);
    const double inertia = world.cell().inertia(steel().density);
    double sum = 0.0;
    for (int i = 0; i < step.own(); i++) {
      const mca::Vector f = step.force(i), t = step.torque(i);
      const double force[] = {f.x, f.y, f.z}, torque[] = {t.x, t.y, t.z};
      for (int m = 0; m < 3; m++)
        sum += mca::leapfrogEnergy(mass, arrays.v()[i][m], 0.5 * dt / mass * force[m]) +
               mca::leapfrogEnergy(inertia, arrays.omega()[i][m], 0.5 * dt / inertia * torque[m]);
      sum += step.automaton(i).energy;
    }
    return sum - account.released();
  }
};

/// Ranks that integrate the world by velocity Verlet, each in a thread of its own where there are
/// two.
struct Ranks {
  const World &world;
  std::vector<std::unique_ptr<Part>> parts;
  std::vector<int> home; ///< part of each ID
  double dt = 5e-5;

  Ranks(const World &w, int ranks) : world(w)
  {
    double width = 0.0;
    for (const Point &x : w.x)
      width = std::max(width, x[0]);
    for (const Point &x : w.x)
      home.push_back(ranks == 2 && x[0] > 0.49 * width);
    for (int r = 0; r < ranks; r++) {
      std::vector<bool> owns;
      for (const int at : home)
        owns.push_back(at == r);
      parts.push_back(std::make_unique<Part>(w, owns, ranks == 1));
    }
    if (ranks == 2) {
      parts[0]->exchange.other = &parts[1]->exchange;
      parts[1]->exchange.other = &parts[0]->exchange;
    }
    each([](Part &p) {
      p.step.run(p.arrays.view(), 0.0, false);
      p.keepAccount();
    });
  }

  template<class Work>
  void each(const Work &work)
  {
    if (parts.size() == 1)
      return work(*parts[0]);
    std::vector<std::thread> ranks;
    for (auto &p : parts)
      ranks.emplace_back([&work, &p]() { work(*p); });
    for (auto &rank : ranks)
      rank.join();
  }

  /// Guests follow their originals, as LAMMPS sees to it.
  void moveGuests()
  {
    for (auto &p : parts)
      for (size_t row = p->step.own(); row < p->ids.size(); row++) {
        const int id = p->ids[row];
        Part &owner = *parts[home[id]];
        for (auto of : {&StepArrays::x, &StepArrays::v, &StepArrays::omega})
          std::copy_n((owner.arrays.*of)()[owner.rows[id]], 3, (p->arrays.*of)()[row]);
      }
  }

  void advance(int steps)
  {
    for (int k = 0; k < steps; k++) {
      each([this](Part &p) {
        p.kick(dt);
        p.drift(dt);
        p.account.bookFirstHalf(p.step, p.arrays.x(), p.arrays.omega(), dt, still);
      });
      moveGuests();
      each([this](Part &p) {
        p.step.run(p.arrays.view(), dt, true);
        p.kick(dt);
        p.keepAccount();
        p.account.bookSecondHalf(p.step, dt);
      });
    }
  }

  mca::Step::Count count() const
  {
    mca::Step::Count sum;
    for (const auto &p : parts) {
      const mca::Step::Count c = p->step.count();
      sum.links += c.links;
      sum.welds += c.welds;
      sum.broken += c.broken;
      sum.formed += c.formed;
      sum.healed += c.healed;
    }
    return sum;
  }
};

double size(const mca::Vector &v)
{
  return mca::length(v);
}

using Case = std::pair<int, std::vector<std::string>>;
class StepTest : public testing::TestWithParam<Case> {
 protected:
  World world = makeWorld(GetParam().first, GetParam().second);
};

TEST_P(StepTest, IsTheSameOnTwoRanks)
{
  Ranks one(world, 1), two(world, 2);
  ASSERT_GT(two.parts[0]->exchange.guests.size(), 10u);
  ASSERT_GT(two.parts[1]->step.own(), 30);
  for (int block = 0; block < 6; block++) {
    one.advance(20);
    two.advance(20);
    const Part &all = *one.parts[0];
    double force = 0.0, stress = 0.0, energy = 0.0;
    for (int id = 0; id < world.size(); id++) {
      const mca::Step::Automaton a = all.step.automaton(id);
      force = std::max(force, size(all.step.force(id)));
      stress = std::max(stress, a.intensity);
      energy = std::max(energy, a.energy);
    }
    // sums of pairs at the border come in another order; what differs grows with the steps
    const double near = 1e-12 * (1 + 20 * block);
    for (int id = 0; id < world.size(); id++) {
      const Part &part = *two.parts[two.home[id]];
      const int row = part.rows[id];
      const mca::Step::Automaton a = all.step.automaton(id), b = part.step.automaton(row);
      EXPECT_LT(size(part.step.force(row) - all.step.force(id)), near * force);
      EXPECT_LT(size(part.step.torque(row) - all.step.torque(id)), near * force * 2.5);
      EXPECT_NEAR(a.mean, b.mean, near * stress);
      EXPECT_NEAR(a.intensity, b.intensity, near * stress);
      EXPECT_NEAR(a.stress.xy, b.stress.xy, near * stress);
      EXPECT_NEAR(a.energy, b.energy, near * energy);
      EXPECT_NEAR(all.arrays.kappa[id], part.arrays.kappa[row], near);
    }
    for (const auto &part : two.parts)
      for (size_t k = 0; k < part->listed.size(); k++) {
        double mine[mca::LinkList::maxStateSize], whole[mca::LinkList::maxStateSize];
        for (const bool next : {false, true}) {
          part->step.links().getState(static_cast<int>(k), next, mine);
          all.step.links().getState(part->listed[k], next, whole);
          EXPECT_EQ(mine[0], whole[0]) << "pair " << part->listed[k];
          for (int m = 1; m < all.step.links().stateSize(); m++)
            EXPECT_NEAR(mine[m], whole[m], near);
        }
      }
  }
  const mca::Step::Count a = one.count(), b = two.count();
  EXPECT_EQ(a.links, b.links);
  EXPECT_EQ(a.broken, b.broken);
  EXPECT_EQ(a.formed, b.formed);
  EXPECT_GT(a.formed, 0.0);
  double flow = 0.0;
  for (const double kappa : one.parts[0]->arrays.kappa)
    flow = std::max(flow, kappa);
  EXPECT_EQ(flow > 1e-6, world.laws.flows());
  const double *whole = one.parts[0]->account.sums();
  const double lost = whole[mca::EnergyAccount::Plastic] + whole[mca::EnergyAccount::Viscous];
  for (int m = 0; m < mca::EnergyAccount::Channels; m++)
    EXPECT_NEAR(two.parts[0]->account.sums()[m] + two.parts[1]->account.sums()[m], whole[m],
                1e-9 * lost);
}

/// What the account lacks after some time, as a part of what the contacts dissipated.
double lackOf(const World &world, int ranks, int steps)
{
  Ranks run(world, ranks);
  run.dt = 1.5e-2 / steps;
  auto energy = [&run]() {
    double sum = 0.0;
    for (auto &p : run.parts)
      sum += p->energy(run.dt);
    return sum;
  };
  const double start = energy();
  run.advance(steps);
  double lost = 0.0;
  for (auto &p : run.parts) {
    const double *sums = p->account.sums();
    lost += sums[mca::EnergyAccount::Plastic] + sums[mca::EnergyAccount::Fracture] +
            sums[mca::EnergyAccount::Viscous] + sums[mca::EnergyAccount::Touching];
    EXPECT_EQ(sums[mca::EnergyAccount::Work], 0.0); // nothing acts from outside
  }
  EXPECT_GT(lost, 0.01 * start);
  return std::abs(energy() + lost - start) / lost;
}

TEST_P(StepTest, EnergyAccountCloses)
{
  // but for the turn of a contact in a step, squared, since its force turns with it
  const World slow = makeWorld(GetParam().first, GetParam().second, 5.0);
  const double coarse = lackOf(slow, 1, 300), fine = lackOf(slow, 1, 1200);
  EXPECT_LT(coarse, 1e-5);
  EXPECT_LT(fine, coarse / 5.0); // about 16: of second order
  EXPECT_NEAR(lackOf(slow, 2, 300), coarse, 1e-3 * coarse);
}

TEST_P(StepTest, SetUpFindsTheForcesOfTheLastStepAgain)
{
  Ranks run(world, 1);
  run.advance(60);
  Part &before = *run.parts[0];
  before.step.keepLag(before.arrays.view());
  Part after(world, std::vector<bool>(world.size(), true), true);
  after.arrays = before.arrays;
  mca::LinkList &links = after.step.links();
  for (int k = 0; k < links.size(); k++) {
    double state[mca::LinkList::maxStateSize];
    before.step.links().getState(k, false, state);
    links.setState(k, state);
  }
  after.step.run(after.arrays.view(), run.dt, false);
  for (int i = 0; i < world.size(); i++) {
    EXPECT_EQ(size(before.step.force(i) - after.step.force(i)), 0.0) << i;
    EXPECT_EQ(size(before.step.torque(i) - after.step.torque(i)), 0.0) << i;
  }
  // and the state that both lead to
  before.step.commit(before.arrays.view());
  after.step.commit(after.arrays.view());
  EXPECT_EQ(before.arrays.kappa, after.arrays.kappa);
}

TEST_P(StepTest, CountsEachChangeOnce)
{
  Ranks run(world, 1);
  Part &p = *run.parts[0];
  const double links = run.count().links;
  int changes = 0;
  for (int k = 0; k < 120; k++) {
    run.advance(1);
    changes += static_cast<int>(p.step.changes().size());
  }
  p.step.commit(p.arrays.view());
  EXPECT_FALSE(p.step.commit(p.arrays.view())); // once
  changes += static_cast<int>(p.step.changes().size());
  p.step.links().advance();
  const mca::Step::Count c = run.count();
  EXPECT_EQ(c.links, links - c.broken + c.formed);
  EXPECT_EQ(changes, c.broken + c.formed + c.healed);
  std::vector<double> broken(world.size()), formed(world.size());
  p.step.takeChanges(broken.data(), formed.data());
  double ends = 0.0;
  for (int i = 0; i < world.size(); i++)
    ends += broken[i] + formed[i];
  EXPECT_EQ(ends, 2 * (c.broken + c.formed));
  EXPECT_GT(ends, 0.0);
  p.step.takeChanges(broken.data(), formed.data()); // nothing new
  for (int i = 0; i < world.size(); i++)
    ends -= broken[i] + formed[i];
  EXPECT_EQ(ends, 0.0);
}

std::string name(const testing::TestParamInfo<Case> &info)
{
  std::string text = info.param.first == 2 ? "plane" : "space";
  for (const auto &word : info.param.second)
    text += "_" + word;
  std::replace(text.begin(), text.end(), '-', '_');
  return text;
}

INSTANTIATE_TEST_SUITE_P(Laws, StepTest,
                         testing::Values(Case{2, {}}, Case{2, {"preset", "a", "steps", "plain"}},
                                         Case{2, {"plasticity", "isochoric", "flow", "contacts"}},
                                         Case{2, {"flow", "contacts"}},
                                         Case{3, {"plasticity", "isochoric", "flow", "contacts"}},
                                         Case{2, {"fracture", "equivalent"}},
                                         Case{2, {"plasticity", "none"}},
                                         Case{2, {"viscosity", "normal"}}, Case{2, {"preset", "b"}},
                                         Case{3, {}}, Case{3, {"steps", "plain"}},
                                         Case{3, {"viscosity", "normal"}},
                                         Case{3, {"preset", "b"}}),
                         name);

TEST(EnergyAccount, ABreakingLinkPaysInTheStepInWhichItBreaks)
{
  // two automata that fly apart; the link breaks at 4 %, after 25 steps of 0.16 %
  World pair;
  pair.dimension = 2;
  pair.packing = mca::packing::hex;
  EXPECT_EQ(pair.laws.parse({"plasticity", "none"}), "");
  pair.x = {{0, 0, 0}, {2.5, 0, 0}};
  pair.v = {{-2000, 0, 0}, {2000, 0, 0}};
  pair.omega = {{0, 0, 0}, {0, 0, 0}};
  pair.pairs = {{0, 1, mca::link::bulk}};
  Ranks run(pair, 1);
  run.dt = 1e-6;
  const Part &part = *run.parts[0];
  const double *sums = part.account.sums(), start = run.parts[0]->energy(run.dt);
  double held = 0.0;
  for (int k = 0; k < 60; k++) {
    run.advance(1);
    const double paid = sums[mca::EnergyAccount::Fracture];
    EXPECT_GE(paid, 0.0) << "step " << k;
    if (paid == 0.0)
      held = part.step.automaton(0).energy + part.step.automaton(1).energy;
    EXPECT_NEAR(run.parts[0]->energy(run.dt) + paid, start, 1e-9 * start) << "step " << k;
  }
  // its energy one step before, and a little of the step between: about 1 in 25
  EXPECT_GT(sums[mca::EnergyAccount::Fracture], held);
  EXPECT_LT(sums[mca::EnergyAccount::Fracture], 1.05 * held);
}

TEST(Step, AnswersForItsOwnRowsOnly)
{
  const World world = makeWorld(2, {});
  Ranks run(world, 2);
  const mca::Step &step = run.parts[0]->step;
  const int own = step.own(), rows = step.rows();
  EXPECT_EQ(rows, static_cast<int>(run.parts[0]->ids.size()));
  EXPECT_NO_THROW(step.automaton(own - 1));
  EXPECT_NO_THROW(step.place(rows - 1));
  EXPECT_THROW(step.automaton(own), std::out_of_range);
  EXPECT_THROW(step.automaton(-1), std::out_of_range);
  EXPECT_THROW(step.place(rows), std::out_of_range);
  Ranks alone(world, 1);
  EXPECT_EQ(alone.parts[0]->step.rows(), alone.parts[0]->step.own());
  EXPECT_THROW(alone.parts[0]->step.force(world.size()), std::out_of_range);
}

} // namespace
