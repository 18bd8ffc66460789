#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/solver/contact_solver.hpp"

namespace creepcontact::contact {
namespace {

constexpr double same_pressure = 1e-12;        // of the largest: the line found is that of the curve
constexpr double rounding_of_closure = 1e-14;  // of the closures of a curve
constexpr int max_newton_of_gaskets = 200;
constexpr int slower_with_friction = 15;  // iterations; then the steps of the closures are halved
constexpr int bisections = 60;

/// A displacement of the bodies, by the multipliers that cause it.
struct Displaced {
  Eigen::VectorXd multiplier, rigid, gap;
  Eigen::VectorXd closure;  // per node
};

class GasketSolver final : public ContactSolver {
 public:
  GasketSolver(const ContactProblem& problem, const ContactSolverFactory& make_solver)
      : problem_(problem),
        linear_(ContactProblem::with_compliance(problem, Eigen::VectorXd::Zero(problem.n_rows()))),
        solver_(make_solver(linear_)) {
    for (std::size_t i = 0; i < problem.nodes.size(); ++i)
      if (problem.nodes[i].has_gasket()) gaskets_.push_back(i);
  }

  ContactResult solve(const ContactLoad& load, const ContactState& warm) override {
    ContactState from = warm;
    from.image.resize(0);  // of another compliance
    Eigen::VectorXd closure = warm.closure.size() == std::ssize(problem_.nodes)
                                  ? warm.closure
                                  : Eigen::VectorXd(Eigen::VectorXd::Zero(std::ssize(problem_.nodes)));
    Displaced last;
    ContactResult total;
    for (int iteration = 0; iteration < max_newton_of_gaskets; ++iteration) {
      ContactResult found = solve_linear(load, closure, from);
      found.iterations = total.iterations += found.iterations;
      found.set_changes = total.set_changes += found.set_changes;
      if (is_on_curves(load, found.state)) {
        finish(load, found.state);
        return found;
      }
      if (iteration > 0 && !problem_.has_friction()) go_towards(load, last, found);
      const Eigen::VectorXd before = closure;
      closure = found.state.closure;
      if (problem_.has_friction())
        closure = before + std::pow(0.5, iteration / slower_with_friction) * (closure - before);
      from = found.state;
      from.image.resize(0);
      last = {std::move(found.state.multiplier), std::move(found.state.rigid), std::move(found.gap),
              std::move(found.state.closure)};
    }
    throw SolverError("contact: the pressures of a gasket did not converge; use shorter steps");
  }

  void flexibility_changed() override {
    linear_.large = problem_.large;
    solver_->flexibility_changed();
  }
  void set_recorder(IterationRecorder* recorder) override { solver_->set_recorder(recorder); }
  void set_stop(const StopRequest& stop) override { solver_->set_stop(stop); }
  bool has_given_up_sweeps() const override { return solver_->has_given_up_sweeps(); }
  void give_up_sweeps() override { solver_->give_up_sweeps(); }

 private:
  /// The solution for the lines of all curves at these closures.
  ContactResult solve_linear(const ContactLoad& load, const Eigen::VectorXd& closure, const ContactState& from) {
    ContactLoad shifted{load.gap, load.resultant, load.friction, load.idle, load.force};
    Eigen::VectorXd compliance = Eigen::VectorXd::Zero(problem_.n_rows());
    std::vector<ClosureCurve::Line> lines;
    for (const std::size_t i : gaskets_) {
      const ContactNode& node = problem_.nodes[i];
      lines.push_back(load.curves[i].line(closure[static_cast<Index>(i)]));
      compliance[node.first_row] = node.gasket_area / lines.back().slope;
      shifted.gap[node.first_row] += node.gasket_area * lines.back().zero;
    }
    if (compliance != linear_.compliance) {
      linear_.compliance = std::move(compliance);
      solver_->flexibility_changed();
    }
    ContactResult found = solver_->solve(shifted, from);
    found.state.closure.setZero(std::ssize(problem_.nodes));
    for (std::size_t k = 0; k < gaskets_.size(); ++k) {
      const ContactNode& node = problem_.nodes[gaskets_[k]];
      const int row = node.first_row;
      const double pressure = found.state.multiplier[row];
      double& gap = found.gap[row];
      gap -= linear_.compliance[row] * pressure + node.gasket_area * lines[k].zero;
      found.state.closure[static_cast<Index>(gaskets_[k])] =
          pressure > 0 || lines[k].pulls ? lines[k].closure(pressure) : -gap / node.gasket_area;
    }
    return found;
  }

