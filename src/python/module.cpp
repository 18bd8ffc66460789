/// The extension module creepcontact._core: the library for the Python package, which is written in Python around it.

#include "bindings.hpp"

PYBIND11_MODULE(_core, module) {
  module.doc() = "The library behind the package creepcontact; use the package.";
  module.attr("version") = CREEPCONTACT_VERSION;
  creepcontact::python::bind_errors(module);
  creepcontact::python::bind_configuration(module);
  creepcontact::python::bind_fields(module);
  creepcontact::python::bind_runs(module);
  creepcontact::python::bind_materials(module);
}
