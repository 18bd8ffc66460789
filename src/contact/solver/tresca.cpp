#include "tresca.hpp"

#include <algorithm>
#include <cmath>

#include "aitken.hpp"
#include "creepcontact/base/index.hpp"

namespace creepcontact::contact {
namespace {

constexpr int max_iterations_of_tractions = 1000;

/// The direction e for which a slip along -u has the mean direction e + (e . before) before: the tangent of its angle
/// to `before` is twice that of u.
Eigen::Vector2d from_mean_direction(const Eigen::Vector2d& u, const Eigen::Vector2d& before) {
  const double along = u.dot(before), across = u.dot(turned(before));
  if (along <= 0) return u;
  return (along * before + 2 * across * turned(before)).normalized();
}

}  // namespace

/// One solve: `given` are the tractions of slipping nodes, the other members what the last step made of them.
class Tresca::Iteration {
 public:
  Iteration(Tresca& owner, const ContactLoad& load, double rounding, const FrictionRows& rows,
            const FrictionState& start, ContactResult& total)
      : owner_(owner),
        problem_(owner.problem_),
        load_(load),
        rounding_(rounding),
        rows_(rows),
        total_(total),
        multiplier_(start.multiplier),
        slips_(problem_.nodes.size(), 0) {
    if (start.nodes.empty()) {
      active_ = first_set(problem_, load, {});
      add_sticking_rows();
    } else {
      for (std::size_t i = 0; i < start.nodes.size(); ++i) slips_[i] = start.nodes[i].status == ContactStatus::slip;
      for (std::size_t i = 0; i < start.nodes.size(); ++i)
        if (start.nodes[i].status != ContactStatus::open) add_closed(problem_.nodes[i]);
      add_sticking_rows();
    }
  }

  Eigen::VectorXd first_tractions() const {
    Eigen::VectorXd given = Eigen::VectorXd::Zero(problem_.n_rows());
    for (std::size_t i = 0; i < slips_.size(); ++i)
      for (int k = 0; slips_[i] != 0 && k < rows_.tangents(i).n; ++k)
        given[rows_.tangents(i).rows[k]] = multiplier_[rows_.tangents(i).rows[k]];
    return given;
  }

  /// @param image  the tractions that follow from `given` @returns true at the end
  bool step(const Eigen::VectorXd& given, Eigen::VectorXd& image) {
    ++steps_;
    const bool is_given = !given.isZero(0);
    Eigen::VectorXd gap = load_.gap, resultant = load_.resultant;
    if (is_given) gap += flexibility_product(problem_, given);
    if (is_given && problem_.n_motions() > 0) {
      if (resultant.size() == 0) resultant.setZero(problem_.n_motions());
      resultant += problem_.rigid.transpose() * given;
    }
    const RigidBalance balance = problem_.n_motions() > 0 ? RigidBalance(problem_, active_) : RigidBalance();
    const InnerResult inner =
        owner_.sets_.solve(active_, {gap(active_), resultant, rounding_}, multiplier_(active_), total_);
    ++total_.set_changes;
    image = given;
    if (!inner.converged || !balance.holds(inner.multiplier, resultant, rounding_)) return true;
    multiplier_ = given;
    multiplier_(active_) = inner.multiplier;
    gap_ = contact_gaps(problem_, load_, {multiplier_, Eigen::VectorXd::Zero(problem_.n_motions()), {}});
    if (problem_.n_motions() > 0) {
      rigid_ = balance.amplitudes(gap_(active_));
      gap_ += problem_.rigid * rigid_;
    }
    Eigen::VectorXd opening = gap_;
    for (const int row : active_) opening[row] = 0;
    const std::vector<int> before = active_;
    const std::vector<char> slipped = slips_;
    active_ = updated_set(problem_, load_, active_, multiplier_, opening, rounding_);
    // The limits follow the pressures when the nodes that slip under the old ones are found.
    const bool are_limits_new = is_settled_ || limits_.size() == 0;
    if (are_limits_new) set_limits();
    image = tractions();
    is_settled_ = slips_ == slipped;
    add_sticking_rows();
    const double largest = multiplier_.cwiseAbs().maxCoeff();
    solved_ = are_limits_new && active_ == before &&
              (image - given).cwiseAbs().maxCoeff() <= std::max(owner_.options_.tolerance * largest, rounding_);
    return solved_ || steps_ >= max_iterations_of_tractions;
  }

