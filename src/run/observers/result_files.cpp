/// history.csv, steps.csv and the field files.
#include "creepcontact/results/results.hpp"
#include "held.hpp"
#include "observers.hpp"

namespace creepcontact::run {
namespace {

class ResultFiles final : public Observer {
 public:
  explicit ResultFiles(const RunContext& context) : context_(context) {
    together(context.team(), [&] {
      results_ = std::make_unique<results::Results>(
          context.config, context.directory, context.assembly(),
          io::Continuation{.resume = context.resumed != nullptr, .last_time = context.begin},
          context.observed.is_root());
    });
  }

  Reaction step(StepView& view) override {
    if (context_.integrates) together(context_.team(), [&] { held_.add(*view.step, view.is_tentative); });
    return Reaction::advance;
  }
  void output(StepView& view) override {
    if (context_.resumed != nullptr && view.time() <= context_.begin) return;  // is there already
    const std::vector<double>& probes = view.probe_values();
    view.with_snapshot([&](results::Snapshot& snapshot) {
      results_->output(snapshot, probes);
      return std::vector<double>{};
    });
  }
  void keep() override {
    together(context_.team(), [&] { held_.keep(); });
  }
  void undo() override { held_.undo(); }
  bool is_writing() const override { return results_->is_writing(); }
  void wait() override { results_->wait(); }
  void sync() override { results_->sync(); }

 private:
  const RunContext& context_;
  std::unique_ptr<results::Results> results_;
  Held<StepMade> held_{
      [this](const StepMade& made) { results_->step(made.report, made.work, made.n_active_contacts); }};
};

}  // namespace

std::unique_ptr<Observer> write_result_files(const RunContext& context) {
  return context.directory.empty() ? nullptr : std::make_unique<ResultFiles>(context);
}

}  // namespace creepcontact::run
