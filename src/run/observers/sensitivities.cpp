/// The derivatives of probes and event times: sensitivity.csv and the summary.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "../sensitivity/sensitive_integrator.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/io/tables/history_writer.hpp"
#include "creepcontact/results/event_watch.hpp"
#include "creepcontact/run/summary.hpp"
#include "observers.hpp"

namespace creepcontact::run {
namespace {

class Sensitivities final : public Observer {
 public:
  explicit Sensitivities(const RunContext& context)
      : context_(context),
        integrator_(*context.sensitive),
        variants_(integrator_.variants()),
        watch_(context.config, context.observed.probes()),
        changes_of_events_(context.config.events.size()),
        has_warned_(variants_.n_values(), false) {
    for (const auto& variant : variants_.all()) {
      const ChangedValue& value = variants_.values()[variant->value()];
      watches_.emplace_back(variant->sign() > 0 ? value.more : value.less, variant->probes());
    }
    if (context.directory.empty()) return;
    std::vector<std::string> names;
    for (const config::Probe& probe : context.config.probes)
      for (const ChangedValue& value : variants_.values())
        names.push_back(fmt::format("d_{}__{}", probe.name, value.key));
    file_.emplace(context.directory / "sensitivity.csv", names,
                  io::Continuation{.resume = context.resumed != nullptr, .last_time = context.begin},
                  context.config.output.csv);
  }

  void output(StepView& view) override {
    differentiate(view);
    if (!file_ || (context_.resumed != nullptr && view.time() <= context_.begin)) return;
    std::vector<double> row;
    row.reserve(context_.config.probes.size() * variants_.n_values());
    for (std::size_t p = 0; p < context_.config.probes.size(); ++p)
      for (std::size_t k = 0; k < variants_.n_values(); ++k)
        row.push_back(derivatives_[k][p] / variants_.values()[k].change);
    file_->write(view.time(), row);
  }

  std::vector<std::size_t> conditions(StepView& view) const override {
    if (changes_of_events_.empty()) return {};
    std::vector<std::size_t> numbers;
    view.with_snapshot([&](results::Snapshot& snapshot) {
      numbers = watch_.holding(snapshot);
      return std::vector<double>{};
    });
    std::erase_if(numbers, [&](std::size_t number) { return !changes_of_events_[number].empty(); });
    return numbers;
  }
  bool holds(std::size_t number, StepView& view) const override {
    return !view.with_snapshot([&](results::Snapshot& snapshot) {
                  return std::vector<double>(watch_.holds(number, snapshot) ? 1 : 0);
                })
                .empty();
  }
  void happened(std::size_t number, StepView& view) override {
    changes_of_events_[number] = changes_of_event(number, view.time());
  }

  void save(creep::Memory& memory) const override {
    memory.save("sensitivity.state", integrator_.derivatives());
    memory.save("sensitivity.events", changes_of_events_);
    for (const auto& variant : variants_.all()) {
      creep::Memory own;
      variant->save(own);
      memory.add(name_of(*variant), std::move(own));
    }
  }
  void restore(const creep::Memory& memory) override {
    std::vector<double> derivatives;
    memory.restore("sensitivity.state", derivatives);
    integrator_.set_derivatives(derivatives);
    memory.restore("sensitivity.events", changes_of_events_);
    for (const auto& variant : variants_.all()) variant->restore(memory.part(name_of(*variant)));
  }

