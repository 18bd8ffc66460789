/// The derivatives of probes and event times: sensitivity.csv and the summary.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "../sensitivity/sensitive_integrator.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/io/tables/history_writer.hpp"
#include "creepcontact/run/summary.hpp"
#include "event_conditions.hpp"

namespace creepcontact::run {
namespace {

class Sensitivities final : public EventConditions {
 public:
  explicit Sensitivities(const RunContext& context)
      : EventConditions(context),
        context_(context),
        integrator_(*context.sensitive),
        of_(integrator_.of()),
        changes_of_events_(context.config.events.size()),
        has_warned_(of_.values().size(), false) {
    if (context.directory.empty()) return;
    std::vector<std::string> names;
    for (const config::Probe& probe : context.config.probes)
      for (const ChangedValue& value : of_.values()) names.push_back(fmt::format("d_{}__{}", probe.name, value.key));
    file_.emplace(context.directory / "sensitivity.csv", names,
                  io::Continuation{.resume = context.resumed != nullptr, .last_time = context.begin},
                  context.config.output.csv);
  }

  void output(StepView& view) override {
    differentiate(view);
    if (!file_ || (context_.resumed != nullptr && view.time() <= context_.begin)) return;
    std::vector<double> row;
    row.reserve(context_.config.probes.size() * of_.values().size());
    for (std::size_t p = 0; p < context_.config.probes.size(); ++p)
      for (std::size_t k = 0; k < of_.values().size(); ++k) row.push_back(derivatives_[k][p] / of_.values()[k].change);
    file_->write(view.time(), row);
  }

  void happened(std::size_t number, StepView& view) override {
    changes_of_events_[number] = changes_of_event(number, view.time());
  }

  void save(creep::Memory& memory) const override {
    memory["sensitivity.state"] = integrator_.derivatives();
    memory.save("sensitivity.events", changes_of_events_);
    of_.save(memory);
  }
  void restore(const creep::Memory& memory) override {
    std::vector<double> derivatives;
    memory.restore("sensitivity.state", derivatives);
    integrator_.set_derivatives(derivatives);
    memory.restore("sensitivity.events", changes_of_events_);
    of_.restore(memory);
  }

  void finish(Summary& summary) const override {
    summary.results.sensitivities.clear();
    for (std::size_t k = 0; k < of_.values().size(); ++k) {
      const ChangedValue& value = of_.values()[k];
      io::Summary::Sensitivity one{.key = value.key, .value = value.value, .change = value.change};
      for (std::size_t p = 0; p < context_.config.probes.size() && !derivatives_.empty(); ++p)
        one.probes[context_.config.probes[p].name] = derivatives_[k][p] / value.change;
      for (std::size_t e = 0; e < changes_of_events_.size(); ++e)
        if (!changes_of_events_[e].empty() && std::isfinite(changes_of_events_[e][k]))
          one.events[context_.config.events[e].name] = changes_of_events_[e][k] / value.change;
      summary.results.sensitivities.push_back(std::move(one));
    }
  }

 private:
  bool is_waiting(std::size_t event) const override { return changes_of_events_[event].empty(); }

  /// The derivatives of all probes in a state of the run.
  void differentiate(StepView& view) {
    std::vector<Derivatives::OfProbes> found = of_.of_probes(view.time(), integrator_.whole_at(view.time()));
    derivatives_.clear();
    for (std::size_t k = 0; k < found.size(); ++k) {
      derivatives_.push_back(std::move(found[k].derivatives));
      if (!found[k].is_one_sided || has_warned_[k]) continue;
      has_warned_[k] = true;
      log::warning(
          "sensitivity: at t = {:.6g} other nodes are in contact with a little more than with a little less of '{}': "
          "where that is so, derivatives are means of two one-sided ones, or one of them; it is not said again",
          view.time(), of_.values()[k].key);
    }
  }

