#include "model_record.hpp"

#include <fmt/chrono.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <map>
#include <numeric>
#include <set>

#include "creepcontact/base/base64.hpp"
#include "creepcontact/base/checksum.hpp"
#include "creepcontact/base/image.hpp"
#include "creepcontact/base/units.hpp"
#include "creepcontact/config/configured.hpp"
#include "creepcontact/material/creep_curve.hpp"
#include "creepcontact/material/registry.hpp"
#include "creepcontact/model/temperature.hpp"
#include "creepcontact/results/quantities.hpp"
#include "fingerprint.hpp"
#include "gap_report.hpp"
#include "load_words.hpp"
#include "model_view.hpp"

namespace creepcontact::run {
namespace {

constexpr std::array levels{1.0, 0.5, 0.25};  // of the largest stress at the start, for creep curves
constexpr std::size_t curve_points = 60;      // kept of a curve
constexpr double least_strain = 1e-8;         // of these curves: less is of no interest
constexpr std::size_t samples = 200;          // of a function of time

std::string now() {
  const std::time_t seconds = std::time(nullptr);
  return fmt::format("{:%Y-%m-%dT%H:%M:%S%z}", fmt::localtime(seconds));
}

std::string short_fingerprint(const config::Config& config, const model::Model& model) {
  const std::string text = fingerprint(config, model);
  Checksum sum;
  sum.add(text.data(), text.size());
  return fmt::format("{:016x}", sum.value());
}

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit.empty() ? text : fmt::format("{} [{}]", text, unit);
}

/// Words of the configuration as sections of the record.
class Recorder {
 public:
  Recorder(const config::Config& config, const model::Model& model, const io::Summary& at_start)
      : config_(config), model_(model), at_start_(at_start), temperature_(model::temperature_range(config, model)) {}

  io::RecordedSection mesh() const {
    const std::string volume =
        with_unit("volume", unit(Dimension::length).empty() ? "" : unit(Dimension::length) + "³");
    io::RecordedTable table{
        "", {"body", "material", "elements", "nodes", "unknowns", "integration points", volume}, {}};
    for (const mechanics::Body& body : model_.bodies()) {
      const std::span<const double> weights = body.discretization().weights();
      table.rows.push_back(
          {body.name(), body.material().name, element_names(body.mesh()), fmt::format("{}", body.mesh().n_cell_nodes()),
           fmt::format("{}", body.constraints().n_free()), fmt::format("{}", body.discretization().n_points()),
           fmt::format("{:.6g}", std::accumulate(weights.begin(), weights.end(), 0.0))});
    }
    return {"Bodies and mesh",
            {fmt::format("Mesh file: {}. Analysis: {}.", config_.mesh.file.filename().string(),
                         settings::name_of(config_.analysis))},
            {table},
            {}};
  }

  void add_plasticity(const config::Plasticity& given, io::RecordedTable& table) const {
    const std::string stress = unit(Dimension::stress);
    if (given.yield_stress) {
      table.rows.push_back({"plasticity: yield stress", given.yield_stress->text(), stress});
      table.rows.push_back({"plasticity: hardening modulus", given.hardening_modulus.text(), stress});
    }
    for (const config::PlasticCurve& curve : given.curve)
      table.rows.push_back({curve.T ? fmt::format("plasticity: yield stress at T = {:g}", *curve.T)
                                    : std::string("plasticity: yield stress"),
                            fmt::format("{} at the plastic strains {}", fmt::join(curve.stress, ", "),
                                        fmt::join(curve.plastic_strain, ", ")),
                            stress});
    for (const config::KinematicHardening& back : given.kinematic) {
      table.rows.push_back({"plasticity: C of a back stress", back.C.text(), stress});
      table.rows.push_back({"plasticity: gamma of a back stress", back.gamma.text(), ""});
    }
  }

  static std::string conductance_text(const config::Conductance& conductance) {
    using Kind = config::Conductance::Kind;
    return conductance.kind == Kind::function    ? conductance.value.text()
           : conductance.kind == Kind::insulated ? "insulated"
                                                 : "perfect";
  }

