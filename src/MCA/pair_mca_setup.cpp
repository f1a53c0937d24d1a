// SPDX-License-Identifier: GPL-2.0-or-later
// The part of pair style mca that serves the input script: its commands, materials, checks, restart
// files. What a step computes stands in pair_mca.cpp.

#include "pair_mca.h"

#include "arguments.h"
#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "files/material_file.h"
#include "fix_deform.h"
#include "fix_mca_history.h"
#include "fix_mca_state.h"
#include "fix_order.h"
#include "fix_setforce.h"
#include "force.h"
#include "group.h"
#include "input.h"
#include "laws/contact_step.h"
#include "laws/interface_words.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"
#include "pair_hybrid.h"
#include "restart_block.h"
#include "update.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <optional>

using namespace LAMMPS_NS;

static constexpr const char *DUMMY_HISTORY = "MCA_HISTORY_DUMMY";
static constexpr const char *DUMMY_STATE = "MCA_STATE_DUMMY";

/* ---------------------------------------------------------------------- */

PairMCA::PairMCA(LAMMPS *host)
    : Pair(host), packing(nullptr), depth(0.0), cut_user(0.0), mca_step(2), integrated(0), held(0),
      held_in_y(0), held_spins(0), fix_history(nullptr), fix_state(nullptr), fix_spins(nullptr),
      told(false), told_of_stress(false)
{
  single_enable = 0;
  manybody_flag = 1;
  no_virial_fdotr_compute = 1; // ghosts hold no forces
  restartinfo = 1;
  one_coeff = 0;
  centroidstressflag = CENTROID_NOTAVAIL;
  nextra = 6; // see tally()
  pvector = new double[nextra]();
  std::fill_n(columns, mca::stateCount, -1);

  // placeholders, which are replaced in init_style(), when a restart file's contents for them are
  // known
  if (modify->get_fix_by_id(FixMCAHistory::ID) || modify->get_fix_by_id(DUMMY_HISTORY))
    error->all(FLERR, "Only one pair style mca at a time allowed");
  modify->add_fix(fmt::format("{} all DUMMY", DUMMY_HISTORY));
  modify->add_fix(fmt::format("{} all DUMMY", DUMMY_STATE));
}

PairMCA::~PairMCA()
{
  if (copymode)
    return;
  for (const char *id :
       {FixMCAHistory::ID, FixMCAState::ID, FixMCAState::SPINS, DUMMY_HISTORY, DUMMY_STATE})
    if (modify->get_fix_by_id(id))
      modify->delete_fix(id);
  delete[] pvector;
  if (allocated) {
    memory->destroy(setflag);
    memory->destroy(cutsq);
  }
}

/* ---------------------------------------------------------------------- */

void PairMCA::allocate()
{
  allocated = 1;
  const int n = atom->ntypes + 1;
  memory->create(setflag, n, n, "pair:setflag");
  memory->create(cutsq, n, n, "pair:cutsq");
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++)
      setflag[i][j] = 0;
  materials.assign(n, mca::Material());
}

/* pair_style mca [packing name] [thickness h] [cutoff c] [law keywords] */

void PairMCA::settings(int narg, char **arg)
{
  std::vector<std::string> words;
  double h = 0.0, cut = 0.0;
  const mca::Packing *named = nullptr;
  for (int iarg = 0; iarg < narg; iarg++) {
    double *own = strcmp(arg[iarg], "thickness") == 0 ? &h
                  : strcmp(arg[iarg], "cutoff") == 0  ? &cut
                                                      : nullptr;
    const bool is_packing = strcmp(arg[iarg], "packing") == 0;
    if (!own && !is_packing) {
      words.emplace_back(arg[iarg]);
      if (iarg + 1 < narg)
        words.emplace_back(arg[++iarg]);
      continue;
    }
    if (iarg + 1 == narg)
      error->all(FLERR, "Pair style mca keyword {} has no value", arg[iarg]);
    if (is_packing) {
      named = mca::findPacking(arg[++iarg]);
      if (!named)
        error->all(FLERR, "Pair style mca keyword packing, value {}, allowed: hex, fcc, hcp, sc",
                   arg[iarg]);
      continue;
    }
    const std::string keyword = arg[iarg++];
    *own = mca::number(lmp, "Pair style mca " + keyword, arg[iarg], mca::Sign::Positive);
  }
  mca::LawSet chosen;
  const std::string problem = chosen.parse(words);
  if (!problem.empty())
    error->all(FLERR, "Pair style mca: {}", problem);
  lawset = chosen;
  packing = named;
  depth = h;
  cut_user = cut;
}

