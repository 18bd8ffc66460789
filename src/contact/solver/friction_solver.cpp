#include <algorithm>
#include <array>
#include <limits>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/solver/contact_solver.hpp"
#include "friction_newton.hpp"
#include "friction_splitting.hpp"
#include "tresca.hpp"

namespace creepcontact::contact {
namespace {

// Of the multipliers, and of the forces that make up a resultant: polishing continues from there.
constexpr double search_tolerance = 1e-7;
constexpr double strict_tolerance = 1e-12;
constexpr double min_tolerance = 1e-10;  // of the multipliers
constexpr double slow_balance = 1;
constexpr double round_off_balance = 1e-10;    // what may remain of an iteration that makes no progress
constexpr double min_motion_amplitude = 1e-3;  // of the largest amplitude
constexpr int max_passes = 60;
constexpr int stalled_passes = 5;   // after which bodies slide off
constexpr int many_iterations = 8;  // of GMRES: a factor of the present equations pays
constexpr int frozen_limits = 12;   // iterations on the limits of the shear tractions
constexpr double splitting_tolerance = 1e-6;
constexpr int max_splittings = 3000;
constexpr int max_newton = 60;      // full steps, as long as they get on
constexpr int newton_patience = 8;  // iterations without progress
const double usual_scale = FrictionNewton::Options{}.tangential_scale;

class FrictionSolver final : public ContactSolver {
 public:
  FrictionSolver(const ContactProblem& problem, const FrictionOptions& options)
      : problem_(problem),
        options_(options),
        system_(problem),
        newton_(system_, [this](int iteration, double residual,
                                const Linearization& nodes) { record(iteration, residual, nodes); }),
        tresca_(problem, options.schwarz) {}

  ContactResult solve(const ContactLoad& load, const ContactState& warm) override {
    const bool is_warm = warm.multiplier.size() == problem_.n_rows();
    const auto zero = [](Index n) { return Eigen::VectorXd(Eigen::VectorXd::Zero(n)); };
    FrictionState start{is_warm ? warm.multiplier : zero(problem_.n_rows()),
                        warm.rigid.size() == problem_.n_motions() ? warm.rigid : zero(problem_.n_motions()),
                        is_warm ? warm.image : Eigen::VectorXd(), is_warm ? warm.nodes : Linearization()};
    Work work{load, warm.factored, multiplier_rounding(problem_, load), {}};
    set_ = 0;
    FrictionState found = solve_from(start, work);
    ContactResult& result = work.result;
    ContactState& state = result.state;
    result.iterations += found.iterations;
    result.set_changes += set_;
    result.gap = gaps_of(problem_, load, found);
    state.multiplier = std::move(found.multiplier);
    state.rigid = std::move(found.rigid);
    state.nodes = std::move(found.nodes);
    for (std::size_t i = 0; i < state.nodes.size(); ++i)  // iterations leave rounding errors
      if (const ContactNode& own = problem_.nodes[i]; state.nodes[i].status == ContactStatus::open)
        state.multiplier.segment(own.first_row, own.n_rows).setZero();
    state.active = closed_rows(state.nodes);
    state.factored = warm.factored.empty() || found.linear_iterations > many_iterations ? state.nodes : warm.factored;
    state.image = std::move(found.image);
    return std::move(result);
  }

  void flexibility_changed() override {
    system_.flexibility_changed();
    tresca_.flexibility_changed();
    tangential_step_ = 0;
  }
  void set_recorder(IterationRecorder* recorder) override {
    recorder_ = recorder;
    tresca_.sets().set_recorder(recorder);
  }
  void set_stop(const StopRequest& stop) override {
    stop_ = stop;
    system_.set_stop(stop);
    tresca_.sets().set_stop(stop);
  }
  bool has_given_up_sweeps() const override { return tresca_.sets().has_given_up_sweeps(); }
  void give_up_sweeps() override { tresca_.sets().give_up_sweeps(); }

 private:
  struct Work {
    const ContactLoad& load;
    const Linearization& factored;
    double rounding;
    ContactResult result;
  };