  io::RecordedSection material(const config::Material& given) const {
    io::RecordedSection section{"Material " + given.name, {}, {}, {}};
    section.notes.push_back(given.sources.empty()
                                ? "Sources of the data: none named (key sources of the material)."
                                : fmt::format("Sources of the data: {}", fmt::join(given.sources, "; ")));
    io::RecordedTable elastic{"", {"property", "value", "unit"}, {}};
    if (given.orthotropic) {
      elastic.rows.push_back(
          {"Young's moduli E1, E2, E3", vector_text(given.orthotropic->young_moduli), unit(Dimension::stress)});
      elastic.rows.push_back({"Poisson's ratios nu12, nu23, nu13", vector_text(given.orthotropic->poisson_ratios), ""});
      elastic.rows.push_back(
          {"shear moduli G12, G23, G13", vector_text(given.orthotropic->shear_moduli), unit(Dimension::stress)});
    } else {
      elastic.rows.push_back({"Young's modulus", given.young_modulus.text(), unit(Dimension::stress)});
      elastic.rows.push_back({"Poisson's ratio", given.poisson_ratio.text(), ""});
    }
    if (given.yield_strength)
      elastic.rows.push_back({"yield strength", given.yield_strength->text(), unit(Dimension::stress)});
    if (given.plasticity) add_plasticity(*given.plasticity, elastic);
    if (given.hill) {
      elastic.rows.push_back({"Hill's ratios R11, R22, R33 of creep", vector_text(given.hill->normal), ""});
      elastic.rows.push_back({"Hill's ratios R12, R23, R13 of creep", vector_text(given.hill->shear), ""});
    }
    const std::vector<Function>& alpha = given.thermal_expansion;
    if (!std::ranges::all_of(alpha, &Function::is_zero)) {
      const std::string degree = unit(Dimension::temperature);
      elastic.rows.push_back(
          {alpha.size() == 1 ? "thermal expansion (secant)" : "thermal expansion (secant) along axes 1, 2, 3",
           alpha.size() == 1 ? alpha[0].text() : vector_text(std::array{alpha[0], alpha[1], alpha[2]}),
           degree.empty() ? "" : "1/" + degree});
      elastic.rows.push_back(
          {"reference temperature", fmt::format("{:.6g}", given.reference_temperature.value_or(0)), degree});
    }
    if (!given.conductivity.empty())
      elastic.rows.push_back({given.conductivity.size() == 1 ? "conductivity" : "conductivity along axes 1, 2, 3",
                              texts(given.conductivity), "unit of the heat data"});
    if (given.heat_capacity)
      elastic.rows.push_back({"heat capacity", given.heat_capacity->text(), "unit of the heat data"});
    if (given.density) elastic.rows.push_back({"density", fmt::format("{:.6g}", *given.density), ""});
    section.tables.push_back(elastic);
    for (const config::CreepMechanism& mechanism : given.creep) section.tables.push_back(law(mechanism));
    if (given.rupture) section.tables.push_back(rupture(*given.rupture));
    const auto body =
        std::ranges::find(model_.bodies(), given.name, [](const mechanics::Body& b) { return b.material().name; });
    if (body != model_.bodies().end())
      if (io::RecordedPlot plot = creep_curves(body->material()); !plot.curves.empty()) section.plots.push_back(plot);
    return section;
  }

