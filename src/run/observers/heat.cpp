/// How much heat flows at the end, and how strongly contact and heat act on each other.
#include <fmt/format.h>

#include "creepcontact/base/log.hpp"
#include "creepcontact/results/heat_flows.hpp"
#include "creepcontact/run/summary.hpp"
#include "observers.hpp"

namespace creepcontact::run {
namespace {

constexpr double large_gain = 0.5;

class HeatObserver final : public Observer {
 public:
  void output(StepView& view) override {
    watch_gain(view);
    if (!view.is_end) return;
    view.with_snapshot([&](results::Snapshot& snapshot) {
      results::HeatFlows flows(snapshot.assembly());
      const heat::Balance balance = flows.at(snapshot);
      heat_ = io::Summary::Heat();
      const heat::Definition& all = flows.definition();
      const auto take = [](const auto& named, const std::vector<double>& values,
                           std::vector<std::pair<std::string, double>>& into) {
        for (std::size_t i = 0; i < values.size(); ++i) into.emplace_back(named[i].name, values[i]);
      };
      take(all.flows, balance.flows, heat_->flows);
      take(all.sources, balance.sources, heat_->flows);
      take(all.point_flows, balance.points, heat_->flows);
      take(all.given, balance.given, heat_->flows);
      take(all.interfaces, balance.interfaces, heat_->contacts);
      heat_->stored = balance.stored;
      heat_->rest = balance.rest();
      return std::vector<double>{};
    });
  }
  void finish(Summary& summary) const override {
    summary.results.heat = heat_;
    if (!summary.results.heat) return;
    summary.results.heat->loop_gain = largest_gain_;
  }

 private:
  void watch_gain(StepView& view) {
    const std::optional<double> gain = view.system().loop_gain(view.time(), view.y());
    if (!gain) return;
    if (*gain > large_gain && (!largest_gain_ || !(largest_gain_->value > large_gain)))
      log::warning(
          "heat: at t = {:.6g} a change of the temperature comes back {:.2g} times through pressure and conductance of "
          "the contacts; above 1 the joint loses its pressure, or takes it up, at the speed of heat",
          view.time(), *gain);
    if (!largest_gain_ || *gain > largest_gain_->value) largest_gain_ = {*gain, view.time()};
  }

  std::optional<io::Summary::Heat> heat_;                // in process 0
  std::optional<io::Summary::Heat::Gain> largest_gain_;  // at the output times
};

}  // namespace

std::unique_ptr<Observer> observe_heat(const RunContext& context) {
  if (context.model.assembly.conduction() == nullptr) return nullptr;
  return std::make_unique<HeatObserver>();
}

}  // namespace creepcontact::run
