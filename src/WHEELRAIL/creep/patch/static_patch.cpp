// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/patch/static_patch.h"

#include "base/errors.h"
#include "contact/patch/solvers/patch_sums.h"
#include "contact/patch/solvers/transient.h"

namespace wheelrail {
namespace {

using Vector = Eigen::VectorXd;

constexpr double tolerance = 1e-7; ///< one solve, which may be exact

/// Loads, forces and shifts of one point, one after the other.
class StaticSteps {
 public:
  StaticSteps(const CreepPhysics &physics, const FrictionLaw &law, const PatchContact &contact,
              const PatchTask &task)
      : physics_(physics), law_(law), contact_(contact), task_(task),
        space_(contact.grid, contact.pair), coupling_(contact.grid, contact.pair),
        transient_(contact.grid, contact.pair), normal_(contact.normal), load_(contact.load)
  {
    options_.tolerance = tolerance;
  }

  /// From the state before to this load.
  /// \param approach m; 0: the load holds
  /// \param drive of the stage
  void press(double load, double approach, const PatchDrive &drive)
  {
    drive_ = drive;
    const bool changes = load != load_ || approach != approach_;
    load_ = load;
    approach_ = approach;
    if (changes)
      solveNormal(coupling_.normal(transient_.traction()));
    TransientPatch::Step step;
    step.cells = 0;
    step.creepage = drive_.creepage;
    options_.start = transient_.traction();
    const auto slide = [&] {
      setFriction(step);
      TangentialResult tried = transient_.attempt(step, options_);
      products_ += tried.products + tried.coarseProducts;
      options_.start = tried.traction;
      return tried;
    };
    result_ = coupling_.settle(normal_.pressure, slide,
                               [&](const Vector &opening) { solveNormal(opening); });
    transient_.accept(step, result_);
    shift_.xi += result_.creepage.xi;
    shift_.eta += result_.creepage.eta;
    shift_.phi += result_.creepage.phi;
  }

  StaticPatch result() const;
  PatchFields fields() const;
  /// What the last stage gives.
  PatchValues values() const;

 private:
  void solveNormal(const Vector &opening)
  {
    NormalContactOptions options;
    options.start = normal_.pressure;
    NormalContactProblem problem = contact_.problem(physics_.pressureLimit(law_, 0.0), load_);
    if (approach_ > 0.0)
      problem.approach = approach_;
    if (opening.size() > 0)
      problem.profile += opening;
    normal_ = solveNormalContact(space_, problem, options);
    if (!(normal_.pressure.maxCoeff() > 0.0))
      throw Error(ExitCode::BadInput, "sequence.approach: the bodies do not touch");
    checkInsideBox(contact_.grid, normal_.pressure);
  }

  /// What the pressure decides in a step: bound, force, displacement.
  void setFriction(TransientPatch::Step &step)
  {
    // nothing slides on, nothing heats
    mu_ = contact_.across(law_.mu({normal_.pressure, 0.0, Vector::Zero(contact_.grid.cells())}));
    step.bound = contact_.bound(mu_, normal_.pressure);
    step.imposed = coupling_.tangential(normal_.pressure);
    step.forceX = drive_.forceX;
    step.forceY = drive_.forceY;
    if (!task_.forceRatio)
      return;
    step.forceX = -*task_.forceRatio * step.bound.sum() * contact_.grid.cellArea();
    step.forceY = 0.0;
  }

  const CreepPhysics &physics_;
  const FrictionLaw &law_;
  const PatchContact &contact_;
  const PatchTask &task_;
  PatchDrive drive_;
  PatchHalfSpace space_;
  PatchCoupling coupling_;
  TransientPatch transient_;
  NormalContactResult normal_;
  TangentialOptions options_;
  TangentialResult result_;
  Vector mu_;
  Creepage shift_;
  double load_, approach_ = 0.0; ///< as asked for
  int products_ = 0;
};

PatchFields StaticSteps::fields() const
{
  return {result_.state,
          normal_.gap,
          normal_.pressure,
          result_.traction,
          result_.slip,
          mu_,
          Vector::Zero(contact_.grid.cells())};
}

PatchValues StaticSteps::values() const
{
  const PatchSums sums = patchSums(contact_.grid, result_);
  constexpr double speed = 0.0;
  return patchValues({contact_, sums, result_, physics_.wear,
                      approach_ > 0.0 ? normal_.pressure.sum() * contact_.grid.cellArea()
                                      : contact_.carried(load_, normal_.pressure),
                      normal_.approach, shift_, normal_.pressure, mu_,
                      Vector::Zero(contact_.grid.cells()), speed});
}

StaticPatch StaticSteps::result() const
{
  StaticPatch still;
  still.fields = fields();
  PatchPoint &point = still.point;
  static_cast<PatchValues &>(point) = values();
  point.surface = contact_.surface.number;
  point.products = products_;
  point.use = law_.use({normal_.pressure, 0.0, still.fields.temperature});
  return still;
}

} // namespace

std::optional<StaticPatch> solveStaticPatch(const CreepPhysics &physics, const FrictionLaw &law,
                                            const PatchContact &contact, const PatchTask &task,
                                            const PatchSequence &sequence,
                                            const std::function<bool()> &goOn,
                                            PatchHistory &history)
{
  StaticSteps steps(physics, law, contact, task);
  if (!sequence.any())
    steps.press(contact.load, 0.0, task.drive);
  for (std::size_t k = 0; k < sequence.time.size(); ++k) {
    if (!goOn())
      return std::nullopt;
    history.now = sequence.time[k];
    const double load = sequence.load.empty() ? contact.load : sequence.load[k];
    PatchDrive drive = task.drive;
    if (!sequence.forceX.empty())
      drive.forceX = sequence.forceX[k];
    if (!sequence.forceY.empty())
      drive.forceY = sequence.forceY[k];
    steps.press(load, sequence.approach.empty() ? 0.0 : sequence.approach[k], drive);
    PatchStep stage;
    static_cast<PatchValues &>(stage) = steps.values();
    stage.time = history.now;
    const double next = k + 1 < sequence.time.size() ? sequence.time[k + 1] : stage.time;
    history.add(stage, next, sequence, steps.fields());
  }
  return steps.result();
}

} // namespace wheelrail