  io::RecordedSection loading() const {
    io::RecordedSection section{"Supports, loads and temperature", {}, {}, {}};
    io::RecordedTable supports{"Supports", {"on", "displacement held"}, {}}, loads{"Loads", {"on", "load"}, {}};
    for (const Mark& mark : marks(config_, model_)) {
      const std::size_t colon = mark.name.find(": ");
      const std::string text = colon == std::string::npos ? mark.name : mark.name.substr(colon + 2);
      if (mark.kind == Mark::Kind::support) supports.rows.push_back({mark.group, text});
    }
    for (const config::Load& load : config_.loads) {
      const LoadWords words = load_words(load, config_, model_);
      loads.rows.push_back({words.place, words.text});
    }
    io::RecordedTable initial{"Stress before the loads", {"body", "component", label("stress", Dimension::stress)}, {}};
    for (const config::InitialStress& stress : config_.initial_stress) {
      if (stress.file) initial.rows.push_back({stress.name, "all", stress.file->filename().string()});
      for (std::size_t i = 0; i < stress.along_coordinates.size(); ++i)
        if (const Function& value = stress.along_coordinates[i]; !value.is_zero())
          initial.rows.push_back({stress.name, std::array{"xx", "yy", "zz", "xy", "yz", "zx"}[i], value.text()});
      for (std::size_t i = 0; i < stress.about_axis.size(); ++i)
        if (const Function& value = stress.about_axis[i]; !value.is_zero())
          initial.rows.push_back({stress.name, std::array{"radial", "tangential", "axial"}[i], value.text()});
    }
    for (io::RecordedTable* table : {&supports, &loads, &initial})
      if (!table->rows.empty()) section.tables.push_back(std::move(*table));
    if (temperature_) {
      section.notes.push_back(
          temperature_->low == temperature_->high
              ? fmt::format("Temperature: {} everywhere.", number(temperature_->low, Dimension::temperature))
              : fmt::format("Temperature: {:.6g} to {}.", temperature_->low,
                            number(temperature_->high, Dimension::temperature)));
      if (config_.temperature && config_.temperature->files.empty())
        section.notes.push_back(fmt::format("Temperature as given: {}", config_.temperature->value.text()));
    } else {
      section.notes.emplace_back("No temperature is given: each material is at its reference temperature.");
    }
    for (io::RecordedPlot& plot : courses()) section.plots.push_back(std::move(plot));
    return section;
  }

  /// How fast bodies follow their surfaces, and what heats them.
  io::RecordedSection heat() const {
    io::RecordedSection section{"Heat", {}, {}, {}};
    const config::Heat& given = *config_.heat;
    section.notes.push_back(fmt::format(
        "The temperature is computed, from {}{}.",
        given.start ? "T = " + given.start->text() : std::string("the steady state of the start"),
        given.time_unit ? fmt::format("; one unit of t is {:g} units of time of the heat data", *given.time_unit)
                        : ""));
    io::RecordedTable bodies{"How long a change of temperature takes to come through the bodies",
                             {"body", label("volume over surface", Dimension::length), label("time", Dimension::time)},
                             {}};
    for (std::size_t b = 0; b < model_.heat->bodies.size(); ++b)
      if (const auto [depth, time] = model_.heat->bodies[b]; depth > 0)
        bodies.rows.push_back({model_.bodies()[b].name(), fmt::format("{:.3g}", depth), fmt::format("{:.3g}", time)});
    io::RecordedTable flows{"What heats and cools", {"where", "what", "temperature beyond"}, {}};
    for (const config::HeatFilm& film : given.films)
      flows.rows.push_back({film.on.name, "film, coefficient " + film.coefficient.text(), film.fluid.text()});
    for (const config::HeatFlux& flux : given.fluxes)
      flows.rows.push_back({flux.on.name, "flux " + flux.value.text(), ""});
    for (const config::HeatRadiation& radiation : given.radiation)
      flows.rows.push_back(
          {radiation.on.name, "radiation, emissivity " + radiation.emissivity.text(), radiation.ambient.text()});
    for (const config::HeatSource& source : given.sources)
      flows.rows.push_back({"body " + source.body.name, "source " + source.value.text(), ""});
    for (const config::HeatTemperature& held : given.temperatures)
      flows.rows.push_back({held.on.name, "temperature given", held.value.text()});
    for (const config::HeatPointFlow& flow : given.point_flows)
      flows.rows.push_back({flow.on.name, "into each node " + flow.value.text(), ""});
    io::RecordedTable films{
        "Elements at films: above a Biot number of 1 temperatures undershoot after a jump of the fluid",
        {"film", "largest coefficient", label("depth of an element", Dimension::length), "element Biot number"},
        {}};
    const heat::Definition& all = *model_.assembly.conduction();
    for (const heat::FilmFigures& film : model_.heat->films)
      films.rows.push_back({all.flows[film.flow].name, fmt::format("{:.4g}", film.coefficient),
                            fmt::format("{:.3g}", film.element_size), fmt::format("{:.2g}", film.biot)});
    for (io::RecordedTable* table : {&flows, &bodies, &films})
      if (!table->rows.empty()) section.tables.push_back(std::move(*table));
    return section;
  }

