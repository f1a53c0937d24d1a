// SPDX-License-Identifier: GPL-2.0-or-later
/// \file sample_space.h
/// Samples in space that several tests share, and the step run on them.
#ifndef SAMPLE_SPACE_H
#define SAMPLE_SPACE_H

#include "reference_space.h"
#include "step_arrays.h"

/// A block of n x n x n primitive cells of the packing, every pair closer than `reach` diameters a
/// contact with the given kind of link; open, or periodic with images of all automata around it.
reference::space::Sample block(const mca::Packing &, const mca::Material &, int n, double kind,
                               bool periodic, double reach = 1.1);

/// The production step on a Sample, with its own pair list that lives on from step to step.
class SpaceRun {
 public:
  /// \param next  begins with the next states of the sample's contacts, not the present ones
  SpaceRun(const mca::Kernel &, const reference::space::Sample &, bool next);

  /// One evaluation of the laws; results and both states go back into the sample.
  void step(reference::space::Sample &, double dt);

 private:
  mca::Step evaluation_;
  StepArrays arrays_;
};

/// One evaluation of the laws by a kernel from the sample's present (dt = 0) or next states.
void kernelStep(const mca::Kernel &, reference::space::Sample &, double dt);

#endif
