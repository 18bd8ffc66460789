#include "user_rate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "creepcontact/base/error.hpp"

namespace creepcontact::python {
namespace {

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

double Arguments::*member_of(const std::string& name) {
  return name == "q" ? &Arguments::q : name == "T" ? &Arguments::T : name == "t" ? &Arguments::t : &Arguments::eps;
}

class RateOfPython final : public BatchedFunction {
 public:
  RateOfPython(std::string text, const std::vector<std::string>& variables, const py::object& function,
               const py::object& derivative, std::shared_ptr<Raised> raised)
      : text_(std::move(text)), function_(kept_for_threads(function)), raised_(std::move(raised)) {
    for (const std::string& variable : variables) members_.push_back(member_of(variable));
    if (!derivative.is_none()) derivative_ = kept_for_threads(derivative);
  }

  void evaluate(std::span<const Arguments> at, std::span<double> values) const override {
    guarded(values, [&] { take(called(*function_, at), values, "the rate"); });
  }
  bool differentiate(std::span<const Arguments> at, std::span<double> by_stress,
                     std::span<double> by_strain) const override {
    if (!derivative_) return false;
    guarded(by_stress, [&] {
      const py::object both = called(*derivative_, at);
      if (!py::isinstance<py::sequence>(both) || py::len(both) != 2)
        throw py::value_error(text_ + ": the derivative must give two arrays, df/dq and df/deps");
      take(both[py::int_(0)], by_stress, "df/dq");
      take(both[py::int_(1)], by_strain, "df/deps");
    });
    return true;
  }

 private:
  /// What Python raises is kept, for the caller of the run. Many points are evaluated outside of loops over points,
  /// which no exception can leave, so that it ends the run at once.
  template <typename Work>
  void guarded(std::span<double> values, const Work& work) const {
    const py::gil_scoped_acquire acquire;
    try {
      work();
      return;
    } catch (...) {
      raised_->keep(std::current_exception());
    }
    std::ranges::fill(values, std::numeric_limits<double>::quiet_NaN());
    if (values.size() > 1) throw SolverError(text_ + " has raised an exception");
  }
  py::object called(const py::object& function, std::span<const Arguments> at) const {
    py::tuple arguments(members_.size());
    for (std::size_t i = 0; i < members_.size(); ++i) {
      py::array_t<double> column(static_cast<py::ssize_t>(at.size()));
      for (std::size_t p = 0; p < at.size(); ++p) column.mutable_data()[p] = at[p].*members_[i];
      arguments[i] = std::move(column);
    }
    return function(*arguments);
  }
  void take(const py::object& given, std::span<double> values, const char* what) const {
    const Array array = Array::ensure(given);
    if (!array) throw py::value_error(fmt::format("{}: {} is not an array of numbers", text_, what));
    if (array.size() == 1)
      std::ranges::fill(values, array.data()[0]);
    else if (array.ndim() == 1 && array.size() == static_cast<py::ssize_t>(values.size()))
      std::copy_n(array.data(), values.size(), values.begin());
    else
      throw py::value_error(
          fmt::format("{}: {} has {} values for {} points", text_, what, array.size(), values.size()));
  }

  std::string text_;
  std::vector<double Arguments::*> members_;
  std::shared_ptr<py::object> function_, derivative_;
  std::shared_ptr<Raised> raised_;
};

class RateAtAddress final : public BatchedFunction {
 public:
  RateAtAddress(std::uintptr_t address, const py::object& owner)
      // NOLINTNEXTLINE(performance-no-int-to-ptr): Python has it as a number
      : function_(reinterpret_cast<Compiled>(address)), owner_(kept_for_threads(owner)) {}
  void evaluate(std::span<const Arguments> at, std::span<double> values) const override {
    for (std::size_t p = 0; p < at.size(); ++p) values[p] = function_(at[p].q, at[p].T, at[p].t, at[p].eps);
  }

 private:
  using Compiled = double (*)(double q, double T, double t, double eps);
  Compiled function_;
  std::shared_ptr<py::object> owner_;  // of the code
};

}  // namespace

Function rate_of_python(const std::string& text, const std::vector<std::string>& variables, const py::object& function,
                        const py::object& derivative, std::shared_ptr<Raised> raised) {
  return Function::batched(text, variables,
                           std::make_shared<RateOfPython>(text, variables, function, derivative, std::move(raised)));
}

Function rate_at_address(const std::string& text, const std::vector<std::string>& variables, std::uintptr_t address,
                         const py::object& owner) {
  return Function::batched(text, variables, std::make_shared<RateAtAddress>(address, owner));
}

}  // namespace creepcontact::python