  io::RecordedTable gaskets() const {
    io::RecordedTable table{"", {"gasket", "thickness", "pressure over closure", "unloading", "creep"}, {}};
    for (const config::Gasket& gasket : config_.gaskets) {
      std::vector<std::string> points;
      const config::GasketCurve& curve = gasket.loading.front();
      for (std::size_t i = 0; i < curve.closure.size(); ++i)
        points.push_back(fmt::format("{:.4g} at {:.4g}", curve.pressure[i], curve.closure[i]));
      std::string creep = gasket.relaxation
                              ? fmt::format("{:.3g} of {:.4g} left after {:.4g}", gasket.relaxation->factor,
                                            gasket.relaxation->pressure, gasket.relaxation->time)
                              : "none";
      if (!gasket.creep.empty()) creep = gasket.creep.front().law;
      table.rows.push_back({gasket.name, number(gasket.thickness, Dimension::length),
                            fmt::format("{}", fmt::join(points, ", ")),
                            gasket.unloading.empty()                ? "along the same curve"
                            : gasket.unloading.front().from.empty() ? "measured curves"
                                                                    : "moduli E_G",
                            creep});
    }
    return table;
  }

  io::RecordedSection contacts() const {
    io::RecordedSection section{"Contacts", {}, {}, {}};
    io::RecordedTable table{"", {"contact", "slave", "master", "multipliers", "gap or preload", "friction"}, {}};
    if (model_.heat) table.head.emplace_back("conductance");
    for (std::size_t p = 0; p < config_.contacts.size() && p < model_.pairs().size(); ++p) {
      const contact::Pair& pair = model_.pairs()[p];
      const config::Contact& given = config_.contacts[p];
      table.rows.push_back({pair.name,
                            fmt::format("{} ({})", pair.slave_surface, model_.bodies()[pair.slave_body].name()),
                            fmt::format("{} ({})", pair.master_surface, model_.bodies()[pair.master_body].name()),
                            fmt::format("{}", pair.coupling.nodes.size()), gap_text(given, pair),
                            given.type == config::ContactType::tied ? "tied"
                            : pair.coupling.has_friction()          ? given.friction.text()
                                                                    : "none"});
      if (model_.heat) table.rows.back().push_back(conductance_text(given.conductance));
    }
    if (!table.rows.empty()) section.tables.push_back(table);
    if (!config_.gaskets.empty()) section.tables.push_back(gaskets());
    for (const config::Cyclic& cyclic : config_.cyclic)
      section.notes.push_back(fmt::format("Cyclic symmetry: one sector of {:.6g} degrees between '{}' and '{}'.",
                                          cyclic.angle, cyclic.between[0].name, cyclic.between[1].name));
    const auto add_motions = [&](const std::vector<config::Rigid>& all, const char* what) {
      for (const config::Rigid& one : all) {
        std::vector<std::string> names;
        for (const config::Reference& on : one.on) names.push_back("'" + on.name + "'");
        section.notes.push_back(fmt::format("{}: {}.", what, fmt::join(names, ", ")));
      }
    };
    add_motions(config_.rigid, "Surfaces that move as one rigid body");
    add_motions(config_.coupling, "Surfaces whose mean motion follows a point");
    for (const config::Spring& spring : config_.springs)
      section.notes.push_back(fmt::format("Spring '{}': {}.", spring.name,
                                          spring.stiffness
                                              ? fmt::format("stiffness {:.6g}", *spring.stiffness)
                                              : fmt::format("a curve of {} points up to the force {:.6g}",
                                                            spring.curve->force.size(), spring.curve->force.back())));
    if (!config_.equations.empty())
      section.notes.push_back(fmt::format("{} linear equations tie displacements of nodes.", config_.equations.size()));
    return section;
  }

