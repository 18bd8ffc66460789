/// A creep rate with friction against one without, from the state of the last step: two blocks of 75,000 unknowns each
/// with 1521 nodes in contact between them, of which some slip. `of_frictionless` is the ratio to the same without
/// friction, measured in one run; `of_a_pass` that to a pass forward and backward through both factors.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <map>

#include "creepcontact/config/reader.hpp"
#include "creepcontact/creep/creep_system.hpp"
#include "creepcontact/model/model.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "performance/measuring.hpp"

namespace creepcontact::test {
namespace {

class Scene {
 public:
  explicit Scene(double mu)
      : config_(config::read(CREEPCONTACT_FRICTION_BLOCKS, run::vocabulary(),
                             {fmt::format("contacts.0.friction={}", mu), "contact_solver.initial_substeps=1"})),
        model_(model::build_model(config_)),
        solver_(model_.assembly, model_.solver, watch_),
        system_(solver_, creep::survey_elastic_stress(solver_, config_.time.output, model_.breakpoints),
                config_.time.tolerance, watch_),
        state_(system_.size()),
        rate_(system_.size()) {
    for (const double t : {0.0, 0.1, 0.2, 0.3}) {
      system_.rate(t, state_, rate_);
      system_.accept(t, state_);
    }
    evaluate();
    for (std::size_t b = 0; b < model_.bodies().size(); ++b) {
      vectors_.emplace_back(model_.bodies()[b].constraints().n_free(), 1.0);
      factors_.push_back(solver_.interface().factored(b).solver().same_pattern());
      factors_.back()->factorize(solver_.interface().factored(b).stiffness(model_.bodies()[b].at(0)));
    }
    seconds_ = min_seconds(7, [&] { evaluate(); });
    pass_ = min_seconds(5, [&] {
      for (std::size_t b = 0; b < vectors_.size(); ++b) {
        factors_[b]->forward(vectors_[b], vectors_[b]);
        factors_[b]->backward(vectors_[b], vectors_[b]);
      }
    });
  }

  /// Within a step that begins at t = 0.3. Steps under error control change the status of few nodes.
  void evaluate() {
    time_ = time_ == 0.3001 ? 0.3002 : 0.3001;
    system_.rate(time_, state_, rate_);
  }
  double seconds() const { return seconds_; }
  double pass_seconds() const { return pass_; }
  const contact::ContactState& contact() const { return system_.step_evaluation().equilibrium.contact; }

 private:
  config::Config config_;
  Stopwatch watch_;
  model::Model model_;
  creep::EquilibriumSolver solver_;
  creep::CreepSystem system_;
  std::vector<std::unique_ptr<linalg::StiffnessSolver>> factors_;
  std::vector<double> state_, rate_;
  std::vector<std::vector<double>> vectors_;
  double time_ = 0, seconds_ = 0, pass_ = 0;
};

Scene& scene(double mu) {
  static std::map<double, Scene> scenes;
  return scenes.try_emplace(mu, mu).first->second;
}

void evaluation(benchmark::State& state) {
  const double mu = static_cast<double>(state.range(0)) / 100;
  Scene& s = scene(mu);
  for ([[maybe_unused]] auto _ : state) s.evaluate();
  state.counters["of_a_pass"] = s.seconds() / s.pass_seconds();
  state.counters["of_frictionless"] = s.seconds() / scene(0).seconds();
  double slipping = 0;
  for (const contact::NodeLinearization& node : s.contact().nodes)
    slipping += node.status == contact::ContactStatus::slip ? 1 : 0;
  state.counters["slipping"] = slipping;
}
BENCHMARK(evaluation)->Arg(0)->Arg(10)->Arg(30)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace creepcontact::test

BENCHMARK_MAIN();
