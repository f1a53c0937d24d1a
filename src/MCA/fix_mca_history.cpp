#include "fix_mca_history.h"

#include "comm.h"
#include "pair_mca.h"
#include "update.h"

using namespace LAMMPS_NS;

FixMCAHistory::FixMCAHistory(LAMMPS *host, int narg, char **arg)
    : FixNeighHistory(host, narg, arg), mca(nullptr)
{
  // the list holds every pair within the cutoff, touching or not, without LAMMPS's contact bit
  use_bit_flag = 0;
}

void FixMCAHistory::attach(PairMCA *owner)
{
  mca = owner;
  pair = owner;
}

/* before atoms migrate and the list is rebuilt: what the step just done leads to */

void FixMCAHistory::pre_exchange()
{
  mca->commit();
  mca->push_history(true);
  FixNeighHistory::pre_exchange();
}

void FixMCAHistory::post_neighbor()
{
  FixNeighHistory::post_neighbor();
  mca->pull_history();
}

/* the next run's set-up, or that of a restart, recomputes the forces of this step, hence needs the
   state that made them */

void FixMCAHistory::store_present()
{
  mca->push_history(false);
  FixNeighHistory::pre_exchange();
}

void FixMCAHistory::post_run()
{
  mca->keep_lag();
  store_present();
}

void FixMCAHistory::write_restart(FILE *fp)
{
  // between runs post_run() has brought the atoms up to date and the list may be stale
  if (update->whichflag)
    post_run();
  if (comm->me == 0) {
    int size = 0;
    fwrite(&size, sizeof(int), 1, fp);
  }
}
