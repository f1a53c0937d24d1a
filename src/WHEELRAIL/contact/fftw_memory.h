// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CONTACT_FFTW_MEMORY_H
#define WHEELRAIL_CONTACT_FFTW_MEMORY_H

#include <cstddef>
#include <fftw3.h>
#include <memory>
#include <mutex>
#include <new>
#include <type_traits>

/// Arrays and plans of FFTW that end with their owner.
namespace wheelrail {

/// FFTW's planner is the one part of it that is not thread-safe: hold this while plans are made or
/// destroyed. Transforms themselves need no lock.
inline std::mutex &fftwPlannerMutex()
{
  static std::mutex mutex;
  return mutex;
}

struct FftwFree {
  void operator()(void *array) const { fftw_free(array); }
};
/// n real or complex numbers of FFTW, aligned as its transforms like it; not set.
template<class Number>
using FftwArray = std::unique_ptr<Number[], FftwFree>;

/// \throws std::bad_alloc
template<class Number>
FftwArray<Number> fftwArray(std::size_t n)
{
  auto *array = static_cast<Number *>(fftw_malloc(n * sizeof(Number)));
  if (!array)
    throw std::bad_alloc();
  return FftwArray<Number>(array);
}

/// FFTW in one precision: its types, and the calls that are used in more than one.
template<class Real>
struct Fftw;

template<>
struct Fftw<double> {
  using Complex = fftw_complex;
  using Plan = fftw_plan;
  static constexpr auto destroy = fftw_destroy_plan;
  static constexpr auto plan = fftw_plan_dft_1d;
  static constexpr auto executeOn = fftw_execute_dft;
};

template<>
struct Fftw<float> {
  using Complex = fftwf_complex;
  using Plan = fftwf_plan;
  static constexpr auto destroy = fftwf_destroy_plan;
  static constexpr auto plan = fftwf_plan_dft_1d;
  static constexpr auto executeOn = fftwf_execute_dft;
};

template<class Real>
struct FftwDestroy {
  void operator()(typename Fftw<Real>::Plan plan) const
  {
    const std::lock_guard<std::mutex> lock(fftwPlannerMutex());
    Fftw<Real>::destroy(plan);
  }
};
template<class Real>
using FftwPlanOf =
    std::unique_ptr<std::remove_pointer_t<typename Fftw<Real>::Plan>, FftwDestroy<Real>>;
using FftwPlan = FftwPlanOf<double>;

/// A plan made by `make`, a call of FFTW's planner.
///
/// FFTW ends the program where memory fails it within a plan. What a plan of `length` takes is
/// therefore asked for before.
/// \param length of the transforms
/// \throws std::bad_alloc
template<class Real = double, class Make>
FftwPlanOf<Real> fftwPlan(int length, const Make &make)
{
  constexpr std::size_t least = 1 << 20; // bytes; trees of plans, and code that is loaded
  constexpr std::size_t each = 64;       // bytes; twiddle factors and buffers, with room
  fftwArray<char>(least + each * static_cast<std::size_t>(length));
  const std::lock_guard<std::mutex> lock(fftwPlannerMutex());
  FftwPlanOf<Real> plan(make());
  if (!plan)
    throw std::bad_alloc();
  return plan;
}

} // namespace wheelrail
#endif
