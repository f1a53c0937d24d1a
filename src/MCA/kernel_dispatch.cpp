#include "kernel.h"

namespace mca {

std::vector<const Kernel *> supportedKernels(int /*dimension: only the plane so far*/)
{
  std::vector<const Kernel *> all = {&baseline::plane};
#ifdef MCA_X86_KERNELS
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    all.push_back(&avx2::plane);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw"))
    all.push_back(&avx512::plane);
#endif
  return all;
}

const Kernel &bestKernel(int dimension)
{
  return *supportedKernels(dimension).back();
}

} // namespace mca
