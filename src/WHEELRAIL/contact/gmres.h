// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CONTACT_GMRES_H
#define WHEELRAIL_CONTACT_GMRES_H

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace wheelrail {

/// How a solution was reached. Whether it is good enough is for the caller to judge: nothing here
/// throws or prints.
struct GmresReport {
  int products = 0;       ///< products with the operator, the one for each restart included
  double residual = 0.0;  ///< |b - A x| / scale, of the product computed last: the true one
  bool converged = false; ///< residual <= tolerance
};

/// What one Krylov space gives.
struct GmresCycle {
  Eigen::VectorXd step;  ///< to add to x, before the preconditioner; empty: no direction is left
  double residual = 0.0; ///< |b - A x| after it, as the recurrence has it
  int products = 0;
};

/// One cycle of GMRES (Saad, Schultz 1986), preconditioned on the right, from the residual r of the
/// x that it starts from.
/// \param apply, precondition as `gmres` takes them
/// \param goal length of the residual at which it ends, in the unit of r
/// \param vectors of the space, at most; at least 1
/// \param maxProducts at most
template<class Apply, class Precondition>
GmresCycle gmresCycle(const Apply &apply, const Precondition &precondition,
                      const Eigen::VectorXd &r, double goal, int vectors, int maxProducts)
{
  using Eigen::VectorXd;
  GmresCycle cycle;
  const double beta = r.norm();
  std::vector<VectorXd> basis{r / beta};
  // Upper Hessenberg matrix, turned into a triangle by Givens rotations column by column; |g[k]|
  // is the residual after k columns.
  Eigen::MatrixXd h = Eigen::MatrixXd::Zero(vectors + 1, vectors);
  VectorXd cosines(vectors), sines(vectors), g = VectorXd::Zero(vectors + 1);
  g[0] = beta;
  int k = 0;
  while (k < vectors && std::abs(g[k]) > goal && cycle.products < maxProducts) {
    // Arnoldi: the next direction, made orthogonal to those before.
    VectorXd w = apply(precondition(basis[k]));
    ++cycle.products;
    for (int j = 0; j <= k; ++j) { // modified Gram-Schmidt
      h(j, k) = w.dot(basis[j]);
      w -= h(j, k) * basis[j];
    }
    h(k + 1, k) = w.norm();
    const double below = h(k + 1, k);
    for (int j = 0; j < k; ++j) { // the rotations so far
      const double above = h(j, k);
      h(j, k) = cosines[j] * above + sines[j] * h(j + 1, k);
      h(j + 1, k) = -sines[j] * above + cosines[j] * h(j + 1, k);
    }
    // One more rotation takes the element below the diagonal away. A column of zeros has none:
    // the operator is singular on this space.
    const double length = std::hypot(h(k, k), below);
    if (!(length > 0.0))
      break;
    cosines[k] = h(k, k) / length;
    sines[k] = below / length;
    h(k, k) = length;
    g[k + 1] = -sines[k] * g[k];
    g[k] *= cosines[k];
    ++k;
    if (!(below > 0.0))
      break; // the solution lies in the space built so far
    if (k < vectors)
      basis.emplace_back(w / below);
  }
  cycle.residual = std::abs(g[k]);
  if (k == 0)
    return cycle;
  // Least-squares solution in the basis.
  const VectorXd y = h.topLeftCorner(k, k).template triangularView<Eigen::Upper>().solve(g.head(k));
  cycle.step = y[0] * basis[0];
  for (int j = 1; j < k; ++j)
    cycle.step += y[j] * basis[j];
  return cycle;
}

/// Restarted GMRES (Saad, Schultz 1986) with a preconditioner on the right, so that the residual is
/// the true one. Solves A x = b for any A that is not singular on the space that b lies in; rows
/// and columns of cells that take no part may be zero where b is.
///
/// Nothing here knows a unit: b and A x have one unit, x and the preconditioner's results another.
/// \param apply v -> A v, a function of Eigen::VectorXd that returns one of the same size
/// \param precondition v -> about A^-1 v, linear, the same in every call
/// \param b right-hand side
/// \param x start on entry, of the size of b (zero does); solution on return
/// \param scale > 0, in the unit of b: what |b - A x| is measured against, so that the tolerance is
///        always relative
/// \param tolerance of |b - A x| / scale
/// \param restart vectors that are kept before the method starts anew; each has the size of b
/// \param maxProducts limit of the products in all
/// \return converged or not; never throws. A residual that is not finite ends it
///
/// *Scale.* Choose `scale` of the order of |b|: a tolerance that is absolute would end the
/// iteration early and in silence for a right-hand side near 1e-8.
///
/// *Cost.* One product, one preconditioning and k inner products in the step k after a restart;
/// memory is restart + 1 vectors of the size of b.
///
/// *Preconditioner.* One that is only roughly the inverse does no harm to the result: the residual
/// is that of the system without it.
///
/// *End.* Early where the space of products is exhausted, which gives the exact solution, or where
/// no direction is left (report.converged is then false).
template<class Apply, class Precondition>
GmresReport gmres(const Apply &apply, const Precondition &precondition, const Eigen::VectorXd &b,
                  Eigen::VectorXd &x, double scale, double tolerance, int restart = 60,
                  int maxProducts = 600)
{
  GmresReport report;
  while (true) {
    // The true residual, computed anew at each restart: rounding in the recurrence does not add
    // up.
    const Eigen::VectorXd r = b - apply(x);
    ++report.products;
    report.residual = r.norm() / scale;
    report.converged = report.residual <= tolerance;
    if (report.converged || report.products >= maxProducts || !std::isfinite(report.residual))
      return report;
    const GmresCycle cycle = gmresCycle(apply, precondition, r, tolerance * scale, restart,
                                        maxProducts - report.products);
    report.products += cycle.products;
    if (cycle.step.size() == 0)
      return report;
    x += precondition(cycle.step);
  }
}

} // namespace wheelrail
#endif
