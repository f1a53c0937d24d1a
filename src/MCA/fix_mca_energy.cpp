// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_mca_energy.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "flat.h"
#include "force.h"
#include "neighbor.h"
#include "pair_mca.h"
#include "restart_block.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <string>
#include <utility>

using namespace LAMMPS_NS;
using namespace FixConst;

using Account = mca::EnergyAccount;

FixMCAEnergy::FixMCAEnergy(LAMMPS *host, int narg, char **arg)
    : Fix(host, narg, arg), pair(nullptr), start(0.0), last(0.0), led(0.0), booked{}, highest{},
      begun(false), fresh(false), told(false), box{}, before_faces(0.0), count(0)
{
  if (strcmp(id, ID) != 0)
    error->all(FLERR, "Fix {} is internal to compute mca/energy, which makes it itself", ID);
  nevery = 1;
  restart_global = 0; // until the account begins
}

int FixMCAEnergy::setmask()
{
  return POST_INTEGRATE | PRE_FORCE | END_OF_STEP;
}

void FixMCAEnergy::init()
{
  pair = PairMCA::find(lmp, "Compute mca/energy");
}

static const double (*rowsOf(const std::vector<double> &values))[3]
{
  return reinterpret_cast<const double(*)[3]>(values.data());
}

static Account::Edges edgesOf(const Domain *domain)
{
  Account::Edges edges;
  std::copy_n(domain->h, 6, edges.h);
  return edges;
}

void FixMCAEnergy::setup_pre_force(int vflag)
{
  pre_force(vflag);
}

void FixMCAEnergy::pre_force(int /*vflag*/)
{
  box = edgesOf(domain);
}

/* the forces of fixes that were defined later, and what their set-up does to velocities, are
   missing: keep() here is for what does not depend on them */

void FixMCAEnergy::setup(int /*vflag*/)
{
  const auto kept = [this](double **rows) {
    const double *const first = mca::flat(rows)[0];
    return std::vector<double>(first, first + 3 * static_cast<size_t>(atom->nlocal));
  };
  places = kept(atom->x);
  velocities = kept(atom->v);
  spins = kept(atom->omega);
  keep(mca::flat(atom->x));
  ids.assign(atom->tag, atom->tag + atom->nlocal);
  fresh = true;
  count = automata();
}

/* What no integrator moves by its forces is held, or led as by fix move: as if another force
   balanced that of the contacts, whose work is booked then. */

void FixMCAEnergy::keep(const double (*x)[3])
{
  forces.assign(3 * static_cast<size_t>(atom->nlocal), 0.0);
  torques.assign(3 * static_cast<size_t>(atom->nlocal), 0.0);
  for (int i = 0; i < atom->nlocal; i++)
    if (pair->is_integrated(i)) {
      std::copy_n(atom->f[i], 3, &forces[3 * i]);
      std::copy_n(atom->torque[i], 3, &torques[3 * i]);
    }
  account.keep(pair->step(), x, rowsOf(forces), rowsOf(torques), box);
}

FixMCAEnergy::Held FixMCAEnergy::held(const double (*v)[3], const double (*omega)[3]) const
{
  Held own = {0.0, -account.released(), 0.0};
  const double half = 0.5 * update->dt * force->ftm2v;
  struct Body {
    double mass, inertia, push, turn;
  };
  std::vector<Body> bodies(atom->ntypes + 1);
  for (int type = 1; type <= atom->ntypes; type++) {
    const double mass = pair->mass(type), inertia = pair->inertia(type);
    bodies[type] = {mass, inertia, half / mass, half / inertia};
  }
  for (int i = 0; i < atom->nlocal; i++) {
    const Body &body = bodies[atom->type[i]];
    double kinetic = 0.0;
    for (int m = 0; m < 3; m++) {
      kinetic += mca::leapfrogEnergy(body.mass, v[i][m], body.push * forces[3 * i + m]);
      kinetic += mca::leapfrogEnergy(body.inertia, omega[i][m], body.turn * torques[3 * i + m]);
    }
    own.kinetic += kinetic;
    own.led += pair->is_integrated(i) ? 0.0 : kinetic;
    own.elastic += pair->step().energy(i);
  }
  own.kinetic *= force->mvv2e;
  own.led *= force->mvv2e;
  return own;
}