  void finish(Summary& summary) const override {
    summary.results.sensitivities.clear();
    for (std::size_t k = 0; k < variants_.n_values(); ++k) {
      const ChangedValue& value = variants_.values()[k];
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
  static std::string name_of(const Variant& variant) {
    return fmt::format("sensitivity.variant{}", Variants::index_of(variant));
  }

  /// The derivatives of all probes in a state of the run.
  void differentiate(StepView& view) {
    struct Values {
      std::vector<double> probes;
      std::vector<std::int64_t> closed;
    };
    std::vector<Values> values(variants_.all().size());
    const std::vector<double> whole = integrator_.whole_at(view.time());
    variants_.for_each(whole, [&](Variant& variant, std::span<const double> y) {
      Values& own = values[Variants::index_of(variant)];
      own.probes = variant.with_snapshot(view.time(), y, [&](results::Snapshot& snapshot) {
        return results::probe_values(variant.probes(), snapshot);
      });
      const auto& active = variant.system().evaluate_output(view.time(), y).equilibrium.contact.active;
      own.closed.assign(active.begin(), active.end());
    });
    derivatives_.assign(variants_.n_values(), {});
    for (std::size_t k = 0; k < variants_.n_values(); ++k) {
      const Values &more = values[2 * k], &less = values[2 * k + 1];
      for (std::size_t p = 0; p < more.probes.size(); ++p)
        derivatives_[k].push_back(Variants::derivative(more.probes[p], less.probes[p]));
      if (more.closed == less.closed || has_warned_[k]) continue;
      has_warned_[k] = true;
      log::warning(
          "sensitivity: at t = {:.6g} other nodes are in contact with a little more than with a little less of '{}': "
          "where that is so, derivatives are means of two one-sided ones; it is not said again",
          view.time(), variants_.values()[k].key);
    }
  }

  /// How the time of an event changes with each value; NaN: not known, because it happens at a jump of the loads.
  /// @param time  of the event, within the last step
  std::vector<double> changes_of_event(std::size_t event, double time) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const double first = integrator_.begin_of_step(), last = integrator_.time();
    std::vector<double> changes(variants_.n_values(), unknown);
    if (!(time > first)) return changes;
    const std::size_t n = variants_.all().size();
    constexpr double width = 0.02;  // of the step, about the time of the event
    std::vector<double> before(n, std::max(first, time - width * (last - first))),
        after(n, std::min(last, time + width * (last - first)));
    const auto hold_at = [&](const std::vector<double>& times) {
      std::vector<std::vector<double>> wholes(n);
      std::vector<char> holds(n, 0);
      variants_.for_each(
          [&](const Variant& variant) {
            const std::size_t v = Variants::index_of(variant);
            wholes[v] = integrator_.whole_at(times[v]);
            return std::span<const double>(wholes[v]);
          },
          [&](Variant& variant, std::span<const double> y) {
            const std::size_t v = Variants::index_of(variant);
            holds[v] = variant.with_snapshot(times[v], y, [&](results::Snapshot& snapshot) {
              return static_cast<char>(watches_[v].holds(event, snapshot));
            });
          });
      return holds;
    };
    const std::vector<char> held = hold_at(before), will_hold = hold_at(after);
    constexpr double resolution = 1e-13;
    while (true) {
      bool is_done = true;
      std::vector<double> middle(n);
      for (std::size_t v = 0; v < n; ++v) {
        middle[v] = before[v] + (after[v] - before[v]) / 2;
        is_done = is_done && after[v] - before[v] <= resolution * after[v];
      }
      if (is_done) break;
      const std::vector<char> holds = hold_at(middle);
      for (std::size_t v = 0; v < n; ++v) (holds[v] ? after : before)[v] = middle[v];
    }
    const auto found = [&](std::size_t v) { return held[v] == 0 && will_hold[v] == 1; };
    for (std::size_t k = 0; k < changes.size(); ++k) {
      const std::size_t more = 2 * k, less = 2 * k + 1;
      if (found(more) && found(less))
        changes[k] = Variants::derivative(after[more], after[less]);
      else if (found(more) || found(less))  // the other one lies beyond the step
        changes[k] = (found(more) ? after[more] - time : time - after[less]) / relative_change;
    }
    return changes;
  }

  const RunContext& context_;
  SensitiveIntegrator& integrator_;
  Variants& variants_;
  results::EventWatch watch_;
  std::vector<results::EventWatch> watches_;  // of the variants
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
