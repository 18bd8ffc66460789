/// How much heat flows at the end, and how strongly contact and heat act on each other.
#include <fmt/format.h>

#include "../heat_lines.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/results/contact_values.hpp"
#include "creepcontact/results/heat_flows.hpp"
#include "creepcontact/run/summary.hpp"
#include "observers.hpp"
#include "sudden_loss.hpp"

namespace creepcontact::run {
namespace {

class HeatObserver final : public Observer {
 public:
  explicit HeatObserver(const RunContext& context) : pairs_(context.assembly().pairs()) {
    if (context.assembly().heat() == nullptr) return;
    const std::vector<heat::HeatingThrough>& bodies = context.model.heat->bodies;
    for (const contact::Pair& pair : pairs_)
      losses_.emplace_back(std::max(bodies[pair.slave_body].time, bodies[pair.master_body].time),
                           context.model.breakpoints);
  }

  void state(StepView& view) override {
    for (std::size_t p = 0; p < losses_.size(); ++p) {
      const double force = results::normal_force(pairs_[p], view.evaluation().equilibrium.contact.multiplier);
      const auto loss = losses_[p].observe(view.time(), force);
      if (!loss) continue;
      lost_.push_back({p, *loss});
      log::warning(
          "heat: contact '{}' loses the last {:.2g} % of its largest normal force between t = {:.6g} and {:.6g}, at "
          "the speed of heat: pressure, conductance and temperature of the joint have no steady state with contact any "
          "more",
          pairs_[p].name, 100 * loss->share, loss->since, loss->time);
    }
  }
  void output(StepView& view) override {
    watch_gain(view);
    if (!view.is_end) return;
    view.with_snapshot([&](results::Snapshot& snapshot) {
      results::HeatFlows flows(snapshot.assembly());
      heat_ = recorded(flows, snapshot);
      return std::vector<double>{};
    });
  }
  void finish(Summary& summary) const override {
    summary.results.heat = heat_;
    if (!summary.results.heat) return;
    summary.results.heat->loop_gain = largest_gain_;
    for (const auto& [pair, loss] : lost_)
      summary.results.heat->sudden_losses.push_back({pairs_[pair].name, loss.time, loss.since, loss.force});
  }
  void save(creep::Memory& memory) const override {
    if (largest_gain_) memory["heat.loop_gain"] = {largest_gain_->value, largest_gain_->time};
    if (losses_.empty()) return;
    std::vector<SuddenLoss::Past> pasts;
    for (const SuddenLoss& loss : losses_) pasts.push_back(loss.past());
    memory.save("heat.joints", pasts);
    memory.save("heat.lost", lost_);
  }
  void restore(const creep::Memory& memory) override {
    if (const auto gain = memory.find("heat.loop_gain"); gain != memory.end() && gain->second.size() == 2)
      largest_gain_ = {gain->second[0], gain->second[1]};
    if (losses_.empty()) return;
    std::vector<SuddenLoss::Past> pasts;
    memory.restore("heat.joints", pasts);
    for (std::size_t p = 0; p < losses_.size(); ++p) losses_[p].go_on_from(std::move(pasts.at(p)));
    memory.restore("heat.lost", lost_);
  }

 private:
  struct Lost {
    std::size_t pair = 0;
    SuddenLoss::Loss loss = {};
    static constexpr auto members = std::tuple{Member{"pair", &Lost::pair}, Member{"loss", &Lost::loss}};
  };

  void watch_gain(StepView& view) {
    const std::optional<double> gain = view.system().loop_gain(view.time(), view.y());
    if (!gain) return;
    if (*gain > large_loop_gain && (!largest_gain_ || !(largest_gain_->value > large_loop_gain)))
      log::warning(
          "heat: at t = {:.6g} a change of the temperature comes back {:.2g} times through pressure and conductance of "
          "the contacts{}",
          view.time(), *gain, loop_gain_warning);
    if (!largest_gain_ || *gain > largest_gain_->value) largest_gain_ = {*gain, view.time()};
  }

  const std::vector<contact::Pair>& pairs_;
  std::vector<SuddenLoss> losses_;  // by pair, if heat depends on contact
  std::vector<Lost> lost_;
  std::optional<io::Summary::Heat> heat_;                // in process 0
  std::optional<io::Summary::Heat::Gain> largest_gain_;  // at the output times
};

}  // namespace

std::unique_ptr<Observer> observe_heat(const RunContext& context) {
  if (context.model.assembly.conduction() == nullptr) return nullptr;
  return std::make_unique<HeatObserver>(context);
}

}  // namespace creepcontact::run
