// SPDX-License-Identifier: GPL-2.0-or-later
/* ----------------------------------------------------------------------
   MCA-WHEELRAIL, a package for LAMMPS. GPL-2.0-or-later.
   compute mca/atom: state of automata; see doc/compute_mca_atom.md
------------------------------------------------------------------------- */

#ifndef LMP_COMPUTE_MCA_ATOM_H
#define LMP_COMPUTE_MCA_ATOM_H

#include "compute.h"

#include "core/automaton_states.h"
#include "output_columns.h"

#include <functional>
#include <string>
#include <vector>

namespace LAMMPS_NS {

class PairMCA;

class ComputeMCAAtom : public Compute {
 public:
  ComputeMCAAtom(class LAMMPS *, int, char **);
  void init() override;
  void compute_peratom() override;
  double memory_usage() override;

 private:
  // What can be asked for: the states of automata that are shown, and what follows from the step.
  struct Attribute {
    std::string name;
    std::function<double(int)> value; // of an owned automaton
    const mca::AutomatonState *state; // nullptr: not a state
    bool counted;                     // needs count_links()
  };
  std::vector<Attribute> known;
  OutputColumns columns;
  PairMCA *pair;
  std::vector<double> counts; // of owned and ghost automata: links, welds, original links

  std::vector<Attribute> attributes();
  bool asks_for(const std::function<bool(const Attribute &)> &) const;
  void count_links();
  double damage(int i) const;
};

} // namespace LAMMPS_NS

#endif
