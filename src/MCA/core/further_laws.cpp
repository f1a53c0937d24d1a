// SPDX-License-Identifier: GPL-2.0-or-later
#include "further_laws.h"

namespace mca {

static StressTensor averagedStress(const RowLayout &rows, const AutomatonLaw &law,
                                   const double *stress, const double *response)
{
  const double *t = stress + rows.stress.tensor;
  return rows.dimension == 2 ? automatonStress(t[0], t[1], t[2], response[rows.response.mean])
                             : weighted(t, law.weight);
}

void showLocal(const RowLayout &rows, bool keepsVolume, int n, const int *type,
               const AutomatonLaw *laws, const double *stresses, const double *response,
               const double *kappa, const double *kappaNext, double *local)
{
  for (int i = 0; i < n; i++) {
    const AutomatonLaw &law = laws[type[i]];
    const double *answer = response + rows.response.length * i;
    const StressTensor s = averagedStress(rows, law, stresses + rows.stress.length * i, answer);
    const bool plane = rows.dimension == 2;
    const double mean = !plane        ? (s.xx + s.yy + s.zz) / 3.0
                        : keepsVolume ? 0.5 * (s.xx + s.yy)
                                      : answer[rows.response.mean];
    const double factor = answer[rows.response.factor];
    double *row = local + rows.local.length * i, *tensor = row + rows.local.tensor;
    tensor[0] = mean + factor * (s.xx - mean);
    tensor[1] = mean + factor * (s.yy - mean);
    tensor[2] = factor * s.xy;
    if (!plane) {
      tensor[3] = mean + factor * (s.zz - mean);
      tensor[4] = factor * s.xz;
      tensor[5] = factor * s.yz;
    }
    row[rows.local.work] = law.curve.work(kappaNext[i]) - law.curve.work(kappa[i]);
  }
}

} // namespace mca
