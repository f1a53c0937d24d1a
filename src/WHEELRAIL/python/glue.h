// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_PYTHON_GLUE_H
#define WHEELRAIL_PYTHON_GLUE_H

#include "contact/patch/elasticity/grid.h"
#include "creep/patch/field_files.h"

#include <Eigen/Core>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <string>
#include <vector>
#include <yaml-cpp/yaml.h>

/// What the parts of the Python module share. No physics: Python's types on one side, the library's
/// on the other.
namespace wheelrail::python {

namespace py = pybind11;

/// A dict, list, number or text as a value of a case; a dict has keywords or groups of them.
/// \throws py::type_error for anything else
YAML::Node treeOf(const py::handle &value);
/// The path that a str or an os.PathLike names.
std::string pathOf(const py::object &path);

/// New arrays that own their values.
py::array_t<double> arrayOf(const std::vector<double> &values);
py::array_t<double> arrayOf(const Eigen::VectorXd &values);
/// Row y, column x: a[iy, ix].
py::array_t<double> arrayOf(const Eigen::VectorXd &values, const CellGrid &grid);

/// Fields of a patch by their names, with the places of the cells, x and y.
py::dict fieldsOf(const PatchGrid &grid, const PatchFields &fields);

/// The part of the module that is written in Python.
py::module_ typesOf();

/// JSON as Python's own types.
py::object fromJson(const std::string &text);

/// Each adds its classes and functions.
void addErrors();
void addCase(py::module_ &module);
void addContact(py::module_ &module);
void addFit(py::module_ &module);

} // namespace wheelrail::python
#endif