  io::RecordedSection time() const {
    io::RecordedTable table{"", {"setting", "value"}, {}};
    table.rows.push_back({"end", number(config_.time.end, Dimension::time)});
    table.rows.push_back({"integrator", config_.time.integrator});
    table.rows.push_back({"relative accuracy of the stress", fmt::format("{:.2g}", config_.time.tolerance)});
    table.rows.push_back({"output times", fmt::format("{}", config_.time.output.size())});
    if (!model_.pairs().empty())
      table.rows.push_back({"contact method", std::string(settings::name_of(config_.contact_solver.method))});
    return {"Time integration", {}, {table}, {}};
  }

 private:
  std::string unit(Dimension dimension) const { return unit_of(dimension, config_.units); }
  std::string number(double value, Dimension dimension) const {
    const std::string of = unit(dimension);
    return fmt::format("{:.6g}{}{}", value, of.empty() ? "" : " ", of);
  }
  std::string label(const std::string& name, Dimension dimension) const { return with_unit(name, unit(dimension)); }

  static io::RecordedTable law(const config::CreepMechanism& mechanism) {
    const material::LawInfo* info = material::find_creep_law(mechanism.law);
    io::RecordedTable table{fmt::format("Creep law {}: {} ({})", mechanism.law, info->formula, info->source),
                            {"constant", "value", "meaning"},
                            {}};
    for (const config::CreepParameter& parameter : mechanism.parameters) {
      if (!parameter.given) continue;
      const auto known = std::ranges::find(info->parameters, parameter.key, &material::ParameterInfo::key);
      table.rows.push_back({parameter.key, parameter.word.empty() ? texts(parameter.values) : parameter.word,
                            known == info->parameters.end() ? "" : known->description});
    }
    return table;
  }

  io::RecordedTable rupture(const config::Rupture& data) const {
    if (data.rupture_time)
      return {"Rupture", {"property", "value"}, {{label("rupture time", Dimension::time), data.rupture_time->text()}}};
    io::RecordedTable table{
        fmt::format("Rupture: Larson-Miller parameter, constant {:.6g}", data.larson_miller_constant),
        {label("stress", Dimension::stress), "parameter"},
        {}};
    for (std::size_t i = 0; i < data.stress.size(); ++i)
      table.rows.push_back({fmt::format("{:.6g}", data.stress[i]), fmt::format("{:.6g}", data.parameter[i])});
    return table;
  }

  /// Creep strain over time at stresses that the bodies of this material have at the start.
  io::RecordedPlot creep_curves(const material::Material& material) const {
    io::RecordedPlot plot{"Creep under constant stress, as the laws above say",
                          label("time", Dimension::time),
                          "creep strain",
                          true,
                          true,
                          {}};
    double largest = 0;
    for (const mechanics::Body& body : model_.bodies())
      if (const auto found = at_start_.bodies.find(body.name());
          body.material().name == material.name && found != at_start_.bodies.end())
        largest = std::max(largest, found->second.von_mises.start);
    if (!material.creeps() || !(largest > 0)) return plot;
    std::set<double> temperatures{material.reference_temperature};
    if (temperature_) temperatures = {temperature_->low, temperature_->high};
    for (const double temperature : temperatures)
      for (const double level : levels) {
        const double stress = std::stod(fmt::format("{:.2g}", level * largest));
        const material::CreepCurve curve =
            material::creep_curve(material, {.stress = stress, .temperature = temperature, .end = config_.time.end});
        io::RecordedCurve kept{number(stress, Dimension::stress), {}, {}};
        if (temperatures.size() > 1)
          kept.name += ", " + number(std::stod(fmt::format("{:.4g}", temperature)), Dimension::temperature);
        const std::size_t every = std::max<std::size_t>(1, curve.time.size() / curve_points);
        for (std::size_t i = 0; i < curve.time.size(); ++i)
          if ((i % every == 0 || i + 1 == curve.time.size()) && curve.strain[i] >= least_strain) {
            kept.x.push_back(curve.time[i]);
            kept.y.push_back(curve.strain[i]);
          }
        if (!kept.x.empty()) plot.curves.push_back(std::move(kept));
      }
    return plot;
  }

