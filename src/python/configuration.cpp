/// Configurations and the keys that they may have.

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <sstream>

#include "bindings.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/suggestion.hpp"
#include "creepcontact/config/reader.hpp"
#include "creepcontact/config/schema.hpp"
#include "creepcontact/config/writer.hpp"
#include "creepcontact/run/check.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "user_rate.hpp"

namespace creepcontact::python {
namespace {

using Overrides = std::vector<std::string>;

const config::Vocabulary& vocabulary() {
  static const config::Vocabulary once = run::vocabulary();
  return once;
}

const char* name_of(config::Form form) {
  switch (form) {
    case config::Form::table:
      return "table";
    case config::Form::tables:
      return "tables";
    case config::Form::named:
      return "named";
    default:
      return "value";
  }
}

py::list keys() {
  py::list all;
  for (const config::KeyInfo& key : config::schema(vocabulary())) {
    py::dict entry;
    entry["path"] = key.path;
    entry["type"] = key.type;
    entry["required"] = key.required;
    entry["default"] = key.default_value;
    entry["description"] = key.description;
    entry["form"] = name_of(key.form);
    entry["only_with"] = key.only_with;
    all.append(entry);
  }
  return all;
}

std::string check(const config::Config& config, bool start) {
  std::ostringstream text;
  {
    const py::gil_scoped_release release;
    run::check(config, text, {.start = start});
  }
  return text.str();
}

/// The one mechanism of a material is the law `expression` with this rate.
void set_rate(config::Config& config, const std::string& name, Function rate) {
  std::vector<std::string> names;
  for (config::Material& material : config.materials) {
    names.push_back(material.name);
    if (material.name != name) continue;
    config::CreepMechanism mechanism;
    mechanism.law = "expression";
    mechanism.depends_on_temperature = rate.depends_on_temperature();
    mechanism.parameters.push_back({.key = "rate", .values = {std::move(rate)}});
    material.creep = {std::move(mechanism)};
    return;
  }
  throw ConfigError(fmt::format("there is no material '{}'{}", name, did_you_mean(name, names)));
}

}  // namespace

void bind_configuration(py::module_& module) {
  py::class_<Raised, std::shared_ptr<Raised>>(module, "Raised").def(py::init<>());
  py::class_<config::Config>(module, "Config")
      .def_static(
          "read",
          [](const std::filesystem::path& file, const Overrides& overrides) {
            return config::read(file, vocabulary(), overrides);
          },
          py::arg("file"), py::arg("overrides"))
      .def_static(
          "parse",
          [](const std::string& text, const std::filesystem::path& file, const Overrides& overrides) {
            return config::parse(text, file, vocabulary(), overrides);
          },
          py::arg("text"), py::arg("file"), py::arg("overrides"))
      .def("to_toml", [](const config::Config& config) { return config::to_toml(config, vocabulary()); })
      .def("check", check, py::arg("start"))
      .def("at_start",
           [](config::Config config) {
             config.time.end = 0;
             config.time.output = {0};
             config.time.cycle.reset();
             config.output.fields = true;
             config.output.field_times.reset();
             return config;
           })
      .def("set_rate",
           [](config::Config& config, const std::string& material, const std::string& text,
              const std::vector<std::string>& variables, const py::object& function, const py::object& derivative,
              const std::shared_ptr<Raised>& raised) {
             set_rate(config, material, rate_of_python(text, variables, function, derivative, raised));
           })
      .def("set_rate_at",
           [](config::Config& config, const std::string& material, const std::string& text,
              const std::vector<std::string>& variables, std::uintptr_t address, const py::object& owner) {
             set_rate(config, material, rate_at_address(text, variables, address, owner));
           })
      .def("trust_geometry", [](config::Config& config, bool trusted) { config.mesh.trust_geometry = trusted; })
      .def_property_readonly("end", [](const config::Config& config) { return config.time.end; })
      .def_property_readonly("outputs", [](const config::Config& config) { return config.time.output; })
      .def_property_readonly("title", [](const config::Config& config) { return config.title; })
      .def_property_readonly("units", [](const config::Config& config) { return config.units; })
      .def_property_readonly("directory", [](const config::Config& config) { return config.output.directory; })
      .def_property_readonly("probes", [](const config::Config& config) {
        std::vector<std::string> names;
        for (const config::Probe& probe : config.probes) names.push_back(probe.name);
        return names;
      });
  module.def("keys", keys);
}

}  // namespace creepcontact::python
