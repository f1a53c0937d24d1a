// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/bounded_mu.h"

#include <cmath>

namespace wheelrail {

double boundedMu(const LawParameters &x, const Kappas &kappas, double third,
                 LawParameters *gradient)
{
  const double g1 = 1.0 / (1.0 + x[B] * kappas.kappa1);
  const double g2 = 1.0 / (1.0 + x[C] * kappas.kappa2);
  const double logarithm = std::log(third);
  const double power = x[N] == 0.0 ? 1.0 : std::exp(x[N] * logarithm);
  const double base = power * (x[Mu0] + x[Mu1] * kappas.kappa1 * g1 + x[Mu2] * g2);
  if (gradient) {
    (*gradient)[Mu0] = power;
    (*gradient)[Mu1] = power * kappas.kappa1 * g1;
    (*gradient)[Mu2] = power * g2;
    (*gradient)[B] = -power * x[Mu1] * (kappas.kappa1 * g1) * (kappas.kappa1 * g1);
    (*gradient)[C] = -power * x[Mu2] * kappas.kappa2 * g2 * g2;
    (*gradient)[N] = base * logarithm;
    (*gradient)[S] = (*gradient)[Q] = (*gradient)[S1] = (*gradient)[D] = 0.0;
  }
  if (x[S] == 0.0 || base <= 0.0 || kappas.kappa2 == 0.0)
    return base;
  const double rate = kappas.kappa1 / (1.0 + x[D] * kappas.kappa1);
  const double limit = x[S] + x[S1] * rate;
  // In logarithms, where nothing overflows: with d = ln B - ln(S sigma_0/p)
  //   ln mu = ln B - ln(1 + e^(q d))/q,   d ln mu/d ln B = 1/(1 + e^(q d)).
  const double d = std::log(base * kappas.kappa2 / (kappas.kappa3 * limit));
  const double t = x[Q] * d;
  const double softplus = t > 0.0 ? t + std::log1p(std::exp(-t)) : std::log1p(std::exp(t));
  const double mu = base * std::exp(-softplus / x[Q]);
  if (gradient) {
    const double limited = 1.0 / (1.0 + std::exp(-t)); // 0: B alone, 1: the limit alone
    *gradient *= (1.0 - limited) * mu / base;
    (*gradient)[S] = mu * limited / limit;
    (*gradient)[S1] = (*gradient)[S] * rate;
    (*gradient)[D] = -(*gradient)[S1] * x[S1] * rate;
    (*gradient)[Q] = mu * (softplus / x[Q] - d * limited) / x[Q];
  }
  return mu;
}

} // namespace wheelrail