/* pair_coeff I J file.mca [temperature T] [quantity value] ...; materials belong to types, so I = J
 * as ranges */

void PairMCA::coeff(int narg, char **arg)
{
  if (narg < 3)
    error->all(FLERR, "Pair_coeff of mca needs: types types file.mca [quantity value], or types "
                      "types interface [keyword value]");
  if (!allocated)
    allocate();
  if (strcmp(arg[2], "interface") == 0) {
    coeff_interface(narg, arg);
    return;
  }
  const auto [ilo, ihi] = mca::typeRange(lmp, "Pair_coeff of mca: I", arg[0], atom->ntypes);
  const auto [jlo, jhi] = mca::typeRange(lmp, "Pair_coeff of mca: J", arg[1], atom->ntypes);
  if (ilo != jlo || ihi != jhi)
    error->all(FLERR,
               "Pair_coeff {} {}: a material belongs to a type; give the same range twice, "
               "pairs of unlike types follow from both, or have an interface",
               arg[0], arg[1]);
  mca::Material material;
  try {
    const std::string text =
        mca::fileText(lmp, utils::get_potential_file_path(arg[2]),
                      fmt::format("potential file {} (nor in LAMMPS_POTENTIALS)", arg[2]));
    std::vector<std::string> words(arg + 3, arg + narg);
    const std::optional<double> temperature = mca::takeTemperature(words);
    material = mca::readMaterial(text, arg[2], update->unit_style, temperature);
    material = mca::overrideMaterial(material, words);
  } catch (const mca::MaterialError &e) {
    error->all(FLERR, "Pair_coeff of mca: {}", e.what());
  }
  for (int i = ilo; i <= ihi; i++) {
    materials[i] = material;
    std::fill(setflag[i] + i, setflag[i] + ihi + 1, 1);
  }
}

/* pair_coeff I J interface [keyword value] ...; without a keyword both materials decide again */

void PairMCA::coeff_interface(int narg, char **arg)
{
  const auto [ilo, ihi] = mca::typeRange(lmp, "Pair_coeff of mca: I", arg[0], atom->ntypes);
  const auto [jlo, jhi] = mca::typeRange(lmp, "Pair_coeff of mca: J", arg[1], atom->ntypes);
  mca::Interface interface;
  if (const std::string problem = mca::readInterface({arg + 3, arg + narg}, lawset, interface);
      !problem.empty())
    error->all(FLERR, "Pair_coeff {} {} of mca: {}", arg[0], arg[1], problem);
  for (int i = ilo; i <= ihi; i++)
    for (int j = jlo; j <= jhi; j++)
      if (interface.empty())
        interfaces.erase(std::minmax(i, j));
      else
        interfaces[std::minmax(i, j)] = interface;
}

/* ---------------------------------------------------------------------- */