  /// Equidistant times and all breakpoints, where functions jump or turn.
  std::vector<double> times(std::size_t n) const {
    std::set<double> all;
    for (std::size_t i = 0; i <= n; ++i) all.insert(config_.time.end * static_cast<double>(i) / static_cast<double>(n));
    std::size_t kept = 0;
    for (const double t : model_.breakpoints) {
      if (t > config_.time.end || ++kept > 5 * n) break;
      all.insert({std::max(0.0, t * (1 - 1e-9)), t});
    }
    return {all.begin(), all.end()};
  }

  /// "gap [mm]" of "contacts[0].gap"
  std::string label_of_key(const std::string& key) const {
    static const std::map<std::string, Dimension> dimensions{
        {"pressure", Dimension::stress},        {"traction", Dimension::stress}, {"force", Dimension::force},
        {"moment", Dimension::moment},          {"gap", Dimension::length},      {"displacement", Dimension::length},
        {"temperature", Dimension::temperature}};
    for (const auto& [word, dimension] : dimensions)
      if (key.find(word) != std::string::npos) return label(word, dimension);
    return key.substr(key.rfind('.') + 1);
  }

  /// Functions of time alone, and the range of a temperature that changes.
  std::vector<io::RecordedPlot> courses() const {
    std::vector<io::RecordedPlot> plots;
    for (const config::ConfiguredFunction& function : config::functions(config_)) {
      if (!function.value.depends_on_time() || function.value.depends_on_position()) continue;
      if (!function.is_of_position_and_time()) continue;
      io::RecordedCurve curve{function.key, {}, {}};
      for (const double t : times(samples)) {
        const double value = function.value({.t = t});
        if (!std::isfinite(value)) continue;
        curve.x.push_back(t);
        curve.y.push_back(value);
      }
      plots.push_back(
          {function.key, label("time", Dimension::time), label_of_key(function.key), false, false, {std::move(curve)}});
    }
    if (model_.temperature && model_.temperature->depends_on_time() && model_.temperature->depends_on_position())
      plots.push_back(temperature_course());
    return plots;
  }

  io::RecordedPlot temperature_course() const {
    constexpr std::size_t most_positions = 2000, few_times = 40;
    std::vector<Vector3> positions;
    for (const mechanics::Body& body : model_.bodies()) {
      const std::size_t every = 1 + body.mesh().n_cell_nodes() * model_.bodies().size() / most_positions;
      for (std::size_t i = 0; i < body.mesh().n_cell_nodes(); i += every) positions.push_back(body.mesh().nodes[i]);
    }
    const auto field = model_.temperature->at(positions);
    mechanics::TemperatureMemo memo;
    std::vector<double> values(positions.size());
    io::RecordedCurve coldest{"coldest place", {}, {}}, hottest{"hottest place", {}, {}};
    for (const double t : times(few_times)) {
      field->evaluate(t, values, memo);
      const auto [low, high] = std::ranges::minmax(values);
      if (!std::isfinite(low) || !std::isfinite(high)) continue;
      coldest.x.push_back(t);
      coldest.y.push_back(low);
      hottest.x.push_back(t);
      hottest.y.push_back(high);
    }
    return {"Temperature", label("time", Dimension::time),          label("temperature", Dimension::temperature), false,
            false,         {std::move(hottest), std::move(coldest)}};
  }

