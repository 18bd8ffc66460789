#include <set>

#include "creepcontact/contact/solver/contact_solver.hpp"
#include "set_solver.hpp"
#include "spring_regularization.hpp"

namespace creepcontact::contact {
namespace {

class Schwarz final : public ContactSolver {
 public:
  Schwarz(const ContactProblem& problem, const SchwarzOptions& options)
      : problem_(problem), sets_(problem, options), fallback_(active_set_solver(problem)) {}

  ContactResult solve(const ContactLoad& load, const ContactState& warm) override {
    ContactResult result;
    result.state.active = first_set(problem_, load, warm);
    result.state.multiplier = warm.multiplier.size() == problem_.n_rows()
                                  ? warm.multiplier
                                  : Eigen::VectorXd(Eigen::VectorXd::Zero(problem_.n_rows()));
    End end = iterate(load, result);
    if (end != End::solved && problem_.n_motions() > 0) end = iterate_springs(load, result);
    if (end == End::solved) return result;
    warn_once(end == End::cycling ? "the Schwarz iteration repeats the same active sets; wherever this happens, the "
                                    "active-set method is used instead"
                                  : "the Schwarz iteration did not reach its tolerance within max_iterations; wherever "
                                    "this happens, the active-set method is used instead",
              fallback_warned_);
    ContactResult direct = fallback_->solve(load, warm);
    direct.iterations = result.iterations;
    direct.set_changes += result.set_changes;
    return direct;
  }

  void flexibility_changed() override {
    fallback_->flexibility_changed();
    springs_.reset();
    sets_.flexibility_changed();
  }

  void set_recorder(IterationRecorder* recorder) override {
    sets_.set_recorder(recorder);
    fallback_->set_recorder(recorder);
  }

  void set_stop(const StopRequest& stop) override {
    stop_ = stop;
    sets_.set_stop(stop);
    fallback_->set_stop(stop);
    springs_.reset();
  }

  bool has_given_up_sweeps() const override { return sets_.has_given_up_sweeps(); }
  void give_up_sweeps() override { sets_.give_up_sweeps(); }

 private:
  enum class End { solved, unbalanced, cycling, not_converged };

  /// Updates the set, from that of result.state and its multipliers on, until it repeats.
  End iterate(const ContactLoad& load, ContactResult& result) {
    Eigen::VectorXd& multiplier = result.state.multiplier;
    std::vector<int> active = result.state.active;
    const double rounding = multiplier_rounding(problem_, load);
    std::set<std::vector<int>> seen;
    while (seen.insert(active).second) {
      const RigidBalance balance = problem_.n_motions() > 0 ? RigidBalance(problem_, active) : RigidBalance();
      const InnerResult inner =
          sets_.solve(active, {load.gap(active), load.resultant, rounding}, multiplier(active), result);
      if (!balance.holds(inner.multiplier, load.resultant, rounding)) return End::unbalanced;
      if (!inner.converged) return End::not_converged;
      multiplier.setZero();
      multiplier(active) = inner.multiplier;
      result.gap = contact_gaps(problem_, load, {multiplier, Eigen::VectorXd::Zero(problem_.n_motions()), {}});
      result.state.rigid.resize(0);
      if (problem_.n_motions() > 0) {
        result.state.rigid = balance.amplitudes(result.gap(active));
        result.gap.noalias() += problem_.rigid * result.state.rigid;
      }
      // The gaps that remain in the set are errors of the iteration, not openings.
      Eigen::VectorXd opening = result.gap;
      opening(active).setZero();
      std::vector<int> next = updated_set(problem_, load, active, multiplier, opening, rounding);
      ++result.set_changes;
      if (next == active) {
        result.state.active = std::move(active);
        return End::solved;
      }
      active = std::move(next);
    }
    return End::cycling;
  }

  End iterate_springs(const ContactLoad& load, ContactResult& result) {
    if (!springs_) springs_ = std::make_unique<SpringRegularization>(problem_, stop_);
    End end = End::cycling;
    springs_->search(load, result.set_changes, [&](const ContactState& held) {
      result.state.active = held.active;
      result.state.multiplier = held.multiplier;
      end = iterate(load, result);
      return end == End::solved || end == End::not_converged;
    });
    return end;
  }

  const ContactProblem& problem_;
  SetSolver sets_;
  std::unique_ptr<ContactSolver> fallback_;
  std::unique_ptr<SpringRegularization> springs_;  // made when first needed
  StopRequest stop_;
  bool fallback_warned_ = false;
};

}  // namespace

std::unique_ptr<ContactSolver> schwarz_solver(const ContactProblem& problem, const SchwarzOptions& options) {
  return std::make_unique<Schwarz>(problem, options);
}

}  // namespace creepcontact::contact