  /// The probes of the run in a state of it.
  std::vector<double> probes_at(double t, std::span<const double> y) const {
    creep::CreepSystem& system = of_.base();
    results::Snapshot snapshot(system, t, system.evaluate_output(t, y));
    return results::probe_values(context_.observed.probes(), snapshot);
  }

  /// How fast the probes change in a state of the run, within a segment of smooth loads; empty: not known.
  std::vector<double> rates_of_probes(double t, std::span<const double> y) const {
    constexpr double part = 1e-3;  // of the step
    creep::CreepSystem& system = of_.base();
    const double dt = std::min({part * (integrator_.time() - integrator_.begin_of_step()),
                                (t - system.begin_of_segment()) / 2, (system.end_of_segment() - t) / 2});
    if (!(dt > 0)) return {};
    const std::vector<double> rate = system.rate_of(system.evaluate_output(t, y));
    const auto probes_after = [&](double duration) {
      std::vector<double> there(y.begin(), y.end());
      for (std::size_t i = 0; i < there.size(); ++i) there[i] += duration * rate[i];
      return probes_at(t + duration, there);
    };
    std::vector<double> later = probes_after(dt);
    const std::vector<double> earlier = probes_after(-dt);
    for (std::size_t p = 0; p < later.size(); ++p) later[p] = (later[p] - earlier[p]) / (2 * dt);
    return later;
  }

  /// How the time of an event changes with each value; NaN: not known, because it happens at a jump of the loads.
  /// The probes are taken to be linear in the time and the value near the event: its condition then tells when it holds
  /// with a little more and a little less of the value. @param time  of the event, within the last step
  std::vector<double> changes_of_event(std::size_t event, double time) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> changes(of_.values().size(), unknown);
    if (!(time > integrator_.begin_of_step())) return changes;
    const std::vector<double> whole = integrator_.whole_at(time);
    const std::span<const double> y = of_.block(std::span<const double>(whole), 0);
    const std::vector<double> rates = rates_of_probes(time, y);
    if (rates.empty()) return changes;
    const std::vector<double> probes = probes_at(time, y);
    const std::vector<Derivatives::OfProbes> of_values = of_.of_probes(time, whole);
    const double step = integrator_.time() - integrator_.begin_of_step();
    for (std::size_t k = 0; k < changes.size(); ++k) {
      const auto delay_with = [&](double change) {
        return delay(step, [&](double later) {
          std::vector<double> values(probes.size());
          for (std::size_t p = 0; p < values.size(); ++p)
            values[p] = probes[p] + later * rates[p] + change * of_values[k].derivatives[p];
          return watch().holds(event, values, time + later);
        });
      };
      changes[k] = central_difference(delay_with(relative_change), delay_with(-relative_change));
    }
    return changes;
  }

  /// When a condition begins to hold; NaN: not within `most` before and after. @param holds  at so much later
  static double delay(double most, const std::function<bool(double later)>& holds) {
    constexpr double first = 1e-12, growth = 8;
    double reach = first * most;
    while (reach <= most && (holds(-reach) || !holds(reach))) reach *= growth;
    if (reach > most) return std::numeric_limits<double>::quiet_NaN();
    double before = -reach, after = reach;
    for (int halvings = 0; halvings < std::numeric_limits<double>::digits; ++halvings) {
      const double middle = before + (after - before) / 2;
      (holds(middle) ? after : before) = middle;
    }
    return after;
  }

  const RunContext& context_;
  SensitiveIntegrator& integrator_;
  Derivatives& of_;
  std::optional<io::HistoryWriter> file_;
  std::vector<std::vector<double>> derivatives_;        // by value, of the probes at the last output, per value/change
  std::vector<std::vector<double>> changes_of_events_;  // by event, of its time; empty: it has not happened
  std::vector<bool> has_warned_;                        // by value
};

}  // namespace

std::unique_ptr<Observer> observe_sensitivities(const RunContext& context) {
  if (context.sensitive == nullptr) return nullptr;
  return std::make_unique<Sensitivities>(context);
}

}  // namespace creepcontact::run
