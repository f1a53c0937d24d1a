// SPDX-License-Identifier: GPL-2.0-or-later
// The C interface over OnlineContact: what is thrown becomes a code and a line.
#include "c/wheelrail.h"

#include "base/errors.h"
#include "base/version.h"
#include "creep/online/online_contact.h"
#include "shared/nearest_word.h"
#include "shared/output_file.h"

#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <vector>

using wheelrail::Error;
using wheelrail::ExitCode;
using wheelrail::OnlineContact;

struct wheelrail_contact { // NOLINT(readability-identifier-naming): of the header
  std::optional<OnlineContact> solver;
  std::string error;
};

namespace {

/// What a call does, with its faults told in the object.
template<class Action>
int attempt(wheelrail_contact *contact, const Action &action) noexcept
{
  if (!contact)
    return WHEELRAIL_USAGE;
  try {
    contact->error.clear();
    try {
      action();
      return WHEELRAIL_OK;
    } catch (const Error &error) {
      contact->error = error.what();
      return static_cast<int>(error.code());
    } catch (const mcawr::OutputError &error) {
      contact->error = error.what();
      return WHEELRAIL_IO;
    } catch (const std::bad_alloc &) {
      contact->error = "out of memory";
    } catch (const std::exception &error) {
      contact->error = std::string("internal error: ") + error.what();
    }
  } catch (const std::bad_alloc &) { // not even for the line
  }
  return WHEELRAIL_INTERNAL;
}

/// Does something with an object that was created; what it throws becomes a code, as in `attempt`.
template<class Action>
int with(wheelrail_contact *contact, const Action &action) noexcept
{
  return attempt(contact, [&] {
    if (!contact->solver)
      throw Error(ExitCode::Usage, "the contact was not created: its case had a fault");
    action(*contact->solver);
  });
}

template<class Read>
int create(const char *source, wheelrail_contact **contact, const Read &read) noexcept
{
  if (!contact)
    return WHEELRAIL_USAGE;
  *contact = new (std::nothrow) wheelrail_contact;
  if (!*contact)
    return WHEELRAIL_INTERNAL;
  return attempt(*contact, [&] {
    if (!source)
      throw Error(ExitCode::Usage, "the case is a null pointer");
    (*contact)->solver.emplace(read(std::string(source)));
  });
}

void requirePointer(const void *pointer, const char *name)
{
  if (!pointer)
    throw Error(ExitCode::Usage, fmt::format("{} is a null pointer", name));
}

/// The element of a list that has this name.
template<class List>
const auto &named(const List &list, const char *kind, const char *name)
{
  requirePointer(name, "name");
  const auto found = std::find_if(list.begin(), list.end(),
                                  [&](const auto &one) { return one.name == std::string(name); });
  if (found != list.end())
    return *found;
  std::vector<std::string> names;
  for (const auto &one : list)
    names.emplace_back(one.name);
  throw Error(ExitCode::Usage, fmt::format("{}: {}", name, mcawr::unknownWord(kind, name, names)));
}

} // namespace

// NOLINTBEGIN(modernize-redundant-void-arg,readability-identifier-naming): the header's names
const char *wheelrail_version(void)
{
  return wheelrail::versionText;
}

int wheelrail_create(const char *case_file, wheelrail_contact **contact)
{
  return create(case_file, contact,
                [](const std::string &path) { return wheelrail::readCase(path); });
}

int wheelrail_create_from_text(const char *case_text, wheelrail_contact **contact)
{
  return create(case_text, contact,
                [](const std::string &text) { return wheelrail::caseOfText("case", text); });
}

int wheelrail_set_creepages(wheelrail_contact *contact, double creep, double lateral, double spin)
{
  return with(contact, [&](OnlineContact &solver) { solver.setCreepages({creep, lateral, spin}); });
}

int wheelrail_set_load(wheelrail_contact *contact, double load)
{
  return with(contact, [&](OnlineContact &solver) { solver.setLoad(load); });
}

int wheelrail_set_speed(wheelrail_contact *contact, double speed)
{
  return with(contact, [&](OnlineContact &solver) { solver.setSpeed(speed); });
}

int wheelrail_step(wheelrail_contact *contact)
{
  return with(contact, [](OnlineContact &solver) { solver.step(); });
}

int wheelrail_get_forces(wheelrail_contact *contact, wheelrail_forces *forces)
{
  return with(contact, [&](const OnlineContact &solver) {
    requirePointer(forces, "forces");
    const wheelrail::PatchPoint &point = solver.point();
    *forces = {point.forceX, point.forceY, point.momentZ};
  });
}

int wheelrail_get_value(wheelrail_contact *contact, const char *name, double *value)
{
  return with(contact, [&](const OnlineContact &solver) {
    requirePointer(value, "value");
    *value = named(solver.columns(), "value", name).value.get(solver.point());
  });
}

int wheelrail_get_grid(wheelrail_contact *contact, int *nx, int *ny, double *dx, double *dy,
                       double *x, double *y)
{
  return with(contact, [&](const OnlineContact &solver) {
    const auto put = [](auto *place, auto value) {
      if (place)
        *place = value;
    };
    const wheelrail::PatchGrid &grid = solver.contact().grid;
    put(nx, grid.nx);
    put(ny, grid.ny);
    put(dx, grid.dx);
    put(dy, grid.dy);
    put(x, grid.x(0));
    put(y, grid.y(0));
  });
}

int wheelrail_get_field(wheelrail_contact *contact, const char *name, double *values, size_t count)
{
  return with(contact, [&](const OnlineContact &solver) {
    requirePointer(values, "values");
    const auto fields = wheelrail::namedFields(solver.fields());
    const Eigen::VectorXd &field = named(fields, "field", name).values;
    if (count < static_cast<std::size_t>(field.size()))
      throw Error(ExitCode::Usage,
                  fmt::format("{}: room for {} values; {} are needed", name, count, field.size()));
    std::copy(field.begin(), field.end(), values);
  });
}

const char *wheelrail_error(const wheelrail_contact *contact)
{
  return contact ? contact->error.c_str() : "the contact is a null pointer";
}

void wheelrail_free(wheelrail_contact *contact)
{
  delete contact;
}
// NOLINTEND(modernize-redundant-void-arg,readability-identifier-naming)
