// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_mca_drive.h"

#include "arguments.h"
#include "atom.h"
#include "comm.h"
#include "compute.h"
#include "core/energy_account.h"
#include "domain.h"
#include "dump.h"
#include "error.h"
#include "flat.h"
#include "force.h"
#include "group.h"
#include "input.h"
#include "modify.h"
#include "output.h"
#include "pair_mca.h"
#include "restart_block.h"
#include "shared/friction_log_format.h"
#include "shared/nearest_word.h"
#include "update.h"
#include "variable.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <tuple>

using namespace LAMMPS_NS;
using namespace FixConst;

/* fix ID group mca/drive velocity V pressure P [file F] [every N] [seed S] */

FixMCADrive::FixMCADrive(LAMMPS *host, int narg, char **arg)
    : Fix(host, narg, arg), every(1000), seed(0), pair(nullptr), begun(false),
      restarted(false), past{-1, 0}, largest_velocity(0.0), largest_pressure(0.0),
      least_strength(0.0), least_bulk_modulus(0.0), least_link_pressure(0.0), largest_diameter(0.0),
      split(false), moved_at(0.0), above(0.0), below(0.0), told_of_room(false),
      told_of_fall(false), most_dissipated{}
{
  namespace format = mcawr::friction_log; // as the readers of the log take it
  const auto most_steps = static_cast<bigint>(format::largest);
  const auto largest_seed = static_cast<bigint>(format::largestWhole);
  bool has_velocity = false, has_pressure = false;
  for (int iarg = 3; iarg < narg; iarg += 2) {
    const std::string keyword = arg[iarg];
    if (iarg + 1 == narg)
      error->all(FLERR, "Fix mca/drive keyword {} has no value", keyword);
    const char *value = arg[iarg + 1];
    if (keyword == "velocity") {
      velocity = parse_setting("velocity", value);
      has_velocity = true;
    } else if (keyword == "pressure") {
      pressure = parse_setting("pressure", value);
      has_pressure = true;
    } else if (keyword == "file") {
      path = value;
      if (path.empty())
        error->all(FLERR, "Fix mca/drive file is '', allowed: a file name");
    } else if (keyword == "every") {
      every = mca::wholeNumber(lmp, "Fix mca/drive every", value, 1, most_steps);
    } else if (keyword == "seed") {
      seed = mca::wholeNumber(lmp, "Fix mca/drive seed", value, -largest_seed, largest_seed);
    } else {
      error->all(FLERR, "Fix mca/drive: {}",
                 mcawr::unknownWord("keyword", keyword,
                                    {"velocity", "pressure", "file", "every", "seed"}));
    }
  }
  if (!has_velocity || !has_pressure)
    error->all(FLERR, "Fix mca/drive needs both keywords velocity and pressure");
  if (const auto *known = mca::findUnits(update->unit_style))
    units = *known;
  else if (!path.empty())
    error->all(FLERR,
               "Fix mca/drive: no friction log in units {}, allowed: nano, si, cgs, micro, "
               "metal, real",
               update->unit_style);

  nevery = 1;
  time_depend = 1;
  restart_global = 0; // until there is something to go on with
  scalar_flag = vector_flag = 1;
  size_vector = 8;
  global_freq = 1;
  extscalar = extvector = 0;
}

FixMCADrive::Setting FixMCADrive::parse_setting(const char *keyword, const char *word)
{
  Setting s;
  if (utils::strmatch(word, "^v_."))
    s.variable = word + 2;
  else
    s.value = mca::number(
        lmp, fmt::format("Fix mca/drive {}", keyword), word,
        strcmp(keyword, "pressure") == 0 ? mca::Sign::NotNegative : mca::Sign::Any, " or v_name");
  return s;
}

int FixMCADrive::setmask()
{
  return POST_NEIGHBOR | POST_FORCE | END_OF_STEP;
}

void FixMCADrive::init()
{
  pair = PairMCA::find(lmp, "Fix mca/drive");
  if (group->dynamic[igroup])
    error->all(FLERR, "Fix mca/drive: group {} is dynamic, allowed: a static group",
               group->names[igroup]);
  if (group->count(igroup) == 0)
    error->all(FLERR, "Fix mca/drive: group {} is empty", group->names[igroup]);
  for (const Setting &s : {velocity, pressure})
    if (!s.variable.empty())
      number_of(s.variable);
  check_layer();
  find_limits();
}

