/// Materials without a model: rates, creep curves and relaxation of a bar, the library of published data, and fits.

#include "creepcontact/model/materials.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "bindings.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/suggestion.hpp"
#include "creepcontact/config/material_library.hpp"
#include "creepcontact/fit/fit.hpp"
#include "creepcontact/fit/report.hpp"
#include "creepcontact/material/bar.hpp"
#include "creepcontact/material/registry.hpp"
#include "creepcontact/run/vocabulary.hpp"

namespace creepcontact::python {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Values of one length.
using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

std::vector<double> times_of(const Array& given) {
  if (given.ndim() != 1) throw std::invalid_argument("times: a one-dimensional array is needed");
  std::vector<double> times(given.data(), given.data() + given.size());
  for (std::size_t i = 0; i < times.size(); ++i)
    if (!(times[i] >= 0) || (i > 0 && !(times[i] > times[i - 1])))
      throw std::invalid_argument("times: they must increase, from 0 or later on");
  return times;
}

class Bar {
 public:
  explicit Bar(material::Material material) : material_(std::move(material)) {
    std::erase_if(material_.creep, [](const auto& law) { return !law->strains(); });
  }

  const std::string& name() const { return material_.name; }
  std::vector<std::string> laws() const {
    std::vector<std::string> names;
    for (const auto& law : material_.creep) names.push_back(law->name());
    return names;
  }
  double young_modulus(double temperature) const { return material_.young_modulus({.T = temperature}); }
  double rate(double stress, double temperature, double time, double strain) const {
    return material::rate_at(material_.creep, {.stress = stress, .temperature = temperature}, time, strain);
  }
  /// @param modulus  of a relaxation test; infinite: constant stress
  /// @returns creep strain and stress; NaN after rupture
  py::tuple history(double stress, const Array& at, double temperature, double modulus) const {
    const std::vector<double> times = times_of(at);
    material::BarHistory history;
    {
      const py::gil_scoped_release release;
      history = material::bar_history(material_.creep,
                                      {.stress = stress, .temperature = temperature, .young_modulus = modulus}, times);
    }
    std::vector<double> strains(times.size(), none), stresses(times.size(), none);
    for (std::size_t i = 0; i < history.states.size(); ++i) {
      strains[i] = history.states[i].creep_strain;
      stresses[i] = history.states[i].stress;
    }
    return py::make_tuple(array_of(std::move(strains)), array_of(std::move(stresses)), history.rupture);
  }

