#include "start_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/units.hpp"
#include "creepcontact/results/contact_values.hpp"
#include "creepcontact/results/contact_width.hpp"
#include "creepcontact/results/criteria.hpp"
#include "creepcontact/results/heat_flows.hpp"
#include "creepcontact/results/outcome.hpp"
#include "creepcontact/results/small_strain_monitor.hpp"
#include "heat_lines.hpp"
#include "preparation.hpp"

namespace creepcontact::run {
namespace {

constexpr double touching = 1e-9;  // a gap relative to the size of the elements

/// The state of one contact in a few numbers.
struct ContactStart {
  double force = 0, peak = 0, slip = 0;
  bool touches = false;  ///< some node is closed
};

ContactStart contact_start(const contact::Pair& pair, const creep::Equilibrium& at) {
  ContactStart start{.force = results::normal_force(pair, at.contact.multiplier)};
  const results::PairValues values(pair, at);
  for (std::size_t i = 0; i < pair.coupling.nodes.size(); ++i) {
    const results::ContactValues here = values[i];
    start.touches = start.touches || here.gap <= touching * std::sqrt(pair.coupling.area[i]);
    start.peak = std::max(start.peak, here.pressure);
    start.slip = std::max(start.slip, here.slip);
  }
  return start;
}

class StartReport {
 public:
  StartReport(const config::Config& config, const model::Model& model, const Processes& processes)
      : config_(config),
        model_(model),
        solver_(make_solver(config, model, model.assembly, processes, watch_)),
        system_(make_system(config, model, solver_, watch_)),
        at_(solved(model)) {}

  std::string text() {
    std::string text = "start (t = 0):\n";
    const creep::Assembly& assembly = solver_.assembly();
    const std::optional<creep::Equilibrium> finer = with_finer_substeps();
    for (const contact::Pair& pair : assembly.pairs())
      if (!pair.ties_nodes()) text += contact_lines(pair, finer);
    for (const std::string& warning : results::narrow_contacts(assembly, at_.equilibrium, "at the start"))
      text += "  warning: " + warning + "\n";
    results::SmallStrainMonitor strains(system_);
    strains.observe(0, at_);
    for (const std::string& warning : strains.warnings()) text += "  warning: " + warning + "\n";
    const auto relaxation = system_.initial_relaxation(at_, config_.time.end);
    for (std::size_t b = 0; b < assembly.bodies().size(); ++b) text += body_line(b, relaxation[b]);
    if (has_yielded()) text += flow_line(finer);
    return text + heat_text() + criteria_text();
  }

 private:
  /// As the time loop begins.
  const creep::Evaluation& solved(const model::Model& model) {
    const auto first = std::ranges::upper_bound(model.breakpoints, 0.0);
    constexpr double never = std::numeric_limits<double>::infinity();
    const std::vector<double> y = system_.initial_state();
    try {
      const auto integrator = make_integrator(config_, model, system_, system_);
      system_.begin_segment(-never, first != model.breakpoints.end() ? *first : config_.time.end);
      system_.evaluate_output(0, y);
      integrator->initialize(0, y);
      if (system_.team().any(system_.size() > 0) && system_.singular_rate() == nullptr) {
        std::vector<double> rate(system_.size());
        system_.rate(0, y, rate);
      }
      return system_.evaluate_output(0, y);
    } catch (const RecoverableError& error) {
      throw SolverError(error.what());
    }
  }

  /// Where the path of the loads counts; nullopt also where the finer one finds no state.
  std::optional<creep::Equilibrium> with_finer_substeps() {
    if (!system_.has_friction() && !has_yielded()) return std::nullopt;
    const std::vector<mechanics::CreepStrainView> no_creep(solver_.assembly().bodies().size());
    creep::Equilibrium finer;
    try {
      const creep::History history = solver_.initial_history(2 * config_.contact_solver.initial_substeps);
      solver_.solve(0, no_creep, history, finer);
    } catch (const Error&) {
      return std::nullopt;
    }
    return finer;
  }