void PairMCA::init_style()
{
  if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag || !atom->torque_flag)
    error->all(FLERR, "Pair style mca requires atom style sphere");
  const double *const weights = force->special_lj; // of 1-2, 1-3 and 1-4 neighbours, from 1 on
  if (atom->molecular != Atom::ATOMIC &&
      std::any_of(weights + 1, weights + 4, [](double weight) { return weight != 1.0; }))
    error->all(FLERR, "Pair style mca requires special_bonds lj 1 1 1");
  check_commands();
  find_held();
  if (auto *hybrid = dynamic_cast<PairHybrid *>(force->pair))
    for (int i = 1; i <= atom->ntypes; i++)
      for (int j = i; j <= atom->ntypes; j++)
        if (!hybrid->check_ijtype(i, j, const_cast<char *>("mca")))
          error->all(FLERR,
                     "Pair style mca in {} has to act between all types, not so {} {}: begin "
                     "with pair_coeff * * mca file.mca",
                     force->pair_style, i, j);
  comm->ghost_velocity = 1; // shear of a contact needs both velocities

  // pairs at borders on both ranks, whatever the command newton says: no sums are sent back
  neighbor->add_request(this, NeighConst::REQ_NEWTON_OFF);
  choose_packing();

  if (fix_history) {
    check_internal_fixes();
  } else {
    for (const char *id : {DUMMY_HISTORY, DUMMY_STATE})
      if (!modify->get_fix_by_id(id))
        error->all(FLERR, "Fix {} of pair_style mca is gone: it must not be unfixed", id);
    mca_step = mca::Step(domain->dimension);
    fix_history = dynamic_cast<FixMCAHistory *>(modify->replace_fix(
        DUMMY_HISTORY,
        fmt::format("{} all MCA_HISTORY {}", FixMCAHistory::ID, links().storedSize()), 1));
    fix_history->attach(this);
    fix_state =
        modify->replace_fix(DUMMY_STATE,
                            fmt::format("{} all MCA_STATE {} writedata no ghost yes",
                                        FixMCAState::ID, mca::propertyWords(domain->dimension)),
                            1);
  }
  if (lawset.resistsSlip() && !fix_spins)
    fix_spins = modify->add_fix(fmt::format("{} all MCA_STATE {} writedata no ghost yes",
                                            FixMCAState::SPINS,
                                            mca::propertyWords(domain->dimension, false)));
  // before all fixes of the input script, also of those that it defined before the pair style
  mca::moveToFront(lmp, fix_state);
  mca::moveToFront(lmp, fix_history);
  find_columns();
  make_laws();
  warn_of_sizes();
  keep_sizes();
  for (int i = 0; i < atom->nlocal; i++)
    set_size(i);
}

/* what the materials give now, for warn_of_sizes() */

void PairMCA::keep_sizes()
{
  last_diameters.clear();
  last_masses.clear();
  for (int type = 1; type <= atom->ntypes; type++) {
    last_diameters.push_back(materials[type].diameter);
    last_masses.push_back(mass(type));
  }
}

void PairMCA::set_size(int i)
{
  atom->radius[i] = 0.5 * materials[atom->type[i]].diameter;
  atom->rmass[i] = mass(atom->type[i]);
}

void PairMCA::find_columns()
{
  int is_double, values;
  for (int k = 0; k < mca::stateCount; k++)
    columns[k] =
        atom->find_custom(mca::propertyName(mca::automatonStates[k]).c_str(), is_double, values);
}

/* the default packing depends on the dimension, which is known when the box is there */

void PairMCA::choose_packing()
{
  const int dimension = domain->dimension;
  if (!packing)
    packing = dimension == 2 ? &mca::packing::hex : &mca::packing::fcc;
  if (packing->dimension != dimension)
    error->all(FLERR, "Pair style mca keyword packing, value {}, allowed in dimension {}: {}",
               packing->name, dimension, dimension == 2 ? "hex" : "fcc, hcp, sc");
  const bool misplaced = dimension == 3 && depth > 0.0;
  const std::string other = misplaced ? "thickness" : lawset.notInDimension(dimension);
  if (!other.empty())
    error->all(FLERR, "Pair style mca: {} is for dimension {} only{}", other, 5 - dimension,
               lawset.fracture.actsIn(dimension)
                   ? ""
                   : ": in space a link keeps no axes of its face, from which the principal "
                     "stresses would follow; drucker-prager has both strengths there");
}

mca::Cell PairMCA::cell(int type) const
{
  return {*packing, materials[type].diameter, thickness()};
}

bool PairMCA::knows_masses() const
{
  if (!packing || !allocated)
    return false;
  for (int type = 1; type <= atom->ntypes; type++)
    if (!setflag[type][type])
      return false;
  return true;
}

double PairMCA::mass(int type) const
{
  return cell(type).mass(materials[type].density);
}

double PairMCA::inertia(int type) const
{
  return cell(type).inertia(materials[type].density);
}

/* what moves automata without velocities leaves the shear of links behind */

namespace {
struct Borders : Comm {
  static int group(const Comm &comm)
  {
    static constexpr int Comm::*number = &Borders::bordergroup;
    return comm.*number;
  }
};
} // namespace

