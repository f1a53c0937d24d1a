#include "kernel.h"

namespace mca {

std::vector<const Kernel *> supportedKernels()
{
  std::vector<const Kernel *> all = {&baseline::kernel};
#ifdef MCA_X86_KERNELS
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    all.push_back(&avx2::kernel);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw"))
    all.push_back(&avx512::kernel);
#endif
  return all;
}

const Kernel &bestKernel()
{
  static const Kernel &best = *supportedKernels().back();
  return best;
}

} // namespace mca
