/// Errors of the library as the exceptions of the package.

#include "bindings.hpp"
#include "creepcontact/base/error.hpp"

namespace creepcontact::python {
namespace {

/// @param name  of a class in creepcontact.errors
void raise_as(const char* name, const char* message) {
  PyErr_SetString(py::module_::import("creepcontact.errors").attr(name).ptr(), message);
}

}  // namespace

void bind_errors(py::module_& /*module*/) {
  // NOLINTNEXTLINE(performance-unnecessary-value-param): the type that pybind11 asks for
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const ConfigError& error) {
      raise_as("ConfigError", error.what());
    } catch (const ModelError& error) {
      raise_as("ModelError", error.what());
    } catch (const SolverError& error) {
      raise_as("SolverError", error.what());
    } catch (const Error& error) {
      raise_as("Error", error.what());
    }
  });
}

}  // namespace creepcontact::python
