#include "friction_system.hpp"

#include <Eigen/LU>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <optional>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/linalg/dense.hpp"
#include "gmres.hpp"

namespace creepcontact::contact {
namespace {

constexpr double min_movable_flexibility = 1e-14;  // of the largest flexibility
constexpr double relative_spring = 1e-3;           // of the stiffness of the bodies on their rigid-body modes
constexpr double regularization = 1e-11;           // of the largest flexibility: rows that repeat each other
constexpr int max_gmres = 40;                      // iterations with a factor of equations nearby
constexpr int max_gmres_large = 1000;
constexpr std::size_t n_factors = 2;
constexpr int power_iterations = 15;
constexpr double weakest_held_motion_of_friction = 1e-6;  // of a motion that only the springs hold

}  // namespace

FrictionRows::FrictionRows(const ContactProblem& problem) : problem_(&problem), flexibility_(row_flexibility(problem)) {
  const double largest = flexibility_.size() > 0 ? flexibility_.maxCoeff() : 0.0;
  for (double& flexibility : flexibility_) {
    movable_.push_back(flexibility > min_movable_flexibility * largest ? 1 : 0);
    if (movable_.back() == 0) flexibility = largest > 0 ? largest : 1;
  }
  for (const ContactNode& node : problem.nodes) {
    Tangents tangents;
    for (int k = 1; node.set == AdmissibleSet::cone && k < node.n_rows; ++k)
      if (const int row = node.first_row + k; is_movable(row)) {
        tangents.rows[tangents.n] = row;
        tangents.components[tangents.n++] = k - 1;
        tangents.flexibility += flexibility_[row];
      }
    if (tangents.n > 0) tangents.flexibility /= tangents.n;
    tangents_.push_back(tangents);
  }
  const double motion = problem.rigid.squaredNorm();
  if (motion > 0) spring_ = relative_spring * motion / flexibility_diagonal(problem).sum();
}

double FrictionRows::tangential_step() const {
  Eigen::VectorXd root = Eigen::VectorXd::Zero(problem_->n_rows());  // of 1/diag F, in tangential rows
  for (const Tangents& tangents : tangents_)
    for (int k = 0; k < tangents.n; ++k) root[tangents.rows[k]] = 1 / std::sqrt(tangents.flexibility);
  Eigen::VectorXd vector = root;
  double largest = 1;
  for (int k = 0; k < power_iterations && vector.norm() > 0; ++k) {
    vector.normalize();
    const Eigen::VectorXd image = root.cwiseProduct(flexibility_product(*problem_, root.cwiseProduct(vector)));
    largest = std::max(largest, image.norm());
    vector = image;
  }
  return 1 / largest;
}

Eigen::VectorXd FrictionRows::gaps(const Eigen::VectorXd& multiplier) const {
  Eigen::VectorXd gap = flexibility_product(*problem_, multiplier);
  if (spring_ > 0) gap += spring_gaps(multiplier);
  return gap;
}

Eigen::VectorXd FrictionRows::spring_gaps(const Eigen::VectorXd& multiplier) const {
  if (!(spring_ > 0)) return Eigen::VectorXd::Zero(multiplier.size());
  return problem_->rigid * ((problem_->rigid.transpose() * multiplier) / spring_);
}

Eigen::MatrixXd FrictionRows::motions(const Linearization& at) const {
  Eigen::MatrixXd result(problem_->n_rows(), problem_->n_motions());
  const Eigen::VectorXd no_multiplier = Eigen::VectorXd::Zero(problem_->n_rows());
  for (Index j = 0; j < result.cols(); ++j) result.col(j) = equations(at, no_multiplier, problem_->rigid.col(j));
  return result;
}

Eigen::VectorXd FrictionRows::equations(const Linearization& at, const Eigen::VectorXd& multiplier,
                                        const Eigen::VectorXd& gap, const Eigen::VectorXd& bound) const {
  Eigen::VectorXd left = flexibility_.cwiseProduct(multiplier);
  for (std::size_t i = 0; i < at.size(); ++i) {
    const NodeLinearization& node = at[i];
    if (node.status == ContactStatus::open) continue;
    const ContactNode& rows = problem_->nodes[i];
    for (int row = rows.first_row; row < rows.first_row + rows.n_closed(); ++row)
      if (is_movable(row)) left[row] = gap[row];
    const Tangents& tangential = tangents_[i];
    if (node.status == ContactStatus::stick) {
      for (int k = 0; k < tangential.n; ++k) left[tangential.rows[k]] = gap[tangential.rows[k]];
    } else if (tangential.n > 0) {
      const Eigen::Vector2d tau = tangential.of(multiplier), v = tangential.of(gap);
      const double limit = node.friction * multiplier[rows.first_row] + (bound.size() > 0 ? bound[i] : 0.0);
      left[tangential.rows[0]] = tangential.flexibility * (node.direction.dot(tau) - limit);
      if (tangential.n == 2)
        left[tangential.rows[1]] = node.equation.dot(v) + node.flexibility * turned(node.direction).dot(tau);
    }
  }
  return left;
}

namespace {

using Inverse = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// An inverse of the equations of some state, extended by the balance of the forces on the rigid-body modes.
class BalancedInverse {
 public:
  /// @param inverse  of the equations, if `has_springs` with springs on the modes; exact or approximate
  BalancedInverse(const FrictionRows& rows, const Linearization& at, Inverse inverse, bool has_springs)
      : rows_(rows), inverse_(std::move(inverse)), has_springs_(has_springs), motions_(rows.motions(at)) {
    carried_ = motions_;
    for (Index j = 0; j < carried_.cols(); ++j) carried_.col(j) = inverse_(motions_.col(j));
    const linalg::SingularValues coarse = linalg::singular_values(rows.problem().rigid.transpose() * carried_);
    Eigen::VectorXd values = coarse.values;
    const double least = weakest_held_motion_of_friction * (has_springs ? rows.spring() : values.maxCoeff());
    is_regular_ = values.minCoeff() > least;
    for (double& value : values) value = value > least ? 1 / value : 0.0;
    coarse_inverse_ = coarse.right * values.asDiagonal() * coarse.left.transpose();
  }

