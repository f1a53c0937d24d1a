// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_SLIP_MEMORY_H
#define WHEELRAIL_CREEP_SLIP_MEMORY_H

#include "contact/half_space.h"
#include "law/friction_law.h"

namespace wheelrail {

/// Friction that falls with the slip of each place, with a memory: mu = r mu(p, 0, Theta), where r
/// is 1 as material enters and follows mu(p, w, Theta)/mu(p, 0, Theta) over the way that it slides,
///   dr = (mu(p, w, Theta)/mu(p, 0, Theta) - r) d(slid)/length,  w = V |slip|
/// (E. A. H. Vollebregt, H. M. Schuttelaars, J. Sound Vib. 331 (2012) 2141). Without a memory mu
/// would jump where slip begins, and a creep curve that falls would have several solutions. The
/// pressure and the temperature act at once.
class SlipMemory {
 public:
  /// \param grid   material enters each of its rows at the largest x; m
  /// \param length way of sliding, m, > 0
  SlipMemory(const CellGrid &grid, double length) : grid_(grid), length_(length) {}

  /// r in the middle of all cells in steady rolling: material that enters the grid has 1, and keeps
  /// its r between the spots of a rough contact.
  /// \param speed  v0, m/s
  /// \param slip   sliding distance / rolling distance of each cell; its sign does not count
  Eigen::VectorXd steady(const FrictionLaw &law, const Eigen::VectorXd &pressure,
                         const Eigen::VectorXd &temperature, double speed,
                         const Eigen::VectorXd &slip) const;
  /// r of the material in the cells at the end of a step of one cell, in which the next one finds
  /// it: half a cell late.
  /// \param before at its start: what of it comes in has 1, what is out of contact keeps its r
  Eigen::VectorXd after(const Eigen::VectorXd &before, const FrictionLaw &law,
                        const Eigen::VectorXd &pressure, const Eigen::VectorXd &temperature,
                        double speed, const Eigen::VectorXd &slip) const;

  /// mu of all cells, with r as above.
  static Eigen::VectorXd mu(const FrictionLaw &law, const Eigen::VectorXd &pressure,
                            const Eigen::VectorXd &temperature, const Eigen::VectorXd &ratio);

 private:
  /// mu(p, w, Theta)/mu(p, 0, Theta) of each cell, 1 where nothing slides.
  Eigen::VectorXd targets(const FrictionLaw &law, const Eigen::VectorXd &pressure,
                          const Eigen::VectorXd &temperature, double speed,
                          const Eigen::VectorXd &slip) const;
  /// What of a difference a cell's way of sliding leaves.
  double left(const Eigen::VectorXd &slip, int cell) const;

  CellGrid grid_;
  double length_;
};

} // namespace wheelrail
#endif