/* commands can take a variable away between the parts of a run, too */

int FixMCADrive::number_of(const std::string &variable) const
{
  const int found = input->variable->find(variable.c_str());
  if (found < 0 || !input->variable->equalstyle(found))
    error->all(FLERR, "Fix mca/drive: no equal-style variable {}", variable);
  return found;
}

/* number of automata, of all ranks, in both groups */

bigint FixMCADrive::shared_with(const Fix *other) const
{
  bigint part = 0, both;
  for (int i = 0; i < atom->nlocal; i++)
    part += (atom->mask[i] & groupbit) && (atom->mask[i] & other->groupbit);
  MPI_Allreduce(&part, &both, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  return both;
}

/* the layer is this fix's alone, and something moves it by the velocities that this fix gives */

void FixMCADrive::check_layer() const
{
  for (const Fix *other : modify->get_fix_list()) {
    const bool prescribes = other != this && pair->prescribed(other).any;
    const bigint both = prescribes ? shared_with(other) : 0;
    if (both == 0)
      continue;
    if (utils::strmatch(other->style, "^mca/drive"))
      error->all(FLERR, "Fix mca/drive {} and {}: both drive {} automata, allowed: none", id,
                 other->id, both);
    if (!utils::strmatch(other->style, "^setforce"))
      error->all(FLERR,
                 "Fix mca/drive {}: fix {} {} moves or holds {} of its automata, allowed: none", id,
                 other->id, other->style, both);
    if (comm->me == 0)
      error->warning(FLERR,
                     "Fix mca/drive {}: fix {} {} sets forces of {} of its automata: what it sets "
                     "is no stress of the contacts",
                     id, other->id, other->style, both);
  }
  bigint part = 0, resting;
  for (int i = 0; i < atom->nlocal; i++)
    part += (atom->mask[i] & groupbit) && !pair->is_integrated(i);
  MPI_Allreduce(&part, &resting, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (resting > 0)
    error->all(FLERR,
               "Fix mca/drive {}: nothing moves {} of the {} automata of group {}, whose "
               "displacement it counts: put them into the group of fix nve/mca",
               id, resting, group->count(igroup), group->names[igroup]);
}

/* of all materials: loads that no sample stands (velocity of sound, Young's modulus), and what
   makes a junction */

void FixMCADrive::find_limits()
{
  largest_velocity = largest_pressure = 0.0;
  least_strength = least_bulk_modulus = least_link_pressure = HUGE_VAL;
  largest_diameter = 0.0;
  for (int type = 1; type <= atom->ntypes; type++) {
    largest_velocity = std::max(largest_velocity, pair->wave_speed(type));
    least_strength = std::min(least_strength, pair->material(type).strength);
    least_bulk_modulus = std::min(least_bulk_modulus, pair->material(type).bulkModulus());
    largest_pressure = std::max(largest_pressure, pair->material(type).youngsModulus);
    const mca::Material &material = pair->material(type);
    const mca::Threshold &links = pair->laws().link.threshold();
    least_link_pressure =
        std::min(least_link_pressure,
                 links.limit(material.strength, mca::LinkLaw::stress(material, material)));
    largest_diameter = std::max(largest_diameter, material.diameter);
  }
}

/* both settings of now */

void FixMCADrive::evaluate()
{
  const bool varies = !velocity.variable.empty() || !pressure.variable.empty();
  if (varies) // computes that a variable names are of this step, and are asked for in the next one
    modify->clearstep_compute();
  evaluate(velocity);
  evaluate(pressure);
  if (varies)
    modify->addstep_compute(update->ntimestep + 1);
  if (!(std::abs(velocity.value) < largest_velocity))
    error->all(FLERR,
               "Fix mca/drive velocity is {} in step {}, allowed: below the speed of sound, "
               "{:.6g}",
               velocity.value, update->ntimestep, largest_velocity);
  if (!(pressure.value >= 0.0 && pressure.value < largest_pressure))
    error->all(FLERR,
               "Fix mca/drive pressure is {} in step {}, allowed: >= 0 and below Young's modulus, "
               "{:.6g}",
               pressure.value, update->ntimestep, largest_pressure);
}

void FixMCADrive::evaluate(Setting &s) const
{
  if (!s.variable.empty())
    s.value = input->variable->compute_equal(number_of(s.variable));
}

/* y of an automaton of this rank, length units, not folded back into the box */

double FixMCADrive::unwrapped_y(int i) const
{
  double unwrapped[3];
  domain->unmap(atom->x[i], atom->image[i], unwrapped);
  return unwrapped[1];
}

double FixMCADrive::height() const
{
  double own[2] = {0.0, static_cast<double>(layer.members.size())}, all[2];
  for (const int i : layer.members)
    own[0] += unwrapped_y(i);
  MPI_Allreduce(own, all, 2, MPI_DOUBLE, MPI_SUM, world);
  return all[0] / all[1];
}

mca::Part FixMCADrive::part_of(int i) const
{
  if (atom->mask[i] & groupbit)
    return mca::Part::Driven;
  return pair->is_held_in_y(i) && atom->v[i][1] == 0.0 ? mca::Part::Held : mca::Part::Free;
}

FixMCADrive::Neighbourhood FixMCADrive::look_around() const
{
  mca::RigidLayers layers;
  for (int i = 0; i < atom->nlocal; i++)
    layers.add(part_of(i), unwrapped_y(i));
  double ends[4] = {-layers.heldLow, layers.heldHigh, -layers.drivenLow, layers.drivenHigh};
  MPI_Allreduce(MPI_IN_PLACE, ends, 4, MPI_DOUBLE, MPI_MAX, world);
  layers = {-ends[0], ends[1], -ends[2], ends[3]};
  mca::LayerContents own;
  for (int i = 0; i < atom->nlocal; i++) {
    const mca::Cell cell = pair->cell(atom->type[i]);
    own.add(layers, part_of(i), unwrapped_y(i), cell.cellVolume(), cell.diameter);
  }
  double sums_of[3] = {own.cells, own.above, own.below};
  MPI_Allreduce(MPI_IN_PLACE, sums_of, 3, MPI_DOUBLE, MPI_SUM, world);
  const mca::LayerContents all = {sums_of[0], sums_of[1], sums_of[2]};
  return {mca::roomOf(layers, all, layer.area), all.above, all.below};
}

std::array<double, 3> FixMCADrive::dissipated() const
{
  std::array<double, 3> terms = {};
  for (Compute *account : modify->get_compute_by_style("^mca/energy$")) {
    if (account->invoked_vector != update->ntimestep)
      account->compute_vector();
    for (int m = 0; m < 3; m++)
      terms[m] = account->vector[2 + m] * layer.stressUnit;
    terms[2] += account->vector[2 + mca::EnergyAccount::Friction] * layer.stressUnit;
  }
  return terms;
}

void FixMCADrive::setup_post_neighbor()
{
  post_neighbor();
}

/* in the order of IDs, so that sums do not depend on LAMMPS's order of atoms */

void FixMCADrive::post_neighbor()
{
  std::vector<int> &members = layer.members;
  members.clear();
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit)
      members.push_back(i);
  const tagint *tag = atom->tag;
  std::sort(members.begin(), members.end(), [tag](int a, int b) { return tag[a] < tag[b]; });
  double all[2] = {0.0, members.empty() ? 0.0 : 1.0};
  for (const int i : members) // fixes may add and delete automata within a run
    all[0] += atom->rmass[i];
  MPI_Allreduce(MPI_IN_PLACE, all, 2, MPI_DOUBLE, MPI_SUM, world);
  layer.mass = all[0];
  split = all[1] > 1.0;
}

double FixMCADrive::thickness() const
{
  return domain->dimension == 3 ? domain->zprd : pair->thickness();
}

void FixMCADrive::setup(int vflag)
{
  layer.area = domain->xprd * thickness();
  layer.stressUnit = force->nktv2p;
  if (!begun && !restarted) {
    sums.startHeight = height();
    sums.beginRow(totals());
  }
  evaluate();
  if (!begun && pressure.value > least_strength && comm->me == 0)
    error->warning(FLERR,
                   "Fix mca/drive pressure {:.6g} is above the strength of a material, {:.6g}",
                   pressure.value, least_strength);
  if (!begun) {
    row_start = sums.displacement;
    check_junctions();
  }
  if (!path.empty())
    open_log();
  begun = true;
  restart_global = 1;
  most_dissipated = {}; // the account may be another one, or gone
  const Neighbourhood around = look_around();
  above = around.above;
  below = around.below;
  // a layer that moves already keeps its velocity to the last bit
  double range[2] = {-HUGE_VAL, -HUGE_VAL}, all_range[2]; // of -v_y, v_y
  for (const int i : layer.members)
    for (const double sign : {-1.0, 1.0})
      range[sign > 0.0] = std::max(range[sign > 0.0], sign * atom->v[i][1]);
  MPI_Allreduce(range, all_range, 2, MPI_DOUBLE, MPI_MAX, world);
  post_force(vflag);
  if (all_range[0] == -all_range[1])
    for (const int i : layer.members)
      atom->v[i][1] = all_range[1];
}

void FixMCADrive::check_junctions() const
{
  namespace health = mcawr::layer_health;
  if (velocity.value == 0.0 || pressure.value == 0.0 || !domain->xperiodic ||
      !std::isfinite(least_link_pressure))
    return;
  const double d = largest_diameter, across = domain->xprd / d;
  const double places = domain->dimension == 3 ? across * thickness() / d : across;
  const double found = health::junctions(pressure.value, least_link_pressure, places);
  if (found < health::leastJunctions && comm->me == 0)
    error->warning(FLERR,
                   "Fix mca/drive: {:.2g} junctions carry pressure {:.6g} at once, fewer than "
                   "{:.0f}: mu scatters, and a sample of less than 160 automata in a layer (this "
                   "one: {:.4g}) may rub half as much as a wide one, or a quarter more",
                   found, pressure.value, health::leastJunctions, places);
}

/* begun, continued after a restart, or gone on with in a further run of the input script */

void FixMCADrive::open_log()
{
  int first_type = atom->ntypes + 1, lowest;
  for (int i = 0; i < atom->nlocal; i++)
    if ((atom->mask[i] & groupbit) && atom->type[i] < first_type)
      first_type = atom->type[i];
  MPI_Allreduce(&first_type, &lowest, 1, MPI_INT, MPI_MIN, world);
  mca::LogHeader header;
  std::vector<int> there(atom->ntypes + 1, 0);
  for (int i = 0; i < atom->nlocal; i++)
    there[atom->type[i]] = 1;
  MPI_Allreduce(MPI_IN_PLACE, there.data(), atom->ntypes + 1, MPI_INT, MPI_MAX, world);
  std::vector<mca::Material> materials;
  for (int type = 1; type <= atom->ntypes; type++)
    if (there[type])
      materials.push_back(pair->material(type));
  header.use(materials, pair->material(lowest));
  for (const auto &[types, interface] : pair->all_interfaces())
    if (there[types.first] && there[types.second])
      header.interfaces[types] = interface;
  header.pressure = pressure.value;
  header.velocity = velocity.value;
  header.width = domain->xprd;
  header.thickness = thickness();
  header.packing = pair->cell(lowest).packing.name;
  header.automata = atom->natoms;
  header.laws = pair->laws().words();
  header.timestep = update->dt;
  header.every = every;
  header.seed = seed;
  header.lammpsVersion = LMP_VERNUM;
  using mcawr::friction_log::Head;
  for (const auto &[varies, value] : {std::pair{!pressure.variable.empty(), &Head::pressure},
                                      {!velocity.variable.empty(), &Head::velocity},
                                      {!domain->xperiodic, &Head::width},
                                      {!domain->zperiodic, &Head::thickness}})
    if (varies)
      header.varying.emplace_back(mcawr::friction_log::headNumber(value).key);
  std::string problem, note;
  if (comm->me == 0) {
    for (const Dump *dump : output->get_dump_list())
      if (mcawr::isReplaced(path) && mcawr::isSameFile(path, dump->filename))
        problem = fmt::format("friction log {}: it is also the file of dump {}", path, dump->id);
    try {
      if (!problem.empty())
        throw std::runtime_error(problem);
      if (begun)
        log.check(header, units);
      else if (restarted && past.number >= 0)
        note = log.resume(path, header, units, update->ntimestep, past);
      else
        log.begin(path, header, units, update->ntimestep, lmp->restart_ver >= 0);
    } catch (const std::runtime_error &e) {
      problem = e.what();
    }
    if (!note.empty())
      error->warning(FLERR, "Fix mca/drive: {}", note);
  }
  stop_if(problem);
  dt_of_log = update->dt;
}

/* of all ranks, when rank 0 has a problem */

void FixMCADrive::stop_if(const std::string &problem)
{
  int failed = problem.empty() ? 0 : 1;
  MPI_Bcast(&failed, 1, MPI_INT, 0, world);
  if (failed) // rank 0 prints
    error->all(FLERR, "Fix mca/drive: {}", problem);
}

/* the time of a row is its step times the timestep */

void FixMCADrive::reset_dt()
{
  if (begun && !path.empty() && update->dt != dt_of_log)
    error->all(FLERR,
               "Fix mca/drive: timestep {} while friction log {} is open, allowed: {}, as in its "
               "head; give another file after unfix",
               update->dt, path, dt_of_log);
}

/* Ranks wait for each other only where the layer is split between them; what is for output is
   added up when asked for. */

void FixMCADrive::post_force(int /*vflag*/)
{
  if (domain->box_change) // as fix deform does
    layer.area = domain->xprd * thickness();
  const mca::DrivenLayer::Arrays now = arrays();
  mca::DrivenLayer::Pull pull = layer.pull(now);
  stress = layer.stress(pull);
  if (split) {
    double parts[3] = {pull.x, pull.y, pull.momentum};
    MPI_Allreduce(MPI_IN_PLACE, parts, 3, MPI_DOUBLE, MPI_SUM, world);
    pull = {parts[0], parts[1], parts[2]};
  }
  moved_at = velocity.value;
  evaluate();
  layer.carry(now, pull, {velocity.value, pressure.value});
}

mca::DrivenLayer::Arrays FixMCADrive::arrays() const
{
  mca::DrivenLayer::Arrays a{};
  a.v = mca::flat(atom->v);
  a.f = mca::flat(atom->f);
  a.omega = mca::flat(atom->omega);
  a.torque = mca::flat(atom->torque);
  a.mass = atom->rmass;
  return a;
}

void FixMCADrive::end_of_step()
{
  sums.add(layer, stress, moved_at, update->dt);
  if (!path.empty() && update->ntimestep % every == 0)
    write_row();
}

mca::DriveSums::Totals FixMCADrive::totals() const
{
  const PairMCA::Count c = pair->count();
  double all[6] = {c.links, c.broken, c.formed, sums.work, sums.shearSum, sums.normalSum};
  MPI_Allreduce(MPI_IN_PLACE, all, 6, MPI_DOUBLE, MPI_SUM, world);
  return {all[0], all[1], all[2], all[3], all[4], all[5]};
}

double FixMCADrive::sum(double part) const
{
  MPI_Allreduce(MPI_IN_PLACE, &part, 1, MPI_DOUBLE, MPI_SUM, world);
  return part;
}

void FixMCADrive::write_row()
{
  pair->check_sample();
  const mca::DriveSums::Totals all = totals();
  const Neighbourhood around = look_around();
  mca::DriveSums::State now;
  now.height = height();
  now.room = around.room;
  now.lost = around.above + around.below;
  now.dissipated = dissipated();
  std::string problem;
  if (comm->me == 0) {
    try {
      log.write(sums.row(all, now, update->ntimestep, update->dt, pressure.value, units));
    } catch (const std::runtime_error &e) {
      problem = e.what();
    }
  }
  stop_if(problem);
  check_health(now, around, all.work);
  sliding.add(std::abs(sums.displacement - row_start), all.broken - sums.brokenBefore,
              largest_diameter);
  row_start = sums.displacement;
  sums.beginRow(all);
}

void FixMCADrive::post_run()
{
  namespace health = mcawr::layer_health;
  const double share = sliding.share();
  if (told_of_smooth || !std::isfinite(least_link_pressure) ||
      sliding.way() < 10.0 * largest_diameter || share <= health::smoothLimit)
    return;
  told_of_smooth = true;
  if (comm->me == 0)
    error->warning(FLERR,
                   "Fix mca/drive: no link broke in {:.0f} % of the {:.4g} that the layer slid: it "
                   "was worn smooth, a wider sample has more junctions",
                   100.0 * share, sliding.way());
}

void FixMCADrive::check_health(const mca::DriveSums::State &now, const Neighbourhood &around,
                               double work)
{
  namespace health = mcawr::layer_health;
  std::vector<std::string> warnings;
  for (auto [known, count, which] :
       {std::tuple{&above, around.above, "driven"}, std::tuple{&below, around.below, "held"}}) {
    if (count > *known)
      warnings.push_back(
          fmt::format("{} automata left the fragment through the {} layer: {} more rows",
                      count - *known, which, which == std::string("held") ? "hold" : "drive"));
    *known = std::max(*known, count);
  }
  const double least = health::leastRoom(pressure.value, least_bulk_modulus);
  if (now.room > 0.0 && now.room < least && !told_of_room) {
    told_of_room = true;
    warnings.push_back(fmt::format(
        "automata of the layer have {:.4g} of the {} that they have in the solid, at {:.6g} at "
        "least {:.4g} is expected: they sink into each other, and this is no solid any more",
        now.room, domain->dimension == 3 ? "volume" : "area", pressure.value, least));
  }
  const char *terms[] = {"plastic flow", "breaking", "unlinked contacts"};
  const double done = std::abs(work) * layer.stressUnit;
  for (int m = 0; m < 3; m++) {
    const double fall = most_dissipated[m] - now.dissipated[m];
    most_dissipated[m] = std::max(most_dissipated[m], now.dissipated[m]);
    if (done > 0.0 && fall > health::fallAllowance * done && !told_of_fall) {
      told_of_fall = true;
      warnings.push_back(fmt::format(
          "what {} dissipates fell by {:.4g}, the drive has done {:.4g}: it gives energy to the "
          "motion, and friction is too small",
          terms[m], fall / layer.stressUnit, work));
    }
  }
  if (comm->me == 0)
    for (const std::string &warning : warnings)
      error->warning(FLERR, "Fix mca/drive: {}", warning);
}

/* friction coefficient of this step: shear stress over the prescribed pressure */

double FixMCADrive::compute_scalar()
{
  return pressure.value > 0.0 ? sum(stress.shear) / pressure.value : 0.0;
}

double FixMCADrive::compute_vector(int n)
{
  if (n == 0)
    return sum(stress.shear);
  if (n == 1)
    return sum(stress.normal);
  if (n == 2)
    return compute_scalar();
  if (n == 3)
    return sums.displacement;
  if (n == 5)
    return sum(sums.work);
  pair = PairMCA::find(lmp, "Fix mca/drive"); // another one may be there since the last run
  if (!begun || !pair->knows_masses())
    return 0.0;
  if (n == 4) {
    if (!pair->in_run()) // commands may have taken automata away since the last step
      post_neighbor();
    return height() - sums.startHeight;
  }
  const Neighbourhood around = look_around();
  return n == 6 ? around.room : around.above + around.below;
}

/* ----------------------------------------------------------------------
   restart: the sums of the row that is being made
------------------------------------------------------------------------- */

void FixMCADrive::write_restart(FILE *fp)
{
  const mca::DriveSums::Totals all = totals();
  sums.gather(all, comm->me == 0); // as the run that continues will add them up
  if (comm->me != 0)
    return;
  mca::DriveState state;
  state.sums = sums;
  if (log.isOpen())
    state.rows = log.rows();
  mca::writeFixBlock(fp, mca::textOf(state));
}

void FixMCADrive::restart(char *buf)
{
  const std::string text = mca::fixBlockText(lmp, buf, "fix mca/drive");
  const auto state = mca::readOrStop(lmp, [&] { return mca::driveStateIn(text); });
  sums = state.sums;
  past = state.rows;
  if (comm->me != 0) // what all ranks know becomes the first one's
    sums.work = sums.shearSum = sums.normalSum = 0.0;
  restarted = true;
  restart_global = 1;
}
