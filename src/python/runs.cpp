/// Runs, with the results in memory or in a directory, and observers written in Python.

#include <pybind11/stl.h>

#include <algorithm>
#include <exception>
#include <optional>

#include "bindings.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/base/thread_count.hpp"
#include "creepcontact/io/tables/summary.hpp"
#include "creepcontact/run/report.hpp"
#include "creepcontact/run/results_in_memory.hpp"
#include "creepcontact/run/run.hpp"
#include "user_rate.hpp"

namespace creepcontact::python {
namespace {

/// A state of the run, for observers, within the call that gets it.
class View {
 public:
  explicit View(run::StepView& view) : view_(&view) {}
  void close() { view_ = nullptr; }

  double time() const { return open().time(); }
  double step() const { return open().step != nullptr ? open().step->report.step : 0; }
  std::int64_t steps() const { return open().work().steps; }
  std::vector<double> probes() const { return open().probe_values(); }

 private:
  run::StepView& open() const {
    if (view_ == nullptr) throw std::runtime_error("this state may be used only within the call that got it");
    return *view_;
  }
  run::StepView* view_;
};

/// Calls methods of an object of Python. An exception there is kept, and ends the run.
class PythonObserver final : public run::Observer {
 public:
  PythonObserver(py::object target, Raised& raised) : target_(std::move(target)), raised_(raised) {}

  run::Reaction step(run::StepView& view) override { return call("on_step", view); }
  void output(run::StepView& view) override { stops_ = call("on_output", view) == run::Reaction::stop || stops_; }

 private:
  run::Reaction call(const char* method, run::StepView& view) {
    if (stops_) return run::Reaction::stop;
    const py::gil_scoped_acquire acquire;
    try {
      if (!py::hasattr(target_, method)) return run::Reaction::advance;
      const auto seen = std::make_shared<View>(view);
      const py::object answer = target_.attr(method)(seen);
      seen->close();
      if (answer.is_none() || answer.cast<bool>()) return run::Reaction::advance;
    } catch (...) {
      raised_.keep(std::current_exception());
    }
    stops_ = true;
    return run::Reaction::stop;
  }

