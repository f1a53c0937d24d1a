// SPDX-License-Identifier: GPL-2.0-or-later
#include "creep/sweep.h"

#include "base/errors.h"

#include <omp.h>

namespace wheelrail {

int SweepOptions::threadCount() const
{
  return threads > 0 ? threads : omp_get_max_threads();
}

void FirstError::take()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!error_)
    error_ = std::current_exception();
  failed_ = true;
}

void FirstError::rethrow() const
{
  if (error_)
    std::rethrow_exception(error_);
}

std::vector<ContactSetup> prepareContacts(const LineContactSpecification &contact,
                                          const SurfaceSpecification &surface, double pressureLimit,
                                          bool travels, const SweepOptions &options)
{
  std::vector<ContactSetup> contacts(surface.profiles());
  FirstError error;
#pragma omp parallel for schedule(dynamic) num_threads(options.threadCount())
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    if (error.any() || options.stopped())
      continue;
    try {
      contacts[k] = prepareContact(contact, surface, k, pressureLimit, travels);
    } catch (...) {
      error.take();
    }
  }
  error.rethrow();
  if (options.stopped())
    throw Error(ExitCode::Interrupted,
                "interrupted before the first point; the same command goes on");
  return contacts;
}

} // namespace wheelrail