FixMCAEnergy::Held FixMCAEnergy::held() const
{
  return held(mca::flat(atom->v), mca::flat(atom->omega));
}

void FixMCAEnergy::begin_run(const Held &own_held)
{
  const double has = own_held.kinetic + own_held.elastic;
  if (begun)
    account.add(Account::Changed, has - last);
  else
    start = has;
  begun = true;
  restart_global = 1;
  fresh = false;
  last = has;
  led = own_held.led;
  std::copy_n(account.sums(), FLOWS, booked);
}

void FixMCAEnergy::close(const Held &own)
{
  last = own.kinetic + own.elastic;
  std::copy_n(account.sums(), FLOWS, booked);
}

/* LAMMPS has moved the automata, but neither the ghosts nor the pair list yet */

void FixMCAEnergy::post_integrate()
{
  if (fresh) {
    // integrators have added half a step's change to the velocities of set-up, whatever set them
    const double half = 0.5 * update->dt * force->ftm2v;
    for (int i = 0; i < atom->nlocal; i++)
      for (int m = 0; m < 3 && pair->is_integrated(i); m++) {
        const int type = atom->type[i];
        velocities[3 * i + m] = atom->v[i][m] - half / pair->mass(type) * atom->f[i][m];
        spins[3 * i + m] = atom->omega[i][m] - half / pair->inertia(type) * atom->torque[i][m];
      }
    keep(rowsOf(places));
    begin_run(held(rowsOf(velocities), rowsOf(spins)));
  }
  account.bookFirstHalf(pair->step(), mca::flat(atom->x), mca::flat(atom->omega), update->dt,
                        edgesOf(domain));
  before_faces = domain->deform_vremap ? translation(false) : 0.0;
}

double FixMCAEnergy::translation(bool faces) const
{
  double sum = 0.0;
  for (int i = 0; i < atom->nlocal; i++) {
    const mca::Vector v =
        faces ? pair->step().velocity(i) : mca::Vector{atom->v[i][0], atom->v[i][1], atom->v[i][2]};
    sum += 0.5 * pair->mass(atom->type[i]) * mca::dot(v, v);
  }
  return sum * force->mvv2e;
}

