// SPDX-License-Identifier: GPL-2.0-or-later
// wheelrail._core: the library for Python. wheelrail/__init__.py says what of it users see.
#include "base/version.h"
#include "python/glue.h"

PYBIND11_MODULE(_core, module)
{
  using namespace wheelrail::python;
  module.doc() = "What wr_creep and wr_fit compute; see wheelrail.";
  module.attr("__version__") = wheelrail::versionText;
  addErrors();
  addCase(module);
  addContact(module);
  addFit(module);
}