void PairMCA::check_commands() const
{
  if (update->whichflag == 2)
    error->all(FLERR,
               "Pair style mca does not work with minimize: the shear of links follows only motion "
               "in a run; use a damped run (fix viscous)");
  if (utils::strmatch(update->integrate_style, "^respa"))
    error->all(FLERR, "Pair style mca does not work with run_style respa");
  if (input->command && strcmp(input->command, "rerun") == 0)
    error->all(FLERR,
               "Pair style mca does not work with rerun: a dump does not hold the state of links");
  const bool excludes = neighbor->nex_type + neighbor->nex_group + neighbor->nex_mol > 0;
  if (Borders::group(*comm) != 0)
    error->all(FLERR, "Pair style mca does not work with comm_modify group: links of other "
                      "automata over borders would be lost");
  if (utils::strmatch(force->pair_style, "^hybrid/scaled"))
    error->all(FLERR, "Pair style mca does not work with pair_style hybrid/scaled: flow and links "
                      "follow from the whole stress");
  if (excludes || neighbor->includegroup)
    error->all(FLERR,
               "Pair style mca does not work with neigh_modify {}: pairs that are left out of the "
               "list lose their links; give fix freeze to automata that are held",
               excludes ? "exclude" : "include");
  const int tilts = Fix::BOX_CHANGE_YZ | Fix::BOX_CHANGE_XZ | Fix::BOX_CHANGE_XY;
  int box = tilts, periodic = tilts; // LAMMPS tilts over periodic faces only
  for (const auto &[size, m] :
       {std::pair{Fix::BOX_CHANGE_X, 0}, {Fix::BOX_CHANGE_Y, 1}, {Fix::BOX_CHANGE_Z, 2}}) {
    box |= size;
    periodic |= domain->periodicity[m] ? size : 0;
  }
  for (const Fix *fix : modify->get_fix_list()) {
    const auto *deform = dynamic_cast<const FixDeform *>(fix);
    const int remap = deform ? deform->remapflag : Domain::X_REMAP;
    const int moved = remap == Domain::V_REMAP ? 0 : remap == Domain::NO_REMAP ? periodic : box;
    if (fix->box_change & moved)
      error->all(FLERR,
                 "Pair style mca does not work with fix {} {}: it moves automata without their "
                 "velocities, or images over a periodic face; deform the box by fix deform with "
                 "remap v",
                 fix->id, fix->style);
    if (!deform || !(fix->box_change & periodic))
      continue;
    if (fix->nevery > 1)
      error->all(FLERR,
                 "Pair style mca does not work with fix {} deform {}: images over a periodic face "
                 "would jump, which their velocities do not tell; change the box in every step, "
                 "fix deform 1",
                 fix->id, fix->nevery);
    if (fix->igroup != 0)
      error->all(FLERR,
                 "Pair style mca does not work with fix {} deform of group {}: images of other "
                 "automata would move without their velocities; give it group all",
                 fix->id, group->names[fix->igroup]);
  }
}

/* which components of forces fix setforce sets, which its NULL leaves alone; with a region it
   counts as if it had none */

namespace {
struct SetForce : FixSetForce {
  static bool sets(const FixSetForce &fix, int m)
  {
    static constexpr int FixSetForce::*styles[] = {&SetForce::xstyle, &SetForce::ystyle,
                                                   &SetForce::zstyle};
    return fix.*styles[m] != 0; // its first value stands for NULL
  }
};
} // namespace

/* whose velocity follows from the forces of contacts, as viscous forces need to know */

PairMCA::Prescribed PairMCA::prescribed(const Fix *fix) const
{
  for (const char *style : {"^freeze", "^move", "^rigid", "^mca/drive"})
    if (utils::strmatch(fix->style, style))
      return {true, true, true, true};
  const auto *sets = dynamic_cast<const FixSetForce *>(fix);
  if (!sets)
    return {};
  Prescribed found = {false, true, SetForce::sets(*sets, 1), false};
  for (int m = 0; m < domain->dimension; m++) {
    found.any |= SetForce::sets(*sets, m);
    found.all &= SetForce::sets(*sets, m);
  }
  return found;
}

/* What is held in some components only counts as following the forces in all: an error of the order
   of a step in those. The other way about the longest steps that are allowed are unstable. */

