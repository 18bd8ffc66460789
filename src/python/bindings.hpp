#pragma once
/// The parts of the module _core of the Python package creepcontact.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <utility>
#include <vector>

namespace creepcontact::python {

namespace py = pybind11;

void bind_errors(py::module_& module);
void bind_configuration(py::module_& module);
void bind_runs(py::module_& module);
void bind_fields(py::module_& module);
void bind_materials(py::module_& module);

/// An object that threads without the GIL may drop.
inline std::shared_ptr<py::object> kept_for_threads(const py::object& object) {
  return {new py::object(object), [](py::object* kept) {
            const py::gil_scoped_acquire acquire;
            delete kept;
          }};
}

/// A read-only array over values that `owner` keeps alive; nothing is copied.
inline py::array_t<double> view_of(const std::vector<double>& values, py::ssize_t columns, const py::handle& owner) {
  const auto rows = static_cast<py::ssize_t>(values.size()) / columns;
  py::array_t<double> array = columns == 1 ? py::array_t<double>(rows, values.data(), owner)
                                           : py::array_t<double>({rows, columns}, values.data(), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// An array that owns its values.
template <typename T>
py::array_t<T> array_of(std::vector<T> values, py::ssize_t columns = 1) {
  auto* const kept = new std::vector<T>(std::move(values));
  const py::capsule owner(kept, [](void* data) { delete static_cast<std::vector<T>*>(data); });
  const auto rows = static_cast<py::ssize_t>(kept->size()) / columns;
  return columns == 1 ? py::array_t<T>(rows, kept->data(), owner)
                      : py::array_t<T>({rows, columns}, kept->data(), owner);
}

}  // namespace creepcontact::python