  /// Those that count at the start.
  std::string criteria_text() {
    if (config_.criteria.empty()) return "";
    const auto probes = results::make_probes(config_, model_);
    results::CriteriaWatch watch(config_, model_, probes);
    results::Snapshot snapshot(system_, 0, at_);
    watch.judge(0, watch.findings(snapshot));
    io::Summary summary;
    watch.fill(summary);
    std::string text;
    for (const auto& [name, criterion] : summary.criteria)
      if (criterion.met) text += "  " + results::criterion_line(name, criterion) + "\n";
    return text;
  }

  /// Where heat depends on contact: what flows, and how strongly they act on each other.
  std::string heat_text() {
    if (solver_.assembly().heat() == nullptr) return "";
    std::string text;
    if (solver_.assembly().heat()->start_is_steady) {
      results::Snapshot snapshot(system_, 0, at_);
      results::HeatFlows flows(solver_.assembly());
      text = "  steady heat, per time of its data\n" + balance_lines(recorded(flows, snapshot));
    }
    const std::vector<double> y = at_.y;
    if (const auto gain = system_.loop_gain(0, y))
      text += fmt::format("  loop gain of contact and heat: {:.2g}{}\n", *gain,
                          *gain > large_loop_gain ? loop_gain_warning : "");
    return text;
  }

  std::vector<double> plastic_strain(std::size_t b) const {
    return system_.laws().evaluate(material::plastic_strain_equivalent, b, at_, at_.y);
  }

  bool has_yielded() const {
    bool any = false;
    for (std::size_t b = 0; b < solver_.assembly().bodies().size(); ++b)
      any = any || std::ranges::any_of(plastic_strain(b), [](double p) { return p > 0; });
    return system_.team().any(any);
  }

  /// What the load path of the plastic strains leaves uncertain.
  std::string flow_line(const std::optional<creep::Equilibrium>& finer) const {
    const int substeps = config_.contact_solver.initial_substeps;
    if (!finer) return fmt::format("  no state was found with contact_solver.initial_substeps = {}\n", 2 * substeps);
    double change = 0, largest = 0;
    for (std::size_t b = 0; b < finer->bodies.size(); ++b) {
      const std::vector<double>&coarse = at_.equilibrium.bodies[b].stress, &fine = finer->bodies[b].stress;
      for (std::size_t p = 0; 6 * p < coarse.size(); ++p) {
        const tensor::ConstMap of_coarse = tensor::view(coarse, p), of_fine = tensor::view(fine, p);
        change = std::max(change, tensor::von_mises(Tensor6(of_fine - of_coarse)));
        largest = std::max(largest, tensor::von_mises(of_coarse));
      }
    }
    return fmt::format(
        "  plastic strain: contact_solver.initial_substeps = {} instead of {} changes the stress by up to {:.2g} % of "
        "the largest\n",
        2 * substeps, substeps, 100 * change / largest);
  }

  std::string with_unit(double value, Dimension dimension) const {
    return creepcontact::with_unit(value, dimension, config_.units);
  }