void PairMCA::find_held()
{
  integrated = held = held_in_y = held_spins = 0;
  for (const Fix *fix : modify->get_fix_list()) {
    const Prescribed motion = prescribed(fix);
    held |= motion.all ? fix->groupbit : 0;
    held_in_y |= motion.y ? fix->groupbit : 0;
    held_spins |= motion.spin ? fix->groupbit : 0;
    if (fix->time_integrate && !motion.any)
      integrated |= fix->groupbit;
  }
}

bool PairMCA::is_integrated(int i) const
{
  return atom->mask[i] & integrated;
}

bool PairMCA::is_held_in_y(int i) const
{
  return (atom->mask[i] & held_in_y) || !is_integrated(i);
}

/* stresses inside are energy per volume, which is pressure units only where nktv2p is 1 */

double PairMCA::stress_unit() const
{
  return force->nktv2p;
}

mca::Material PairMCA::material_inside(int type) const
{
  mca::Material m = materials[type];
  m.youngsModulus /= stress_unit();
  m.strength /= stress_unit();
  m.viscosity /= stress_unit();
  m.density *= force->mvv2e;
  return m;
}

mca::Interface PairMCA::interface_inside(int typeI, int typeJ) const
{
  const mca::Interface *const own = mca::findInterface(interfaces, typeI, typeJ);
  mca::Interface inside = own ? *own : mca::Interface();
  if (inside.strength)
    *inside.strength /= stress_unit();
  if (inside.viscosity)
    *inside.viscosity /= stress_unit();
  return inside;
}

double PairMCA::strength(int typeI, int typeJ) const
{
  const mca::Interface *const own = mca::findInterface(interfaces, typeI, typeJ);
  const double weaker = std::min(materials[typeI].strength, materials[typeJ].strength);
  return own ? own->strength.value_or(weaker) : weaker;
}

void PairMCA::make_laws()
{
  mca::Interfaces own;
  for (const auto &[types, interface] : interfaces) {
    if (const std::string problem = mca::problemOf(interface, lawset); !problem.empty())
      error->all(FLERR, "Pair_coeff {} {} of mca: {}", types.first, types.second, problem);
    own[types] = interface_inside(types.first, types.second);
  }
  std::vector<mca::Material> inside = {material_inside(1)}; // types begin with 1
  for (int type = 1; type <= atom->ntypes; type++)
    inside.push_back(material_inside(type));
  mca_step.setLaws({lawset, inside, thickness(), *packing, own});
}

double PairMCA::init_one(int i, int j)
{
  const mca::Material &a = materials[i], &b = materials[j];
  const double d = 0.5 * (a.diameter + b.diameter);
  const mca::Interface own = interface_inside(i, j);
  const double breaking =
      std::max({a.breakingStrain, b.breakingStrain, own.breakingStrain.value_or(0.0)});
  const double room = lawset.keepsVolume() ? mca::roomReach : 0.0;
  const double longest = lawset.keepsVolume() ? std::exp(breaking) - 1.0 : breaking; // of a link
  const double reach = d * (1.0 + std::max(longest, room));
  if (cut_user > 0.0 && cut_user < reach)
    error->all(FLERR, "Pair style mca cutoff {} is below the {} {} of types {} {}", cut_user,
               room > longest ? "reach of the room (plasticity isochoric)" : "breaking distance",
               reach, i, j);
  // room for links that compression of their neighbours keeps below the breaking stress
  const double margin = std::max(2.0 * std::max(breaking, 0.05), room);
  return cut_user > 0.0 ? cut_user : d * (1.0 + margin);
}

void PairMCA::setup()
{
  check_step();
}

void PairMCA::reset_dt()
{
  check_step();
}

