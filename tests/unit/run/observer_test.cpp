/// A run takes observers of its caller: they are asked, heard and resumed like its own.

#include <numeric>

#include "support/run/running.hpp"

namespace creepcontact::run::test {
namespace {

/// Integrates the mean pressure over the steps, and ends the run where it falls to a limit.
class PressureIntegral final : public Observer {
 public:
  explicit PressureIntegral(double limit = 0) : limit_(limit) {}

  Reaction step(StepView& view) override {
    sum_ += view.step->report.step * view.probe_values().at(0);
    ++n_steps_;
    return Reaction::advance;
  }
  void output(StepView& view) override { outputs_.push_back(view.time()); }
  std::vector<std::size_t> conditions(StepView& view) const override {
    return holds(0, view) ? std::vector<std::size_t>{0} : std::vector<std::size_t>{};
  }
  bool holds(std::size_t /*number*/, StepView& view) const override { return view.probe_values().at(0) < limit_; }
  void happened(std::size_t /*number*/, StepView& view) override { stopped_at_ = view.time(); }
  bool stops(std::size_t /*number*/) const override { return true; }
  void save(creep::Memory& memory) const override { memory["test.sum"] = {sum_, n_steps_}; }
  void restore(const creep::Memory& memory) override {
    sum_ = memory.at("test.sum").at(0);
    n_steps_ = memory.at("test.sum").at(1);
  }
  void end(End how) override { end_ = how; }
  void finish(Summary& summary) const override { summary.results.events["integral of the test"] = sum_; }

  double sum_ = 0, n_steps_ = 0, stopped_at_ = 0;
  std::vector<double> outputs_;
  std::optional<End> end_;

 private:
  double limit_;
};

const std::vector<std::string> settings{"time.output=[0.5, 1, 1.6, 3]", "time.integrator=log_adams"};

TEST(Observers, OfTheCallerSeeTheRun) {
  const Case blocks;
  PressureIntegral observer;
  const Summary summary =
      run(blocks.config(pressure_probe, settings), {.output = (blocks / "out").string(), .observers = {&observer}});
  ASSERT_EQ(summary.exit_status, 0) << summary.message;
  EXPECT_EQ(observer.n_steps_, static_cast<double>(summary.results.steps));
  EXPECT_EQ(observer.outputs_, Table(blocks / "out/history.csv").times());
  EXPECT_EQ(observer.end_, End::completed);
  EXPECT_EQ(SummaryFile(blocks / "out/summary.json").number("events/integral of the test"), observer.sum_);
}

TEST(Observers, OfTheCallerAreResumedToTheLastBit) {
  const Case blocks;
  const config::Config config = blocks.config(pressure_probe, settings);
  PressureIntegral whole, first, second;
  ASSERT_EQ(run(config, {.output = (blocks / "whole").string(), .observers = {&whole}}).exit_status, 0);
  InterruptAtOutput interrupt(3);
  const std::string parts = (blocks / "parts").string();
  ASSERT_EQ(run(config, {.output = parts, .observers = {&first, &interrupt}}).exit_status, 130);
  EXPECT_EQ(first.end_, End::interrupted);
  EXPECT_LT(first.n_steps_, whole.n_steps_);
  ASSERT_EQ(run(config, {.output = parts, .resume = true, .observers = {&second}}).exit_status, 0);
  EXPECT_EQ(second.sum_, whole.sum_);
  EXPECT_EQ(second.n_steps_, whole.n_steps_);
}

TEST(Observers, ConditionsOfTheCallerAreLocatedAndStopTheRun) {
  const Case blocks;
  PressureIntegral observer(0.8);
  std::vector<std::string> accurate = settings;
  accurate.emplace_back("time.tolerance=1e-5");
  const config::Config config = blocks.config(pressure_probe, accurate);
  const Summary summary = run(config, {.output = (blocks / "out").string(), .observers = {&observer}});
  ASSERT_EQ(summary.exit_status, 0) << summary.message;
  EXPECT_NEAR(relaxed_pressure(observer.stopped_at_), 0.8, 1e-4);
  EXPECT_EQ(summary.results.time_reached, observer.stopped_at_);
  EXPECT_EQ(Table(blocks / "out/history.csv").times().back(), observer.stopped_at_);
  EXPECT_EQ(observer.end_, End::completed);
}

}  // namespace
}  // namespace creepcontact::run::test
