// SPDX-License-Identifier: GPL-2.0-or-later
/// \file sample.h
/// Materials and samples that several tests share, and the step run on a reference::Sample.
#ifndef SAMPLE_H
#define SAMPLE_H

#include "reference_plane.h"
#include "step_arrays.h"

#include <iosfwd>
#include <string>

/// Table 1 of Bucher et al. (2006) with sigma_0 = 92 MPa, in LAMMPS's units nano.
mca::Material steel();

/// D = 3 nu/(1 + nu) [-] of the solid, the weight of the mean stress in Hooke's law along a
/// contact.
double meanStressWeight(const mca::Material &);

/// Steel as the text of a potential file.
std::string steelText();

/// Each criterion of bulk links as keywords and values: fracture with its word, and where it has a
/// number of its own, that number as 3.
std::vector<std::vector<std::string>> fractureWords();

/// A hexagonal block of `columns` x `rows` automata of the first material, rows along x, every
/// pair closer than `reach` diameters a contact with the given kind of link (0: none).
reference::Sample hexagonalBlock(const mca::Material &, int columns, int rows, double kind,
                                 double reach = 1.1);

/// A block that is periodic in both directions (rows must be even).
reference::Sample periodicBlock(const mca::Material &, int columns, int rows, double kind);

/// The production step on a reference::Sample, with its own pair list that lives on from step to
/// step.
class KernelRun {
 public:
  /// \param next  begins with the next states of the sample's contacts, not the present ones
  KernelRun(const mca::Kernel &, const reference::Sample &, bool next);

  /// One evaluation of the laws; results and both states go back into the sample.
  void step(reference::Sample &, double dt);

 private:
  mca::Step evaluation_;
  StepArrays arrays_;
};

/// One evaluation of the laws by a kernel from the sample's present (dt = 0) or next states.
void kernelStep(const mca::Kernel &, reference::Sample &, double dt);

/// Sum of the automata's elastic energies after a step.
double totalEnergy(const reference::Sample &);

/// Name of a supported kernel, for parameterised tests.
std::string kernelName(const mca::Kernel *);

/// GoogleTest prints parameters by these: names, which are the same in every run, not addresses.
/// Half of the bulk links are healed ones, in the plane or in space.
template<class AnySample>
void healEverySecond(AnySample &s)
{
  int number = 0;
  for (auto &c : s.contacts)
    for (auto *state : {&c.now, &c.next})
      if (state->kind == mca::link::bulk && number++ % 2 == 0)
        state->kind = mca::link::healed;
}

namespace mca {
void PrintTo(const Kernel *, std::ostream *);
void PrintTo(const Packing &, std::ostream *);
} // namespace mca

#endif