  /// False if the rows in contact do not hold all motions, as where all is open.
  bool is_regular() const { return is_regular_; }
  /// @param rigid  receives the amplitudes; those of motions that are not held are zero
  Eigen::VectorXd solve(const Eigen::VectorXd& right, const Eigen::VectorXd& resultant, Eigen::VectorXd& rigid) const {
    const Eigen::VectorXd held =
        has_springs_ ? inverse_(right + motions_ * (resultant / rows_.spring())) : inverse_(right);
    rigid = coarse_inverse_ * (rows_.problem().rigid.transpose() * held - resultant);
    return held - carried_ * rigid;
  }

 private:
  const FrictionRows& rows_;
  Inverse inverse_;
  bool has_springs_;
  Eigen::MatrixXd motions_, carried_;  // N' of the equations, and the multipliers that close it
  Eigen::MatrixXd coarse_inverse_;     // pseudo-inverse of N^T carried_
  bool is_regular_ = false;
};

}  // namespace

/// LU factor of the equations of rows in contact. Multipliers are E z + p, where p fulfils the other equations.
class FrictionSystem::Factor {
 public:
  Factor(const FrictionRows& rows, Linearization at) : rows_(rows), at_(std::move(at)) {
    const ContactProblem& problem = rows.problem();
    std::vector<Eigen::Triplet<double>> columns, equations;
    std::vector<double> diagonal;
    const auto add = [&](int row, double equation) {  // an unknown with one equation, in the same row
      columns.emplace_back(row, static_cast<int>(diagonal.size()), 1.0);
      equations.emplace_back(static_cast<int>(diagonal.size()), row, equation);
      unknown_rows_.push_back(row);
      diagonal.push_back(0);
    };
    for (std::size_t i = 0; i < at_.size(); ++i) {
      const NodeLinearization& node = at_[i];
      const ContactNode& own = problem.nodes[i];
      if (node.status == ContactStatus::open) continue;
      const FrictionRows::Tangents& tangential = rows.tangents(i);
      const int normal = static_cast<int>(diagonal.size());
      for (int row = own.first_row; row < own.first_row + own.n_closed(); ++row)
        if (rows.is_movable(row)) add(row, 1);
      if (node.status == ContactStatus::stick) {
        for (int k = 0; k < tangential.n; ++k) add(tangential.rows[k], 1);
        continue;
      }
      const Eigen::Vector2d across = turned(node.direction);
      if (tangential.n == 2) {
        const int column = static_cast<int>(diagonal.size());
        for (int k = 0; k < 2; ++k) {
          columns.emplace_back(tangential.rows[k], column, across[k]);
          equations.emplace_back(column, tangential.rows[k], node.equation[k]);
        }
        unknown_rows_.push_back(tangential.rows[1]);
        diagonal.push_back(node.flexibility);
      }
      for (int k = 0; k < tangential.n; ++k)
        columns.emplace_back(tangential.rows[k], normal, node.friction * node.direction[tangential.components[k]]);
    }
    const Index n = diagonal.size();
    columns_.resize(problem.n_rows(), n);
    columns_.setFromTriplets(columns.begin(), columns.end());
    equations_.resize(n, problem.n_rows());
    equations_.setFromTriplets(equations.begin(), equations.end());
    Eigen::MatrixXd matrix = equations_ * (problem.flexibility() * columns_);
    if (problem.compliance.size() > 0) matrix += equations_ * problem.compliance.asDiagonal() * columns_;
    if (rows.spring() > 0)
      matrix.noalias() +=
          (equations_ * problem.rigid) * (columns_.transpose() * problem.rigid).transpose() / rows.spring();
    if (n > 0) matrix.diagonal().array() += regularization * matrix.diagonal().cwiseAbs().maxCoeff();
    matrix.diagonal() += Eigen::Map<const Eigen::VectorXd>(diagonal.data(), n);
    factor_.compute(matrix);
    if (rows.spring() > 0)
      balanced_.emplace(
          rows, at_, [this](const Eigen::VectorXd& right) { return solve(right); }, true);
  }
  Factor(const Factor&) = delete;
  Factor& operator=(const Factor&) = delete;