  std::string contact_lines(const contact::Pair& pair, const std::optional<creep::Equilibrium>& finer) const {
    const ContactStart start = contact_start(pair, at_.equilibrium);
    const bool tied = pair.coupling.type == contact::ContactType::tied;
    std::string text = fmt::format("  contact '{}': ", pair.name);
    if (!tied && !(start.force > results::round_off_force(solver_.assembly(), pair)))
      return text + (start.touches ? "touches, no force\n" : "open, no force\n");
    text += fmt::format("normal force {}, peak pressure {}", with_unit(start.force, Dimension::force),
                        with_unit(start.peak, Dimension::stress));
    if (tied) return text + " (tied; tension is negative)\n";
    if (const auto width = results::elements_across(solver_.assembly(), pair, at_.equilibrium))
      text +=
          fmt::format(", contact zone about {} slave element{} wide at its narrowest", *width, *width == 1 ? "" : "s");
    else
      text += ", the whole surface is in contact";
    if (!pair.coupling.has_friction()) return text + "\n";
    text += fmt::format(", largest slip {}\n", with_unit(start.slip, Dimension::length));
    const int substeps = config_.contact_solver.initial_substeps;
    if (!finer)
      return text + fmt::format("    no state was found with contact_solver.initial_substeps = {}\n", 2 * substeps);
    const ContactStart other = contact_start(pair, *finer);
    const auto change = [](double from, double to) {
      constexpr double noticed = 1e-4;
      if (std::abs(to - from) <= noticed * std::abs(from)) return std::string("less than 0.01 %");
      return fmt::format("{:+.2g} %", 100 * (to / from - 1));
    };
    return text + fmt::format(
                      "    contact_solver.initial_substeps = {} instead of {} changes the normal force by {}, the peak "
                      "pressure by {}, the largest slip by {}\n",
                      2 * substeps, substeps, change(start.force, other.force), change(start.peak, other.peak),
                      change(start.slip, other.slip));
  }

  std::string body_line(std::size_t b, const std::optional<creep::RelaxationTime>& relaxation) const {
    const mechanics::Body& body = solver_.assembly().bodies()[b];
    const std::vector<double>& stress = at_.equilibrium.bodies[b].stress;
    double largest = 0;
    std::size_t where = 0;
    for (std::size_t p = 0; 6 * p < stress.size(); ++p)
      if (const double here = tensor::von_mises(tensor::view(stress, p)); here > largest) largest = here, where = p;
    std::string text =
        fmt::format("  body '{}': largest von Mises stress {}", body.name(), with_unit(largest, Dimension::stress));
    if (largest > 0) {
      const Vector3& x = body.discretization().point_coordinates()[where];
      text += fmt::format(" at ({:.6g}, {:.6g}, {:.6g})", x.x(), x.y(), x.z());
    }
    const std::vector<double> flow = plastic_strain(b);
    const double flowed = flow.empty() ? 0 : *std::ranges::max_element(flow);
    if (flowed > 0) text += fmt::format("; yields, largest plastic strain {:.3g}", flowed);
    if (relaxation || !(flowed > 0)) text += relaxation_text(relaxation);
    text += "\n";
    if (const auto share = results::largest_yield_share(body, at_.equilibrium.conditions[b], stress))
      text += fmt::format("  body '{}': the von Mises stress reaches {:.3g} of the yield strength{}\n", body.name(),
                          *share, *share > 1 && !(flowed > 0) ? ": the body yields" : "");
    return text;
  }

  std::string relaxation_text(const std::optional<creep::RelaxationTime>& relaxation) const {
    if (!relaxation) return ", elastic";
    const double end = config_.time.end;
    if (std::isnan(relaxation->whole)) return ", no stress that would relax";
    if (!std::isfinite(relaxation->fastest))
      return "; at this stress and temperature its creep never comes up to the elastic strain";
    const auto of_end = [&](double time) {
      return fmt::format("{} ({:.2g} time.end)", with_unit(time, Dimension::time), time / end);
    };
    const std::string whole = std::isfinite(relaxation->whole) ? "; relaxes within " + of_end(relaxation->whole)
                                                               : std::string("; does not relax as a whole");
    const Vector3& x = relaxation->place;
    return whole + fmt::format(", fastest within {} at ({:.6g}, {:.6g}, {:.6g})", of_end(relaxation->fastest), x.x(),
                               x.y(), x.z());
  }

  const config::Config& config_;
  const model::Model& model_;
  Stopwatch watch_;
  creep::EquilibriumSolver solver_;
  creep::CreepSystem system_;
  const creep::Evaluation& at_;
};

}  // namespace

std::string start_report(const config::Config& config, const model::Model& model, const Processes& processes) {
  return StartReport(config, model, processes).text();
}

}  // namespace creepcontact::run