  bool solved() const { return solved_; }
  bool is_settled() const { return is_settled_; }
  const Eigen::VectorXd& multiplier() const { return multiplier_; }
  const Eigen::VectorXd& rigid() const { return rigid_; }

 private:
  void add_closed(const ContactNode& node) {
    for (int row = node.first_row; row < node.first_row + node.n_closed(); ++row)
      if (rows_.is_movable(row)) active_.push_back(row);
  }

  /// The tangential rows of closed nodes that do not slip. @pre active_ has no tangential rows
  void add_sticking_rows() {
    std::vector<int> sticking;
    for (const int row : active_) {
      const auto node = static_cast<std::size_t>(problem_.node_of_row[row]);
      if (problem_.nodes[node].set != AdmissibleSet::cone || slips_[node] != 0) continue;
      for (int k = 0; k < rows_.tangents(node).n; ++k) sticking.push_back(rows_.tangents(node).rows[k]);
    }
    active_.insert(active_.end(), sticking.begin(), sticking.end());
    std::ranges::sort(active_);
  }

  /// Shear tractions of the closed nodes that slip; decides which do. @pre active_ has no tangential rows
  Eigen::VectorXd tractions() {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(problem_.n_rows());
    std::ranges::fill(slips_, 0);
    for (const int row : active_) {
      const auto i = static_cast<std::size_t>(problem_.node_of_row[row]);
      const FrictionRows::Tangents& tangential = rows_.tangents(i);
      if (problem_.nodes[i].set != AdmissibleSet::cone || tangential.n == 0) continue;
      const Eigen::Vector2d tau = tangential.of(multiplier_), v = tangential.of(gap_),
                            before = direction_before(load_, tangential);
      const double bound = limits_[static_cast<Index>(i)];
      const double r = owner_.scale_ / tangential.flexibility;
      if ((tau - r * v).norm() <= bound) continue;
      slips_[i] = 1;
      const bool mean = tangential.n == 2 && !before.isZero(0) && tau.norm() > 0;
      Eigen::Vector2d e = (tau - r * v).normalized();
      if (mean) {
        const Eigen::Vector2d now = tau.normalized();
        const Eigen::Vector2d middle = (now + std::max(0.0, now.dot(before)) * before).normalized();
        e = from_mean_direction((tau.norm() * middle - r * v).normalized(), before);
      }
      for (int k = 0; k < tangential.n; ++k) result[tangential.rows[k]] = bound * e[tangential.components[k]];
    }
    return result;
  }

  void set_limits() {
    limits_ = load_.friction.coefficient;
    for (std::size_t i = 0; i < problem_.nodes.size(); ++i)
      limits_[static_cast<Index>(i)] *= std::max(0.0, multiplier_[problem_.nodes[i].first_row]);
  }

  Tresca& owner_;
  const ContactProblem& problem_;
  const ContactLoad& load_;
  double rounding_;
  const FrictionRows& rows_;
  ContactResult& total_;
  Eigen::VectorXd multiplier_, gap_, rigid_;
  Eigen::VectorXd limits_;  // of the shear tractions, per node
  bool is_settled_ = false;
  std::vector<int> active_;
  std::vector<char> slips_;  // per node
  int steps_ = 0;
  bool solved_ = false;
};

void Tresca::flexibility_changed() {
  sets_.flexibility_changed();
  scale_ = 0;
}

bool Tresca::solve(const ContactLoad& load, double rounding, const FrictionRows& rows, FrictionState& state,
                   ContactResult& total) {
  if (scale_ == 0) scale_ = rows.tangential_step();
  Iteration iteration(*this, load, rounding, rows, state, total);
  Eigen::VectorXd given = iteration.first_tractions(), image(given.size());
  Aitken aitken;
  while (!iteration.step(given, image)) {
    if (iteration.is_settled()) {
      aitken.advance(given, image);
    } else {
      aitken = {};
      given.swap(image);
    }
  }
  if (!iteration.solved()) return false;
  state.multiplier = iteration.multiplier();
  state.image.resize(0);
  state.nodes.clear();
  if (problem_.n_motions() > 0) state.rigid = iteration.rigid();
  return true;
}

}  // namespace creepcontact::contact
