#pragma once
/// Creep rates that a user of the package gives: a function of Python for arrays, or a compiled one.

#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "bindings.hpp"
#include "creepcontact/base/function.hpp"

namespace creepcontact::python {

/// The first exception that functions of a user have raised, from any thread: the caller of the run raises it again.
class Raised {
 public:
  void keep(std::exception_ptr raised) {
    const std::scoped_lock lock(mutex_);
    if (!first_) first_ = std::move(raised);
  }
  /// With the GIL. Raises it, once.
  void raise() {
    const std::scoped_lock lock(mutex_);
    if (first_) std::rethrow_exception(std::exchange(first_, nullptr));
  }

 private:
  std::mutex mutex_;
  std::exception_ptr first_;
};

/// @param variables  of q, T, t, eps, in the order of its arguments: arrays of one length
/// @param derivative  of the same arguments, gives (df/dq, df/deps); none: differences are taken
Function rate_of_python(const std::string& text, const std::vector<std::string>& variables, const py::object& function,
                        const py::object& derivative, std::shared_ptr<Raised> raised);

/// @param address  of a function double(double q, double T, double t, double eps) that any thread may call
Function rate_at_address(const std::string& text, const std::vector<std::string>& variables, std::uintptr_t address,
                         const py::object& owner);

}  // namespace creepcontact::python