void PairMCA::check_step()
{
  if (!knows_masses()) // the command timestep, before the materials: setup() looks again
    return;
  if (!(update->dt > 0.0))
    error->all(FLERR, "Timestep {:.6g} is not allowed with pair_style mca, must be > 0",
               update->dt);
  struct Meeting {
    mca::CriticalStep limit;
    double longest;
    std::string of;
  };
  std::optional<Meeting> worst, stiffest;
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      // types of one material are one type, but for interfaces
      const auto known = [this](int type) {
        return std::find(materials.begin() + 1, materials.begin() + type, materials[type]) !=
               materials.begin() + type;
      };
      const mca::Interface own = interface_inside(i, j);
      if (own.empty() && (known(i) || (j != i && (known(j) || materials[i] == materials[j]))))
        continue;
      const auto limit =
          mca::contactStep(lawset, material_inside(i), material_inside(j), *packing, own);
      const Meeting pair = {limit, mca::longestStep(lawset, limit),
                            i == j && own.empty()
                                ? fmt::format("of the material of type {}", i)
                                : fmt::format("where types {} and {} meet", i, j)};
      if (!worst || pair.longest < worst->longest)
        worst = pair;
      if (!stiffest || pair.limit.elastic < stiffest->limit.elastic)
        stiffest = pair;
    }
  if (update->dt > worst->longest)
    error->all(FLERR,
               "Timestep {:.6g} is longer than the critical one, {:.6g} (elastic {:.6g}, viscous "
               "{:.6g}, pressed links {:.6g}) {}",
               update->dt, worst->longest, worst->limit.elastic, worst->limit.viscous,
               worst->limit.pressed, worst->of);
  const double elastic = stiffest->limit.elastic;
  if (comm->me == 0 && lawset.fracture.word() != "none" && update->dt > 0.5 * elastic)
    error->warning(FLERR,
                   "Timestep {:.6g} is {:.2f} of the critical one of elasticity, {:.6g}, {}: links "
                   "that break lose too little energy, 8 % less at 0.7 of it, 28 % at 1; at a "
                   "timestep of {:.3g} it is 3 %",
                   update->dt, update->dt / elastic, elastic, stiffest->of, 0.36 * elastic);
}

/* ----------------------------------------------------------------------
   restart: the laws as the words of the pair_style command, then the materials
------------------------------------------------------------------------- */

void PairMCA::write_restart_settings(FILE *fp)
{
  seal.keepPlace(fp);
  mca::writeBlock(fp, mca::textOf(mca::PairSettings{depth, cut_user, packing, lawset}));
  if (force->pair != this) // pair_style hybrid writes no more of its styles
    mca::writeBlock(fp, mca::textOfInterfaces(interfaces));
}

void PairMCA::close_restart_file(const char *path)
{
  if (comm->me != 0)
    return;
  std::string base = path;
  if (const size_t parts = base.find('%'); parts != std::string::npos)
    base.replace(parts, 1, "base");
  if (!seal.close(base))
    error->one(FLERR, "Cannot write the checksum of restart file {}: {}", base,
               std::strerror(errno));
}

void PairMCA::read_restart_settings(FILE *fp)
{
  mca::checkSeal(lmp, fp);
  const std::string text = mca::blockText(lmp, fp, "pair_style mca");
  const auto settings = mca::readOrStop(lmp, [&] { return mca::settingsIn(text); });
  depth = settings.thickness;
  cut_user = settings.cutoff;
  packing = settings.packing;
  lawset = settings.laws;
  if (force->pair != this)
    read_interfaces(fp);
  told_of_stress = true;
  // LAMMPS keeps the time of the last run's beginning, and its step, and forgets what lies between
  update->update_time();
}

void PairMCA::read_interfaces(FILE *fp)
{
  const std::string own = mca::blockText(lmp, fp, "pair_coeff interface of mca");
  interfaces = mca::readOrStop(lmp, [&] { return mca::interfacesIn(own, atom->ntypes, lawset); });
}

void PairMCA::write_restart(FILE *fp)
{
  write_restart_settings(fp);
  mca::writeBlock(fp,
                  mca::textOf(std::vector<mca::Material>(materials.begin() + 1, materials.end())));
  mca::writeBlock(fp, mca::textOfInterfaces(interfaces));
}

void PairMCA::read_restart(FILE *fp)
{
  read_restart_settings(fp);
  if (!allocated)
    allocate();
  const std::string text = mca::blockText(lmp, fp, "pair_coeff of mca");
  const auto read = mca::readOrStop(lmp, [&] { return mca::materialsIn(text, atom->ntypes); });
  for (int i = 1; i <= atom->ntypes; i++) {
    materials[i] = read[i - 1];
    setflag[i][i] = 1;
  }
  if (packing)
    keep_sizes();
  read_interfaces(fp);
}
