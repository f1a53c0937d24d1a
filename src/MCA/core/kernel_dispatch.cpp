// SPDX-License-Identifier: GPL-2.0-or-later
#include "kernel.h"

namespace mca {

std::vector<const Kernel *> supportedKernels(int dimension)
{
  const bool plane = dimension == 2;
  std::vector<const Kernel *> all = {plane ? &baseline::plane : &baseline::space};
#ifdef MCA_X86_KERNELS
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    all.push_back(plane ? &avx2::plane : &avx2::space);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw"))
    all.push_back(plane ? &avx512::plane : &avx512::space);
#endif
  return all;
}

const Kernel &bestKernel(int dimension)
{
  return *supportedKernels(dimension).back();
}

} // namespace mca