  FrictionState solve_from(const FrictionState& start, Work& work) {
    const bool use_tresca = options_.method == settings::FrictionMethod::tresca;
    FrictionState state = start;
    if (use_tresca) {
      if (solve_by_tresca(work, state)) return state;
      warn_once("Tresca's law with frozen tractions did not converge; wherever this happens, Newton's method is used",
                tresca_warned_);
      state = start;
    }
    if (polish_from(start, work, state)) return state;
    std::string failure;
    try {
      state = start;
      search(work, search_tolerance, state);
      const FrictionState near = state;
      if (polish(work, state)) return state;
      // Motions that are weakly held, or loads so near to the limit of what contact holds that it matters on which
      // side.
      state = near;
      search(work, strict_tolerance, state);
      if (polish(work, state)) return state;
    } catch (const SolverError& error) {  // another way, or another start
      failure = error.what();
    }
    if (split(start, work, state)) return state;
    state = start;
    if (!use_tresca && solve_by_tresca(work, state) && polish(work, state)) return state;
    throw SolverError(failure.empty() ? "contact: no state of contact with friction was found; use shorter steps"
                                      : failure);
  }

  /// Steps of Newton's method from the start: full ones from its statuses, then from those that its multipliers
  /// suggest, and damped ones; each with the usual scale of the residual, and with one that lets no traction pass its
  /// limit because of what the nodes next to it do, as along a bar. Where there are several states, damped steps stay
  /// nearer to the last one. @returns false if none converges
  bool polish_from(const FrictionState& start, Work& work, FrictionState& state) {
    enum class From { statuses, multipliers };
    const auto attempt = [&](From from, double tangential_scale, bool damped) {
      state = start;
      if (from == From::multipliers) state.nodes.clear();
      return polish(work, state, tangential_scale, damped);
    };
    const auto full = [&](From from) {
      return attempt(from, usual_scale, false) || attempt(from, tangential_step(), false);
    };
    const auto damped = [&] {
      return std::ranges::any_of(std::array{usual_scale, 1.0, tangential_step()},
                                 [&](double scale) { return attempt(From::multipliers, scale, true); });
    };
    if (start.nodes.empty()) return full(From::multipliers) || damped();
    return full(From::statuses) || damped() || full(From::multipliers);
  }

  /// Solves by splitting, with steps of different lengths: slow, for problems that Newton's method does not solve from
  /// the start. It ends in the steps of Newton's method.
  bool split(const FrictionState& start, Work& work, FrictionState& state) {
    if (problem_.large != nullptr) return false;
    for (const double scale : {0.1, 0.01, 1.0}) {
      state = start;
      ++set_;
      const FrictionSplitting splitting(system_.rows(), scale);
      splitting.iterate(
          work.load, splitting_tolerance, max_splittings,
          [&](int iteration, double change) {
            stop_.heed();
            ++work.result.iterations;
            if (recorder_ != nullptr)
              recorder_->record({set_, iteration + 1, "splitting", change, problem_.nodes.size()});
          },
          state);
      const FrictionState near = state;
      if (polish_from(near, work, state)) return true;
    }
    return false;
  }

  double tangential_step() {
    if (tangential_step_ == 0) tangential_step_ = system_.rows().tangential_step();
    return tangential_step_;
  }

  bool polish(Work& work, FrictionState& state, double tangential_scale = usual_scale, bool damped = false) {
    ++set_;
    const FrictionNewton::Options options{.tolerance = options_.schwarz.tolerance,
                                          .rounding = work.rounding,
                                          .tangential_scale = tangential_scale,
                                          .max_iterations = max_newton,
                                          .patience = damped ? max_newton : newton_patience,
                                          .damped = damped};
    const Friction& friction = work.load.friction;
    const bool mean = friction.direction.size() > 0 && !friction.direction.isZero(0);
    return newton_.polish(work.load, work.factored, options, mean, state);
  }

  bool solve_by_tresca(Work& work, FrictionState& state) {
    if (!tresca_.solve(work.load, work.rounding, system_.rows(), state, work.result)) return false;
    state.image = flexibility_product(problem_, state.multiplier);
    state.nodes = newton_.linearization(work.load, state.multiplier, gaps_of(problem_, work.load, state));
    return true;
  }

