// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "creep/online/online_contact.h"
#include "python/glue.h"

#include <mutex>
#include <optional>

#include <pybind11/stl.h>

namespace wheelrail::python {
namespace {

using Number = std::optional<double>;

/// An OnlineContact that one thread of Python uses at a time: a step leaves the interpreter to the
/// others.
class Contact {
 public:
  explicit Contact(const Case &input) : solver_(input) {}

  py::object step(Number creep, Number lateral, Number spin, Number load, Number speed)
  {
    const auto lock = use();
    Creepage creepage = solver_.creepage();
    creepage.xi = creep.value_or(creepage.xi);
    creepage.eta = lateral.value_or(creepage.eta);
    creepage.phi = spin.value_or(creepage.phi);
    solver_.set(creepage, load.value_or(solver_.load()), speed.value_or(solver_.speed()));
    PatchPoint point;
    {
      const py::gil_scoped_release others;
      point = solver_.step();
    }
    return typesOf().attr("Forces")(point.forceX, point.forceY, point.momentZ);
  }
  py::dict values()
  {
    const auto lock = use();
    py::dict all;
    for (const Column<PatchPoint> &column : solver_.columns())
      all[column.name.c_str()] = column.value.get(solver_.point());
    return all;
  }
  py::dict fields()
  {
    const auto lock = use();
    return fieldsOf(solver_.contact().grid, solver_.fields());
  }
  double get(double (*value)(const OnlineContact &))
  {
    const auto lock = use();
    return value(solver_);
  }

 private:
  /// \throws Error (Usage) where another thread is at work
  std::unique_lock<std::mutex> use()
  {
    std::unique_lock<std::mutex> lock(busy_, std::try_to_lock);
    if (!lock)
      throw Error(ExitCode::Usage, "the contact is at work on another thread: give each thread a "
                                   "Contact of its own");
    return lock;
  }

  OnlineContact solver_;
  std::mutex busy_;
};

template<class Get>
void addProperty(py::class_<Contact> &type, const char *name, Get get, const char *doc)
{
  double (*const value)(const OnlineContact &) = get;
  type.def_property_readonly(
      name, [value](Contact &contact) { return contact.get(value); }, doc);
}

} // namespace

void addContact(py::module_ &module)
{
  using Solver = OnlineContact;
  py::class_<Contact> type(
      module, "Contact",
      "A point contact that rolls steadily and is asked for one operating point after the "
      "other.\n\n"
      "Made of a Case of a point contact in mode frozen with creepages and one surface, whose "
      "first\n"
      "creepages and speed and largest load are set. The box of cells is that of this load and\n"
      "stays; a load whose contact reaches its border is refused. A step begins at the one "
      "before,\n"
      "on which its result depends within the tolerance of the solver only. SI units.");
  type.def(py::init<const Case &>(), py::arg("case"), py::call_guard<py::gil_scoped_release>());
  type.def(
      "step", &Contact::step, py::arg("creep") = py::none(), py::arg("lateral") = py::none(),
      py::arg("spin") = py::none(), py::kw_only(), py::arg("load") = py::none(),
      py::arg("speed") = py::none(),
      "Sets what is given, solves, and returns the Forces on the wheel.\n\n"
      "creep, lateral: sliding over rolling speed; spin: 1/m; load: N; speed: m/s. What is not\n"
      "given stays. Raises UsageError for a number that its keyword of a case may not be, "
      "BadInput\n"
      "for a load whose contact is on fewer than 4 cells across, and then changes nothing; "
      "BadInput\n"
      "for a load that leaves the box, NotConverged.");
  type.def("values", &Contact::values,
           "All numbers of the last step by the names of the columns of creep.csv, in SI units.");
  type.def("fields", &Contact::fields,
           "The fields of the last step by the names of the .gsf files, as arrays [y, x] in SI\n"
           "units, with x and y of the cells' centres (m).");
  addProperty(
      type, "creep", [](const Solver &s) { return s.creepage().xi; },
      "Longitudinal creepage that is set.");
  addProperty(
      type, "lateral", [](const Solver &s) { return s.creepage().eta; },
      "Lateral creepage that is set.");
  addProperty(
      type, "spin", [](const Solver &s) { return s.creepage().phi; }, "Spin that is set, 1/m.");
  addProperty(
      type, "load", [](const Solver &s) { return s.load(); }, "Normal force that is set, N.");
  addProperty(
      type, "speed", [](const Solver &s) { return s.speed(); }, "Rolling speed that is set, m/s.");
}

} // namespace wheelrail::python