  const Linearization& at() const { return at_; }

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const {
    Eigen::VectorXd particular = right;
    particular(unknown_rows_).setZero();
    for (std::size_t i = 0; i < at_.size(); ++i) {
      const NodeLinearization& node = at_[i];
      const FrictionRows::Tangents& tangential = rows_.tangents(i);
      if (node.status != ContactStatus::slip || tangential.n == 0) continue;
      const double along = right[tangential.rows[0]] / tangential.flexibility;
      for (int k = 0; k < tangential.n; ++k)
        particular[tangential.rows[k]] =
            along * node.direction[tangential.components[k]] * rows_.flexibility(tangential.rows[k]);
    }
    for (Index row = 0; row < particular.size(); ++row) particular[row] /= rows_.flexibility(static_cast<int>(row));
    Eigen::VectorXd rest = right(unknown_rows_);
    if (!particular.isZero(0)) rest -= equations_ * rows_.gaps(particular);
    return particular + columns_ * factor_.solve(rest);
  }

  /// The inverse that balances resultants; exists only with rigid-body modes.
  const BalancedInverse& balanced() const { return *balanced_; }

 private:
  const FrictionRows& rows_;
  Linearization at_;
  std::vector<int> unknown_rows_;  // whose equations the factor solves
  Eigen::SparseMatrix<double> columns_;
  Eigen::SparseMatrix<double, Eigen::RowMajor> equations_;
  Eigen::PartialPivLU<Eigen::MatrixXd> factor_;
  std::optional<BalancedInverse> balanced_;
};

FrictionSystem::FrictionSystem(const ContactProblem& problem) : problem_(problem), rows_(problem) {}
FrictionSystem::~FrictionSystem() = default;

void FrictionSystem::flexibility_changed() {
  factors_.clear();
  rows_ = FrictionRows(problem_);
}

const FrictionSystem::Factor& FrictionSystem::factor(const Linearization& at) {
  const auto found = std::ranges::find_if(factors_, [&](const auto& one) { return one->at() == at; });
  if (found != factors_.end()) {
    factors_.splice(factors_.begin(), factors_, found);
  } else {
    if (factors_.size() == n_factors) factors_.pop_back();
    factors_.push_front(std::make_unique<const Factor>(rows_, at));
  }
  return *factors_.front();
}

/// Preconditioner for flexibilities given as operators: rows in contact by that of the operator, without slip.
Inverse FrictionSystem::approximate_inverse(const Linearization& at) const {
  std::vector<int> closed;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const ContactNode& own = problem_.nodes[i];
    if (at[i].status == ContactStatus::open) continue;
    for (int row = own.first_row; row < own.first_row + own.n_rows; ++row)
      if (rows_.is_movable(row)) closed.push_back(row);
  }
  std::shared_ptr<Preconditioner> inner = problem_.large->preconditioner(closed, problem_.compliance_on(closed));
  return [this, at, closed, inner](const Eigen::VectorXd& right) {
    Eigen::VectorXd result = right;
    for (Index row = 0; row < result.size(); ++row) result[row] /= rows_.flexibility(static_cast<int>(row));
    // Gaps of slipping nodes are unknown along the traction and given across it.
    Eigen::VectorXd gap = right;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const FrictionRows::Tangents& tangential = rows_.tangents(i);
      if (at[i].status != ContactStatus::slip || tangential.n == 0) continue;
      const double across = tangential.n == 2 ? right[tangential.rows[1]] / at[i].equation.norm() : 0.0;
      for (int k = 0; k < tangential.n; ++k)
        gap[tangential.rows[k]] = tangential.n == 2 ? across * turned(at[i].direction)[k] : 0.0;
    }
    const Eigen::VectorXd inside = inner->multipliers(gap(closed));
    result(closed) = inside;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const FrictionRows::Tangents& tangential = rows_.tangents(i);
      if (at[i].status != ContactStatus::slip || tangential.n == 0) continue;
      const Eigen::Vector2d& e = at[i].direction;
      Eigen::Vector2d tau = tangential.of(result);
      const double along =
          right[tangential.rows[0]] / tangential.flexibility + at[i].friction * result[problem_.nodes[i].first_row];
      double across = 0;
      if (tangential.n == 2) across = turned(e).dot(tau) / (1 + at[i].flexibility / tangential.flexibility);
      tau = along * e + across * turned(e);
      for (int k = 0; k < tangential.n; ++k) result[tangential.rows[k]] = tau[tangential.components[k]];
    }
    return result;
  };
}

