/// The derivatives of probes and event times: sensitivity.csv and the summary.
#include <fmt/format.h>

#include <algorithm>
#include <array>
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

constexpr double min_change_of_events = 1e-9;  // of their times, by a typical change of the value: rounding

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

  /// Probes and their derivatives on one side of a time, where they are smooth: three states, at 1, 2 and 3 distances.
  struct Side {
    double distance;  // < 0 before the time
    std::array<std::vector<double>, 3> probes;
    std::array<std::vector<Derivatives::OfProbes>, 2> of_values;

    /// The probes so much later than the time, with so much more of value k: quadratic in time, linear in the value.
    std::vector<double> values(std::size_t k, double later, double change) const {
      const double x = later / distance - 1;  // from the first state, in distances
      std::vector<double> result(probes[0].size());
      for (std::size_t p = 0; p < result.size(); ++p) {
        const double first = probes[1][p] - probes[0][p], second = probes[2][p] - 2 * probes[1][p] + probes[0][p];
        const double near = of_values[0][k].derivatives[p], far = of_values[1][k].derivatives[p];
        result[p] = probes[0][p] + x * first + x * (x - 1) / 2 * second + change * (near + x * (far - near));
      }
      return result;
    }
  };

  Side side_of(double time, double distance) const {
    const auto before = [&](double distances) { return integrator_.whole_at(time - distances * std::abs(distance)); };
    const std::vector<double> here = before(0), near = before(1), far = before(2);
    Side side{.distance = distance, .probes = {}, .of_values = {}};
    for (std::size_t i = 0; i < side.probes.size(); ++i) {
      const auto n = static_cast<double>(i + 1);
      const double ahead = n * distance;
      std::vector<double> whole = ahead < 0 ? before(n) : here;
      if (ahead > 0)  // by a parabola, since the step may end before
        for (std::size_t j = 0; j < whole.size(); ++j)
          whole[j] += n * (here[j] - near[j]) + n * (n + 1) / 2 * (here[j] - 2 * near[j] + far[j]);
      side.probes[i] = probes_at(time + ahead, of_.block(std::span<const double>(whole), 0));
      if (i < side.of_values.size()) side.of_values[i] = of_.of_probes(time + ahead, whole);
    }
    return side;
  }

  struct ChangesOfEvent {
    std::vector<double> changes;  // with each value; NaN: not known
    double largest = 0;           // of them
    bool differ = false;          // by the probes before and after the event
  };

  ChangesOfEvent changes_by_sides(std::size_t event, double time, double distance) const {
    constexpr double same = 1e-3;
    const double step = integrator_.time() - integrator_.begin_of_step();
    const Side before = side_of(time, -distance), after = side_of(time, distance);
    ChangesOfEvent found;
    for (std::size_t k = 0; k < of_.values().size(); ++k) {
      const auto change_by = [&](const Side& side) {
        const auto delay_with = [&](double change) {
          return delay(step,
                       [&](double later) { return watch().holds(event, side.values(k, later, change), time + later); });
        };
        return central_difference(delay_with(relative_change), delay_with(-relative_change));
      };
      const double by_before = change_by(before), by_after = change_by(after);
      const bool knows_both = !std::isnan(by_before) && !std::isnan(by_after);
      found.changes.push_back(knows_both ? (by_before + by_after) / 2 : std::isnan(by_before) ? by_after : by_before);
      const double largest = std::fmax(std::abs(by_before), std::abs(by_after));
      found.largest = std::fmax(found.largest, largest);
      found.differ = found.differ || (knows_both && std::abs(by_before - by_after) > same * largest &&
                                      largest > min_change_of_events * time);
    }
    return found;
  }

  /// How the time of an event changes with each value; NaN: not known, because it happens at a jump of the loads.
  /// The condition tells when it holds with a little more and a little less of the value, by the probes before the
  /// event, and by those after it: where a node closes or opens at the event, only one of them tells, or both differ.
  /// @param time  of the event, within the last step
  std::vector<double> changes_of_event(std::size_t event, double time) {
    constexpr double smallest_part = 1e-7;  // of the step
    const double step = integrator_.time() - integrator_.begin_of_step();
    const creep::CreepSystem& system = of_.base();
    const double most = std::min(time - std::max(integrator_.begin_of_step(), system.begin_of_segment()),
                                 system.end_of_segment() - time) /
                        4;
    double distance = std::min(1e-3 * step, most);
    if (!(distance > 0)) return std::vector<double>(of_.values().size(), std::numeric_limits<double>::quiet_NaN());
    ChangesOfEvent found = changes_by_sides(event, time, distance);
    // Nearer states may lie on the same side of a kink; nearer still, rounding counts.
    while (found.differ && distance > smallest_part * step) found = changes_by_sides(event, time, distance /= 100);
    // Models with more and less of a value must be on the same side, too.
    double shift = of_.are_differences() ? relative_change * found.largest : 0;
    if (shift > distance / 2) {
      found = changes_by_sides(event, time, distance = std::min(2 * shift, most));
      shift = relative_change * found.largest;
    }
    const bool differ = found.differ || shift > distance;
    if (differ)
      log::warning(
          "sensitivity: at the event '{}', t = {:.6g}, the probes change their course, as where a node closes or opens "
          "or a point yields: the derivatives of its time are means of those before and after it",
          context_.config.events[event].name, time);
    return std::move(found.changes);
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