 private:
  material::Material material_;
};

Function function_of(const std::string& key, const py::handle& value, const std::vector<std::string>& variables) {
  if (py::isinstance<py::str>(value)) try {
      return Function::expression(value.cast<std::string>(), variables);
    } catch (const std::invalid_argument& error) {
      throw ConfigError(fmt::format("{}: {}", key, error.what()));
    }
  if (py::isinstance<py::dict>(value)) {
    const auto table = py::reinterpret_borrow<py::dict>(value);
    if (!table.contains("T") || !table.contains("values"))
      throw ConfigError(key + ": a table needs the keys T and values");
    return Function::table("T", table["T"].cast<std::vector<double>>(), table["values"].cast<std::vector<double>>());
  }
  return {value.cast<double>()};
}

/// @param young_modulus  null: 1
Bar bar_of_law(const std::string& name, const py::dict& constants, const py::object& young_modulus) {
  const material::LawInfo* const info = material::find_creep_law(name);
  if (info == nullptr) {
    std::vector<std::string> names;
    for (const material::LawInfo& one : material::creep_laws()) names.push_back(one.name);
    const std::string question = did_you_mean(name, names);
    throw ConfigError(fmt::format("unknown creep law '{}'{}", name, question));
  }
  std::map<std::string, std::vector<Function>> given;
  for (const auto& [key, value] : constants) {
    const auto word = key.cast<std::string>();
    const auto known = std::ranges::find(info->parameters, word, &material::ParameterInfo::key);
    if (known == info->parameters.end()) {
      std::vector<std::string> names;
      for (const material::ParameterInfo& one : info->parameters) names.push_back(one.key);
      throw ConfigError(fmt::format("{}: unknown constant '{}'{}", name, word, did_you_mean(word, names)));
    }
    if (!known->words.empty() && py::isinstance<py::str>(value)) {
      const auto found = std::ranges::find(known->words, value.cast<std::string>());
      if (found == known->words.end())
        throw ConfigError(
            fmt::format("{}: '{}'; allowed: {}", word, value.cast<std::string>(), fmt::join(known->words, ", ")));
      given[word] = {static_cast<double>(found - known->words.begin())};
      continue;
    }
    if (known->list)
      for (const py::handle& one : value) given[word].push_back(function_of(word, one, known->variables));
    else
      given[word] = {function_of(word, value, known->variables)};
  }
  material::Material made;
  made.name = name;
  made.young_modulus = young_modulus.is_none() ? Function(1) : function_of("young_modulus", young_modulus, {"T"});
  try {
    made.creep.push_back(info->make_by_key(given));
  } catch (const material::ParameterError& error) {
    throw ConfigError(fmt::format("{}: {}", name, error.what()));
  }
  return Bar(std::move(made));
}

py::dict library_entry(const std::string& use, const std::string& units) {
  const config::Vocabulary vocabulary = run::vocabulary();
  const std::vector<config::LibraryMaterial> library = config::material_library(vocabulary.materials);
  const std::string key = use.substr(0, use.find('/'));
  const auto steel = std::ranges::find(library, key, &config::LibraryMaterial::key);
  if (steel == library.end())
    throw ConfigError(fmt::format("the material library has no '{}'{}", use, did_you_mean(use, names_of(library))));
  const std::string variant = use == key ? steel->variants.front().name : use.substr(key.size() + 1);
  const auto found = std::ranges::find(steel->variants, variant, &config::LibraryVariant::name);
  if (found == steel->variants.end())
    throw ConfigError(fmt::format("'{}' has no variant '{}'{}", key, variant, did_you_mean(use, names_of(library))));
  py::dict entry;
  entry["bar"] = Bar(model::make_material(
      config::library_material(*steel, variant, units.empty() ? steel->units : units, vocabulary)));
  entry["units"] = units.empty() ? steel->units : units;
  entry["name"] = fmt::format("{}/{}", key, variant);
  const config::LibrarySource* const source = steel->source(found->source);
  entry["source"] = source != nullptr ? source->citation : "";
  entry["status"] = source != nullptr ? source->status : "";
  entry["notes"] = found->notes;
  const auto range = [&](const char* name, const std::optional<Interval>& interval) {
    entry[name] = interval ? py::object(py::make_tuple(interval->low, interval->high)) : py::none();
  };
  range("stress_range", found->stress_range);
  range("temperature_range", found->temperature_range);
  range("time_range", found->time_range);
  entry["has_elasticity"] = steel->has("young_modulus");
  return entry;
}

py::dict fit_data(const std::filesystem::path& file, const fit::LawWishes& wishes, const py::object& young_modulus,
                  const std::optional<double>& temperature) {
  fit::ReadOptions reading;
  if (!young_modulus.is_none()) reading.young_modulus = function_of("young_modulus", young_modulus, {"T"});
  reading.temperature = temperature;
  fit::TestData data;
  fit::LawChoice choice;
  fit::FitResult result;
  {
    const py::gil_scoped_release release;
    data = fit::read_test_data(file, reading);
    choice = fit::choose_law(wishes, data);
    result = fit::fit_law(data, choice, reading.young_modulus);
  }
  if (const std::string reason = fit::why_useless(choice, result); !reason.empty())
    throw SolverError(fmt::format("{}: {}", data.file, reason));
  py::dict values, low, high, units;
  for (const fit::FittedParameter& one : result.parameters) {
    values[py::str(one.key)] = one.value;
    low[py::str(one.key)] = one.low;
    high[py::str(one.key)] = one.high;
    units[py::str(one.key)] = one.unit;
  }
  const auto n = static_cast<py::ssize_t>(result.correlation.cols());
  std::vector<double> correlation(result.correlation.data(), result.correlation.data() + result.correlation.size());
  std::vector<std::string> warnings = data.notes;
  for (const auto* more : {&choice.notes, &result.warnings})
    warnings.insert(warnings.end(), more->begin(), more->end());
  py::dict all;
  all["values"] = values;
  all["low"] = low;
  all["high"] = high;
  all["units"] = units;
  all["correlation"] = array_of(std::move(correlation), n);
  all["deviation"] = result.deviation;
  all["report"] = fit::report(data, choice, result);
  all["block"] = fit::material_block(data, choice, result, {});
  all["warnings"] = warnings;
  py::dict batches;
  if (result.batches)
    for (const fit::BatchScatter::Batch& batch : result.batches->batches)
      batches[py::str(batch.name)] = std::exp(batch.difference);
  all["batches"] = batches;
  all["batch_deviation"] = result.batches ? py::cast(result.batches->deviation) : py::none();
  material::Material made;
  made.name = wishes.law;
  made.young_modulus = reading.young_modulus.value_or(Function(1));
  made.creep.push_back(result.law);
  all["bar"] = Bar(std::move(made));
  return all;
}

}  // namespace

void bind_materials(py::module_& module) {
  py::class_<Bar>(module, "Bar")
      .def_property_readonly("name", &Bar::name)
      .def_property_readonly("laws", &Bar::laws)
      .def("young_modulus", py::vectorize(&Bar::young_modulus), py::arg("temperature"))
      .def("rate", py::vectorize(&Bar::rate), py::arg("stress"), py::arg("temperature"), py::arg("time"),
           py::arg("strain"))
      .def("history", &Bar::history, py::arg("stress"), py::arg("times"), py::arg("temperature"), py::arg("modulus"));
  module.def("law", bar_of_law, py::arg("name"), py::arg("constants"), py::arg("young_modulus"));
  module.def("laws", [] {
    py::dict all;
    for (const material::LawInfo& law : material::creep_laws()) all[py::str(law.name)] = law.formula;
    return all;
  });
  module.def("library_entry", library_entry, py::arg("use"), py::arg("units"));
  module.def("library_names", [] { return names_of(config::material_library(run::vocabulary().materials)); });
  module.def("material_of", [](const config::Config& config, const std::string& name) {
    std::vector<std::string> names;
    for (const config::Material& material : config.materials) {
      if (material.name == name) return Bar(model::make_material(material));
      names.push_back(material.name);
    }
    throw ConfigError(fmt::format("there is no material '{}'{}", name, did_you_mean(name, names)));
  });
  module.def(
      "fit",
      [](const std::filesystem::path& file, const std::string& law, std::vector<std::string> set,
         std::vector<std::string> free, const py::object& young_modulus, const std::optional<double>& temperature) {
        return fit_data(file, {law, std::move(set), std::move(free)}, young_modulus, temperature);
      },
      py::arg("file"), py::arg("law"), py::arg("set"), py::arg("free"), py::arg("young_modulus"),
      py::arg("temperature"));
}

}  // namespace creepcontact::python