  py::object target_;
  Raised& raised_;
  bool stops_ = false;
};

/// Gives messages to a function of Python, from any thread.
std::shared_ptr<const log::Sink> sink_for(const py::object& function) {
  return std::make_shared<const log::Sink>([kept = kept_for_threads(function)](log::Level level,
                                                                               std::string_view message) {
    const py::gil_scoped_acquire acquire;
    try {
      (*kept)(static_cast<int>(level), py::bytes(message.data(), message.size()).attr("decode")("utf-8", "replace"));
    } catch (py::error_already_set& error) {
      error.discard_as_unraisable("a handler of messages of creepcontact");
    }
  });
}

struct RunResult {
  run::Summary summary;
  std::unique_ptr<run::ResultsInMemory> memory;  // null: they are in the directory
};

std::unique_ptr<RunResult> run_model(const config::Config& config, run::Kept& kept, int threads,
                                     const std::optional<std::string>& output, bool resume, const py::list& observers,
                                     const py::object& log_function, Raised& raised) {
  auto result = std::make_unique<RunResult>();
  std::vector<std::unique_ptr<PythonObserver>> calling;
  for (const py::handle& observer : observers)
    calling.push_back(std::make_unique<PythonObserver>(py::reinterpret_borrow<py::object>(observer), raised));
  run::RunOptions options;
  options.writes_files = output.has_value();
  options.kept = &kept;
  options.resume = resume;
  if (output)
    options.output = *output;
  else
    options.observers.push_back((result->memory = std::make_unique<run::ResultsInMemory>(config)).get());
  for (const auto& one : calling) options.observers.push_back(one.get());
  const std::shared_ptr<const log::Sink> sink = sink_for(log_function);
  std::exception_ptr failure;
  {
    const py::gil_scoped_release release;
    const log::Redirection redirection(sink);
    const ThreadCount own(threads);
    try {
      result->summary = run::run(config, options);
    } catch (...) {
      failure = std::current_exception();
    }
  }
  raised.raise();
  if (failure) std::rethrow_exception(failure);
  return result;
}

py::dict arrays_of(const std::vector<io::FieldData>& fields, const py::handle& owner) {
  py::dict arrays;
  for (const io::FieldData& field : fields)
    arrays[py::str(field.name)] = view_of(field.values, field.components, owner);
  return arrays;
}

/// Points, cells and contact surfaces of the fields at a time.
py::tuple fields_at(const py::object& self, double time) {
  const auto& result = self.cast<const RunResult&>();
  const results::OutputFields& fields = result.memory->fields().at(time);
  return py::make_tuple(arrays_of(fields.at_points, self), arrays_of(fields.in_cells, self),
                        arrays_of(fields.on_contacts, self));
}

py::dict steps_of(const RunResult& result) {
  const std::vector<io::StepRow>& steps = result.memory->steps();
  py::dict columns;
  const auto add = [&](const char* name, auto of) {
    std::vector<decltype(of(steps.front()))> values;
    values.reserve(steps.size());
    for (const io::StepRow& row : steps) values.push_back(of(row));
    columns[name] = array_of(std::move(values));
  };
  add("time", [](const io::StepRow& row) { return row.time; });
  add("step", [](const io::StepRow& row) { return row.step; });
  add("order", [](const io::StepRow& row) { return row.order; });
  add("rhs_evaluations", [](const io::StepRow& row) { return row.work.rhs_evaluations; });
  add("elastic_solves", [](const io::StepRow& row) { return row.work.elastic_solves; });
  add("schwarz_iterations", [](const io::StepRow& row) { return row.work.schwarz_iterations; });
  add("active_contacts", [](const io::StepRow& row) { return row.active_contacts; });
  add("error_estimate", [](const io::StepRow& row) { return row.error_estimate; });
  return columns;
}

}  // namespace

void bind_runs(py::module_& module) {
  py::class_<run::Kept>(module, "Kept")
      .def(py::init<>())
      .def_property_readonly("meshes_read", [](const run::Kept& kept) { return kept.meshes.n_read(); })
      .def_property_readonly("factorizations", [](const run::Kept& kept) { return kept.factors.n_computed(); })
      .def_property_readonly("factors_found", [](const run::Kept& kept) { return kept.factors.n_found(); });
  py::class_<View, std::shared_ptr<View>>(module, "State")
      .def_property_readonly("time", &View::time)
      .def_property_readonly("step", &View::step)
      .def_property_readonly("steps", &View::steps)
      .def_property_readonly("probe_values", &View::probes);
  py::class_<RunResult>(module, "RunResult")
      .def_property_readonly("exit_status", [](const RunResult& result) { return result.summary.exit_status; })
      .def_property_readonly("message", [](const RunResult& result) { return result.summary.message; })
      .def_property_readonly("summary",
                             [](const RunResult& result) { return io::summary_text(result.summary.results); })
      .def_property_readonly("report", [](const RunResult& result) { return run::report(result.summary); })
      .def_property_readonly(
          "times",
          [](const py::object& self) { return view_of(self.cast<const RunResult&>().memory->times(), 1, self); })
      .def("probe_values",
           [](const py::object& self, py::ssize_t n_probes) {
             return view_of(self.cast<const RunResult&>().memory->probe_values(), n_probes, self);
           })
      .def_property_readonly("steps", steps_of)
      .def_property_readonly("field_times",
                             [](const RunResult& result) {
                               std::vector<double> times;
                               for (const auto& [time, fields] : result.memory->fields()) times.push_back(time);
                               return times;
                             })
      .def("fields", fields_at)
      .def_property_readonly("mesh", [](const RunResult& result) { return result.memory->mesh(); })
      .def_property_readonly("contact_mesh", [](const RunResult& result) { return result.memory->contact_mesh(); })
      .def_property_readonly("groups", [](const RunResult& result) {
        py::dict groups;
        for (const auto& [name, nodes] : result.memory->groups()) groups[py::str(name)] = array_of(nodes);
        return groups;
      });
  module.def("run", run_model, py::arg("config"), py::arg("kept"), py::arg("threads"), py::arg("output"),
             py::arg("resume"), py::arg("observers"), py::arg("log"), py::arg("raised"));
}

}  // namespace creepcontact::python