FrictionSystem::Solution FrictionSystem::solve_held(const Linearization& at, const Linearization& factored,
                                                    const Eigen::VectorXd& right, double tolerance) {
  const auto product = [&](const Eigen::VectorXd& v) {
    stop_.heed();
    return rows_.equations(at, v, rows_.gaps(v));
  };
  if (problem_.large != nullptr) {
    const GmresResult found = gmres(product, approximate_inverse(at), right, tolerance, max_gmres_large);
    if (!found.converged) throw SolverError("contact: the iteration for the shear tractions did not converge");
    return {found.solution, {}, found.iterations};
  }
  if (!factored.empty() && factored != at) {
    const Factor& near = factor(factored);
    const GmresResult found = gmres(
        product, [&](const Eigen::VectorXd& v) { return near.solve(v); }, right, tolerance, max_gmres);
    if (found.converged) return {found.solution, {}, found.iterations};
  }
  return {factor(at).solve(right), {}, factored.empty() || factored == at ? 0 : max_gmres};
}

FrictionSystem::Solution FrictionSystem::solve(const Linearization& at, const Linearization& factored,
                                               const Eigen::VectorXd& right, const Eigen::VectorXd& resultant,
                                               double tolerance) {
  const Index n = problem_.n_rows(), m = problem_.n_motions();
  if (m == 0) return solve_held(at, factored, right, tolerance);
  const bool is_large = problem_.large != nullptr;
  const bool is_near = !is_large && !factored.empty() && factored != at && factor(factored).balanced().is_regular();
  if (is_large || is_near) {
    std::optional<BalancedInverse> approximate;
    if (is_large) approximate.emplace(rows_, at, approximate_inverse(at), false);
    const BalancedInverse& near = is_large ? *approximate : factor(factored).balanced();
    const Eigen::MatrixXd motions = rows_.motions(at);
    const double scale = std::sqrt(problem_.rigid.squaredNorm() / static_cast<double>(n)) / rows_.spring();
    const auto joined = [&](const Eigen::VectorXd& rows, const Eigen::VectorXd& forces) {
      Eigen::VectorXd both(n + m);
      both << rows, scale * forces;  // like gaps
      return both;
    };
    const auto product = [&](const Eigen::VectorXd& v) {
      stop_.heed();
      const Eigen::VectorXd multiplier = v.head(n);
      const Eigen::VectorXd left = rows_.equations(at, multiplier, flexibility_product(problem_, multiplier));
      return joined(left + motions * v.tail(m), problem_.rigid.transpose() * multiplier);
    };
    const auto precondition = [&](const Eigen::VectorXd& v) {
      Eigen::VectorXd rigid, result(n + m);
      const Eigen::VectorXd multiplier = near.solve(v.head(n), v.tail(m) / scale, rigid);
      result << multiplier, rigid;
      return result;
    };
    const GmresResult found =
        gmres(product, precondition, joined(right, resultant), tolerance, is_large ? max_gmres_large : max_gmres);
    if (is_large && !found.converged)
      throw SolverError("contact: the iteration for the shear tractions did not converge");
    if (found.converged) return {found.solution.head(n), found.solution.tail(m), found.iterations};
  }
  Solution result{{}, {}, factored.empty() || factored == at ? 0 : max_gmres};
  result.multiplier = factor(at).balanced().solve(right, resultant, result.rigid);
  return result;
}

}  // namespace creepcontact::contact
