// SPDX-License-Identifier: GPL-2.0-or-later
#include "local_stress.h"

namespace mca {

void showLocal(const RowView &rows, bool keepsVolume, int n, const int *type,
               const AutomatonLaw *laws, const double *kappa, const double *kappaNext,
               double *local)
{
  const RowLayout::Local &at = rows.layout->local;
  for (int i = 0; i < n; i++) {
    const AutomatonLaw &law = laws[type[i]];
    const StressTensor s = rows.averaged(i, law);
    const Answer answer = rows.answer(i);
    const double mean = !rows.isPlane() ? (s.xx + s.yy + s.zz) / 3.0
                        : keepsVolume   ? 0.5 * (s.xx + s.yy)
                                        : answer.mean;
    const double factor = answer.factor;
    double *row = local + at.length * i, *tensor = row + at.tensor;
    tensor[0] = mean + factor * (s.xx - mean);
    tensor[1] = mean + factor * (s.yy - mean);
    tensor[2] = factor * s.xy;
    if (!rows.isPlane()) {
      tensor[3] = mean + factor * (s.zz - mean);
      tensor[4] = factor * s.xz;
      tensor[5] = factor * s.yz;
    }
    row[at.work] =
        kappaNext[i] == kappa[i] ? 0.0 : law.curve.work(kappaNext[i]) - law.curve.work(kappa[i]);
  }
}

} // namespace mca
