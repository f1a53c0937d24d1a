// SPDX-License-Identifier: GPL-2.0-or-later
#include "python/glue.h"

#include "base/errors.h"
#include "shared/output_file.h"

#include <algorithm>
#include <cstdint>

namespace wheelrail::python {
namespace {

bool isNumber(const py::handle &value)
{
  return py::isinstance<py::int_>(value) || py::isinstance<py::float_>(value) ||
         py::hasattr(value, "__float__");
}

/// Raises the class of a code.
void raise(int code, const std::string &message, const std::string &file, int line,
           const std::string &keyword)
{
  const py::object type = typesOf().attr("CLASSES")[py::int_(code)];
  const py::object error = type(message, file, line, keyword);
  PyErr_SetObject(type.ptr(), error.ptr());
}

} // namespace

py::module_ typesOf()
{
  return py::module_::import("wheelrail._types");
}

YAML::Node treeOf(const py::handle &value)
{
  YAML::Node node;
  if (py::isinstance<py::str>(value)) {
    node = value.cast<std::string>();
  } else if (py::isinstance<py::bool_>(value)) {
    node = value.cast<bool>() ? "true" : "false";
  } else if (py::isinstance<py::dict>(value)) {
    node = YAML::Node(YAML::NodeType::Map);
    for (const auto &item : value.cast<py::dict>())
      node[py::str(item.first).cast<std::string>()] = treeOf(item.second);
  } else if (py::hasattr(value, "tolist") && !py::isinstance<py::list>(value)) { // numpy
    node = treeOf(value.attr("tolist")());
  } else if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
    node = YAML::Node(YAML::NodeType::Sequence);
    for (const py::handle &item : value)
      node.push_back(treeOf(item));
  } else if (py::hasattr(value, "__fspath__")) {
    node = py::module_::import("os").attr("fspath")(value).cast<std::string>();
  } else if (isNumber(value)) {
    node = py::str(value).cast<std::string>();
  } else {
    throw py::type_error("a case has texts, numbers, lists and dicts of them, not " +
                         py::str(py::type::of(value)).cast<std::string>());
  }
  return node;
}

std::string pathOf(const py::object &path)
{
  return py::module_::import("os").attr("fspath")(path).cast<std::string>();
}

py::array_t<double> arrayOf(const std::vector<double> &values)
{
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

py::array_t<double> arrayOf(const Eigen::VectorXd &values)
{
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

py::array_t<double> arrayOf(const Eigen::VectorXd &values, const CellGrid &grid)
{
  return py::array_t<double>(std::vector<py::ssize_t>{grid.ny, grid.nx}, values.data());
}

py::dict fieldsOf(const PatchGrid &grid, const PatchFields &fields)
{
  Eigen::VectorXd x(grid.nx), y(grid.ny);
  for (int ix = 0; ix < grid.nx; ++ix)
    x[ix] = grid.x(ix);
  for (int iy = 0; iy < grid.ny; ++iy)
    y[iy] = grid.y(iy);
  py::dict all;
  all["x"] = arrayOf(x);
  all["y"] = arrayOf(y);
  for (const NamedField &field : namedFields(fields))
    all[field.name.c_str()] = arrayOf(field.values, grid);
  return all;
}

py::object fromJson(const std::string &text)
{
  return py::module_::import("json").attr("loads")(text);
}

void addErrors()
{
  // NOLINTNEXTLINE(performance-unnecessary-value-param): a function of pybind11's type
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown)
        std::rethrow_exception(thrown);
    } catch (const Error &error) {
      if (error.code() == ExitCode::Interrupted)
        PyErr_SetNone(PyExc_KeyboardInterrupt);
      else
        raise(static_cast<int>(error.code()), error.what(), error.file(), error.line(),
              error.keyword());
    } catch (const mcawr::OutputError &error) {
      raise(static_cast<int>(ExitCode::Io), error.what(), "", 0, "");
    }
  });
}

} // namespace wheelrail::python