  bool is_on_curves(const ContactLoad& load, const ContactState& found) const {
    double largest = 0;
    for (const std::size_t i : gaskets_)
      largest = std::max(largest, std::abs(found.multiplier[problem_.nodes[i].first_row]));
    return std::ranges::all_of(gaskets_, [&](std::size_t i) {
      const double closure = found.closure[static_cast<Index>(i)];
      const double error = load.curves[i].pressure(closure) - found.multiplier[problem_.nodes[i].first_row];
      return std::abs(error) <= same_pressure * largest + rounding_of_closure * load.curves[i].line(closure).slope *
                                                              (std::abs(closure) + load.curves[i].end());
    });
  }

  void finish(const ContactLoad& load, ContactState& state) const {
    state.compliance.setZero(problem_.n_rows());
    for (const std::size_t i : gaskets_) {
      const ContactNode& node = problem_.nodes[i];
      state.compliance[node.first_row] =
          node.gasket_area / load.curves[i].line(state.closure[static_cast<Index>(i)]).slope;
    }
    if (state.image.size() > 0) state.image -= linear_.compliance.cwiseProduct(state.multiplier);
  }

  /// Goes from the last displacement towards the one found, to the least energy
  ///   1/2 lambda^T F lambda + sum over gaskets of area times the integral of the pressure over the closure - e^T
  ///   alpha,
  /// which is convex in the displacements. Its slope is a function of straight pieces that increases.
  void go_towards(const ContactLoad& load, const Displaced& last, ContactResult& found) const {
    const Eigen::VectorXd change = found.state.multiplier - last.multiplier, opening = found.gap - last.gap;
    Eigen::VectorXd strained = last.gap - load.gap, straining = opening;  // F lambda, and its change
    double constant = 0;
    if (problem_.n_motions() > 0) {
      const Eigen::VectorXd motion = found.state.rigid - last.rigid;
      strained -= problem_.rigid * last.rigid;
      straining -= problem_.rigid * motion;
      if (load.resultant.size() > 0) constant = -load.resultant.dot(motion);
    }
    constant += change.dot(strained);
    const double quadratic = change.dot(straining);
    const Eigen::VectorXd closing = found.state.closure - last.closure;
    const auto slope = [&](double part) {
      double sum = constant + part * quadratic;
      for (const std::size_t i : gaskets_) {
        const auto k = static_cast<Index>(i);
        sum +=
            problem_.nodes[i].gasket_area * closing[k] * load.curves[i].pressure(last.closure[k] + part * closing[k]);
      }
      return sum;
    };
    if (slope(1) <= 0) return;
    double low = 0, high = 1;
    for (int k = 0; k < bisections; ++k) (slope((low + high) / 2) > 0 ? high : low) = (low + high) / 2;
    found.state.multiplier = last.multiplier + high * change;
    found.gap = last.gap + high * opening;
    found.state.closure = last.closure + high * closing;
    if (problem_.n_motions() > 0) found.state.rigid = last.rigid + high * (found.state.rigid - last.rigid);
  }

  const ContactProblem& problem_;
  ContactProblem linear_;  // with the compliance of the lines
  std::unique_ptr<ContactSolver> solver_;
  std::vector<std::size_t> gaskets_;  // nodes
};

}  // namespace

std::unique_ptr<ContactSolver> gasket_solver(const ContactProblem& problem, const ContactSolverFactory& make_solver) {
  if (!problem.has_gaskets()) return make_solver(problem);
  return std::make_unique<GasketSolver>(problem, make_solver);
}

}  // namespace creepcontact::contact