  const config::Config& config_;
  const model::Model& model_;
  const io::Summary& at_start_;
  std::optional<Interval> temperature_;
};

std::vector<io::RecordedField> fields(const std::string& units) {
  std::vector<io::RecordedField> all;
  for (const results::Quantity& quantity : results::quantities()) {
    const results::OutputVariable& variable = *quantity.variable;
    const bool is_on_contact = variable.is<results::AtMultipliers>();
    if (variable.point_array.empty() && !is_on_contact) continue;
    io::RecordedField field{quantity.name,
                            variable.label,
                            unit_of(variable.dimension, units),
                            is_on_contact ? variable.name : variable.point_array,
                            quantity.component,
                            is_on_contact};
    if (quantity.name.ends_with("_equivalent")) field.label = "equivalent " + field.label;
    if (!variable.components.empty())
      field.label += ' ' + variable.components[static_cast<std::size_t>(quantity.component)];
    const bool is_first_of_vector = variable.point_array == "displacement" && quantity.component == 0;
    if (is_first_of_vector)
      all.push_back({"displacement_magnitude", "displacement", field.unit, field.array, -1, false});
    all.push_back(std::move(field));
  }
  return all;
}

/// What tells runs apart. Long values, such as tables of data, by their beginning and a checksum.
std::vector<io::RecordedInput> inputs(const config::Config& config) {
  constexpr std::size_t longest = 300, kept = 60;
  std::vector<io::RecordedInput> all;
  for (const config::ConfiguredValue& value : config::all_values(config)) {
    if (value.key.starts_with("report.") || value.key.starts_with("output.")) continue;
    io::RecordedInput input{value.key, value.text};
    if (value.text.size() > longest) {
      Checksum sum;
      sum.add(value.text.data(), value.text.size());
      input.value = fmt::format("{}... (checksum {:016x})", value.text.substr(0, kept), sum.value());
    }
    all.push_back(std::move(input));
  }
  return all;
}

}  // namespace

std::string element_names(const mesh::Mesh& mesh) {
  std::string text;
  for (const mesh::CellBlock& block : mesh.blocks)
    if (mesh.is_bulk(block.type) && block.size() > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", block.size(), mesh::name(block.type));
  return text;
}

io::RecordedReport recorded_report(const config::Config& config) {
  const config::Report& given = config.report;
  io::RecordedReport report{.title = given.title,
                            .project = given.project,
                            .drawing = given.drawing,
                            .revision = given.revision,
                            .author = given.author,
                            .checker = given.checker,
                            .logo_file = given.logo.filename().string(),
                            .purpose = given.purpose,
                            .assumptions = given.assumptions,
                            .assessment = given.assessment,
                            .appendix = given.appendix};
  if (!given.logo.empty()) report.logo = base64(read_image(given.logo).bytes);
  for (const config::ReportPicture& picture : given.pictures) {
    io::RecordedPicture& kept = report.pictures.emplace_back();
    kept.field = picture.field;
    kept.time = picture.time;
    kept.view = picture.view;
    if (picture.range) kept.range = {picture.range->low, picture.range->high};
    if (picture.section) {
      const auto& [origin, normal] = *picture.section;
      kept.section = {origin[0], origin[1], origin[2], normal[0], normal[1], normal[2]};
    }
  }
  return report;
}

io::ModelRecord model_record(const config::Config& config, const model::Model& model, const io::Summary& at_start) {
  const Recorder recorder(config, model, at_start);
  io::ModelRecord record{CREEPCONTACT_VERSION, now(), config.file.string(),    short_fingerprint(config, model),
                         fields(config.units), {},    recorded_report(config), inputs(config)};
  record.sections.push_back(recorder.mesh());
  for (const config::Material& material : config.materials)
    if (std::ranges::any_of(model.bodies(),
                            [&](const mechanics::Body& body) { return body.material().name == material.name; }))
      record.sections.push_back(recorder.material(material));
  if (io::RecordedSection contacts = recorder.contacts(); !contacts.tables.empty() || !contacts.notes.empty())
    record.sections.push_back(std::move(contacts));
  record.sections.push_back(recorder.loading());
  if (model.heat) record.sections.push_back(recorder.heat());
  record.sections.push_back(recorder.time());
  return record;
}

}  // namespace creepcontact::run