  /// Solves from any start. Bodies held by contact alone are held by springs, whose force is iterated to almost zero
  /// (method of multipliers, Hestenes 1969).
  void search(Work& work, double tolerance, FrictionState& state) {
    double last = std::numeric_limits<double>::infinity();
    int stalled = 0;
    for (int pass = 0; pass < max_passes; ++pass) {
      search_held(work, tolerance, state);
      if (problem_.n_motions() == 0) return;
      const Eigen::VectorXd left = unbalanced(problem_.rigid, state.multiplier, work.load.resultant);
      state.rigid += left / system_.rows().spring();
      if (is_balanced(problem_.rigid, state.multiplier, work.load.resultant, tolerance, work.rounding)) return;
      const double size = left.cwiseAbs().maxCoeff();
      stalled = size > 0.5 * last ? stalled + 1 : 0;
      if (stalled == stalled_passes) {
        // Motions that are weakly held converge slowly: polishing is asked before they are said to slide off.
        const double near = tolerance == strict_tolerance ? round_off_balance : slow_balance;
        if (is_balanced(problem_.rigid, state.multiplier, work.load.resultant, near, work.rounding)) return;
        const Eigen::VectorXd motion = (left.array().abs() > min_motion_amplitude * size).select(left / size, 0.0);
        throw UnbalancedLoad{motion, size};
      }
      last = size;
    }
    throw SolverError("contact: the forces on bodies that only contact holds did not come into balance");
  }

  FrictionNewton::Options search_options(const Work& work, double tolerance) const {
    // What a change of the motions leaves may be small, and yet unbalanced.
    return {.tolerance = std::max(tolerance, min_tolerance),
            .rounding = work.rounding,
            .min_iterations = problem_.n_motions() > 0 ? 1 : 0,
            .max_iterations = 50 + 2 * static_cast<int>(problem_.nodes.size())};
  }

  /// Also by way of Tresca's law, and with other scales of the residual.
  void search_held(Work& work, double tolerance, FrictionState& state) {
    const FrictionState start = state;
    FrictionNewton::Options options = search_options(work, tolerance);
    const auto attempt = [&] {
      ++set_;
      return newton_.search(work.load, work.factored, options, state);
    };
    if (attempt()) return;
    state = start;
    if (freeze_limits(work, state) && attempt()) return;
    for (const auto& [normal, tangential] : {std::pair(1.0, 0.03), std::pair(10.0, 0.03), std::pair(0.1, 0.3)}) {
      state = start;
      options.normal_scale = normal;
      options.tangential_scale = tangential;
      if (attempt()) return;
    }
    throw SolverError("contact: no state of contact with friction was found; use shorter steps");
  }

  /// A few iterations on the limits of the shear tractions, each with a convex problem.
  bool freeze_limits(Work& work, FrictionState& state) {
    FrictionNewton::Options options = search_options(work, search_tolerance);
    options.bound.setZero(std::ssize(problem_.nodes));
    for (int iteration = 0; iteration < frozen_limits; ++iteration) {
      for (std::size_t i = 0; i < problem_.nodes.size(); ++i)
        options.bound[static_cast<Index>(i)] = work.load.friction.coefficient[static_cast<Index>(i)] *
                                               std::max(0.0, state.multiplier[problem_.nodes[i].first_row]);
      ++set_;
      if (!newton_.search(work.load, {}, options, state)) return false;
    }
    return true;
  }

  void record(int iteration, double residual, const Linearization& nodes) const {
    stop_.heed();
    if (recorder_ != nullptr) recorder_->record({set_, iteration + 1, "newton", residual, closed_rows(nodes).size()});
  }

  std::vector<int> closed_rows(const Linearization& nodes) const {
    std::vector<int> rows;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const ContactNode& own = problem_.nodes[i];
      if (nodes[i].status == ContactStatus::open) continue;
      const int n = nodes[i].status == ContactStatus::slip ? 1 : own.n_rows;
      for (int row = own.first_row; row < own.first_row + n; ++row)
        if (system_.rows().is_movable(row)) rows.push_back(row);
    }
    return rows;
  }

  const ContactProblem& problem_;
  FrictionOptions options_;
  FrictionSystem system_;
  FrictionNewton newton_;
  Tresca tresca_;
  IterationRecorder* recorder_ = nullptr;
  StopRequest stop_;
  double tangential_step_ = 0;  // of the rows; 0: not known
  int set_ = 0;                 // attempts within the present solve
  bool tresca_warned_ = false;
};

}  // namespace

std::unique_ptr<ContactSolver> friction_solver(const ContactProblem& problem, const FrictionOptions& options) {
  return std::make_unique<FrictionSolver>(problem, options);
}

}  // namespace creepcontact::contact