bigint FixMCAEnergy::automata() const
{
  bigint own = atom->nlocal, all;
  MPI_Allreduce(&own, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  return all;
}

/* Where automata came or went with the list of this step, what is missing in it is theirs: their
   own energy and that of their contacts. */

void FixMCAEnergy::end_of_step()
{
  keep(mca::flat(atom->x));
  account.bookSecondHalf(pair->step(), update->dt);
  if (domain->deform_vremap)
    account.add(Account::Box, translation(true) - before_faces);
  const Held own = held();
  account.add(Account::Work, own.led - led);
  led = own.led;
  if (neighbor->ago == 0) {
    ids.assign(atom->tag, atom->tag + atom->nlocal);
    const bigint before = count;
    count = automata();
    if (count != before) {
      double missing = own.kinetic + own.elastic - last;
      for (int m = 0; m < FLOWS; m++)
        missing += Account::leaves(m) * (account.sums()[m] - booked[m]);
      account.add(Account::Changed, missing);
    }
  }
  close(own);
  static constexpr int from_check_to_check = 100; // steps
  if (update->ntimestep % from_check_to_check == 0)
    warn();
}

void FixMCAEnergy::post_run()
{
  if (fresh) {
    keep(mca::flat(atom->x));
    begin_run(held());
  } else {
    close(held());
  }
  warn();
}

FixMCAEnergy::Balance FixMCAEnergy::balance()
{
  if (!std::equal(ids.begin(), ids.end(), atom->tag, atom->tag + atom->nlocal))
    error->one(FLERR,
               "Compute mca/energy: no set-up has seen the present list of pairs, as mca_links "
               "makes it: give run 0 before output");
  if (fresh) // forces of fixes that were defined later have come
    keep(mca::flat(atom->x));
  const Held now = held();
  double own[3 + FLOWS] = {now.kinetic, now.elastic, start}, all[3 + FLOWS];
  std::copy_n(account.sums(), FLOWS, own + 3);
  if (fresh) { // as begin_run() will book it
    const double has = now.kinetic + now.elastic;
    own[2] = begun ? start : has;
    own[3 + Account::Changed] += begun ? has - last : 0.0;
  }
  MPI_Allreduce(own, all, 3 + FLOWS, MPI_DOUBLE, MPI_SUM, world);
  Balance sum = {all[0], all[1], {}, all[2], all[0] + all[1] - all[2]};
  for (int m = 0; m < FLOWS; m++) {
    sum.flow[m] = all[3 + m];
    sum.error += Account::leaves(m) * all[3 + m];
  }
  return sum;
}

/* ----------------------------------------------------------------------
   What contacts that touch or part within a step find too much or too little is some 1e-4 of what
   passes through the sample. What is beyond is no physics: a step that is too long, a law that
   makes energy.
------------------------------------------------------------------------- */

void FixMCAEnergy::warn()
{
  static constexpr double share = 1e-3;      // of what the sample had and got
  static constexpr double round_off = 1e-15; // of the automata's volume times Young's modulus
  static constexpr std::pair<Account::Channel, const char *> dissipated[] = {
      {Account::Plastic, "plastic flow"},
      {Account::Fracture, "breaking"},
      {Account::Viscous, "viscosity"},
      {Account::Friction, "friction"}};
  if (told)
    return;
  const Balance b = balance();
  double passed = std::abs(b.start);
  for (int m = 0; m < FLOWS; m++)
    passed += Account::comesIn(m) ? std::abs(b.flow[m]) : 0.0;
  double stiffness = 0.0;
  for (int i = 0; i < atom->nlocal; i++)
    stiffness += pair->material(atom->type[i]).youngsModulus / force->nktv2p *
                 pair->cell(atom->type[i]).cellVolume();
  MPI_Allreduce(MPI_IN_PLACE, &stiffness, 1, MPI_DOUBLE, MPI_SUM, world);
  passed = std::max(passed, round_off / share * stiffness); // a sample at rest
  std::string what;
  for (const auto &[channel, name] : dissipated) {
    highest[channel] = std::max(highest[channel], b.flow[channel]);
    if (const double back = highest[channel] - b.flow[channel]; back > share * passed)
      what = fmt::format("{} has given back {:.6g}", name, back);
  }
  if (std::abs(b.flow[Account::Touching]) > share * passed)
    what = fmt::format("contacts that touch or part within a step have lost {:.6g}",
                       b.flow[Account::Touching]);
  if (std::abs(b.error) > share * passed)
    what = fmt::format("the error is {:.6g}", b.error);
  if (what.empty())
    return;
  told = true;
  if (comm->me == 0)
    error->warning(
        FLERR,
        "Compute mca/energy: in step {} {}, above {:g} of the energy that the sample had "
        "and got, {:.6g}: is the timestep too long, does a fix set velocities, do the "
        "laws make energy?",
        update->ntimestep, what, share, passed);
}

/* ---------------------------------------------------------------------- */

// start, end of the last run and sums, of all ranks
static constexpr int written = 2 + FixMCAEnergy::FLOWS;

void FixMCAEnergy::write_restart(FILE *fp)
{
  std::vector<double> own = {start, last}, all(written);
  own.insert(own.end(), booked, booked + FLOWS);
  MPI_Allreduce(own.data(), all.data(), written, MPI_DOUBLE, MPI_SUM, world);
  if (comm->me == 0)
    mca::writeFixBlock(fp, mca::exactText(all));
}

/* each rank goes on from its own part */

void FixMCAEnergy::restart(char *buf)
{
  const char *const what = "compute mca/energy";
  const std::string text = mca::fixBlockText(lmp, buf, what);
  std::vector<double> values =
      mca::readOrStop(lmp, [&] { return mca::numbersIn(text, written, what); });
  if (comm->me != 0)
    values.assign(written, 0.0);
  start = values[0];
  last = values[1];
  for (int m = 0; m < FLOWS; m++)
    account.setSum(static_cast<Account::Channel>(m), values[2 + m]);
  begun = true;
  restart_global = 1;
}

double FixMCAEnergy::memory_usage()
{
  return account.bytes() + static_cast<double>(ids.capacity() * sizeof(tagint)) +
         static_cast<double>((places.capacity() + velocities.capacity() + spins.capacity() +
                              forces.capacity() + torques.capacity()) *
                             sizeof(double));
}
