// SPDX-License-Identifier: GPL-2.0-or-later
/// \file reference_laws.h
/// Laws of one number each, the same in the plane and in space: written from the equations, not
/// from the headers of src/MCA/laws, for the slow references.
#ifndef REFERENCE_LAWS_H
#define REFERENCE_LAWS_H

#include "laws/law_set.h"

#include <Eigen/Dense>

#include <functional>
#include <map>
#include <string>

namespace reference {

double shearModulus(const mca::Material &);
double bulkModulus(const mca::Material &);

/// D of the force law.
double meanWeight(const mca::LawSet &, const mca::Material &);

/// Fig. 5 against plastic strain.
double yieldStress(const mca::Material &, double kappa);

/// Plastic work per volume, the area below the yield curve.
double plasticWork(const mca::Material &, double kappa);

/// A contact as a criterion of fracture sees it, after the returns. In space shears are lengths.
struct LinkView {
  const mca::LawSet &laws;
  const mca::Material &a, &b;
  int dimension;
  double eps = 0, gammaTotal = 0;                   ///< total strains
  double e = 0, gamma = 0;                          ///< elastic strains
  double sigma = 0, tau = 0;                        ///< stresses
  double meanA = 0, meanB = 0;                      ///< mean stresses of both automata
  Eigen::Matrix3d stress = Eigen::Matrix3d::Zero(); ///< local stress tensor, in any frame
};

/// The criteria of bulk links by their words. A test of a new one adds its own.
std::map<std::string, std::function<bool(const LinkView &)>> &criteria();

/// Whether it breaks as a bulk link: by the criterion of its laws, or it has collapsed.
bool bulkBreaks(const LinkView &);

/// Whether it is strained so that it breaks as a healed link, by keyword healed_strain.
bool healedBreaks(const LinkView &);

/// The kind of a contact after a step in which it has these stresses.
/// \param work  plastic work per volume while pressed together
/// \param room  stress against lack of room, which presses, too
double nextKind(const mca::LawSet &, const mca::Material &, const mca::Material &, double kind,
                double sigma, double tau, bool bulkBreaks, bool healedBreaks, double work,
                double room);

/// plasticity isochoric acts.
bool keepsVolume(const mca::LawSet &);

/// An unlinked contact is pressed: its automata overlap by more than round-off makes of r = d.
bool pressed(double e);

/// Plastic strain of an automaton by the work of its flow, for 1 - M = 1.
/// \param squares  squares of the stresses that flow, with the packing's weight
double strainOfWork(double squares, double intensity, double shearModulus);

/// Weight of a contact in the flow of its automata.
double flowWeight(const mca::LawSet &, const mca::Material &, const mca::Material &, double kind,
                  double e);

/// The most of 1 - M.
double mostReturned(const mca::LawSet &, const mca::Material &, int dimension);

/// Normal stress of a linked contact that lengthens as its squared plastic shear grows. Of the view
/// laws, materials and dimension are read.
/// \param released  elastic energy of the shear, per volume, that flow sets free
double stretched(const LinkView &, double sigma, double longer, double released);

/// Normal stress of an unlinked contact that flows, within its limits.
double flownUnlinked(const LinkView &, double sigma, double trial, double plastic);

/// Normal strain of a contact at r/d, and the area that its normal stress acts on.
double normalStrain(const mca::LawSet &, double ratio);
double actingArea(const mca::LawSet &, double area, double ratio);

/// What a neighbour at r/d takes of an automaton's room, the pressure against its lack, and the
/// stress that two of these make.
double roomTaken(double ratio);
double roomPressure(const mca::LawSet &, const mca::Material &, double taken, int dimension,
                    int coordination);
double roomStress(double ratio, double pressureA, double pressureB);

/// Stress of an unlinked contact that touches.
double unlinkedStress(const mca::LawSet &, double elastic, double viscous);

/// What is left of strains that broken links left.
double keptNext(const mca::LawSet &, double kept, double sum);

/// The rule for worn contacts, in the place of what nextKind() says.
/// \param far  beyond the breaking distance of the tougher material
double wornKind(const mca::LawSet &, double kind, double next, bool far);

} // namespace reference

#endif
