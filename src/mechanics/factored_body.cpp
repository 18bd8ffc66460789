#include "creepcontact/mechanics/factored_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/linalg/dense.hpp"
#include "creepcontact/mechanics/rigid_motion.hpp"
#include "hourglass.hpp"

namespace creepcontact::mechanics {
namespace {

/// A type of the body's elements that may need stiffness against hourglass modes.
std::optional<mesh::CellType> type_with_hourglass_modes(const mesh::Mesh& mesh) {
  for (const mesh::CellBlock& block : mesh.blocks)
    if (mesh.is_bulk(block.type) && block.size() > 0 && has_hourglass_modes(block.type)) return block.type;
  return std::nullopt;
}

void add_own_hourglass_stiffness(const Body& body, const Eigen::VectorXd& diagonal, linalg::SparseMatrix& lower) {
  if (const auto& own = body.own_elements())
    add_hourglass_stiffness(some_elements(body.mesh(), *own), diagonal, lower);
  else
    add_hourglass_stiffness(body.mesh(), diagonal, lower);
}

}  // namespace

FactoredBody::FactoredBody(const Body& body, const BodyConditions& at, const std::vector<std::int64_t>& trailing,
                           const linalg::StiffnessSolverFactory& make_solver)
    : body_(&body), time_(at.time) {
  const auto assembled = [&]() -> const linalg::SparseMatrix& {
    if (!analyzed_) analyzed_ = std::make_unique<linalg::SparseMatrix>(stiffness(at));
    return *analyzed_;
  };
  solver_ = make_solver({linalg::MatrixOnDemand(assembled, body.stiffness_inputs(at)),
                         body.constraints().node_of_free(), trailing, [&body] {
                           Eigen::MatrixXd motions = rigid_motions_on_free(body.mesh().nodes, body.constraints());
                           for (const std::int64_t pin : body.fixing_dofs()) motions.row(pin).setZero();
                           return motions;
                         }});
}

void FactoredBody::factorize(const BodyConditions& at) {
  const std::unique_ptr<const linalg::SparseMatrix> analyzed = std::move(analyzed_);
  const bool is_analyzed = !factored_ && time_ == at.time;
  try {
    if (!is_analyzed || !solver_->take_factor()) {
      if (is_analyzed && analyzed != nullptr)
        solver_->factorize(*analyzed);
      else
        solver_->factorize(stiffness(at));
    }
  } catch (const linalg::SingularMatrix& error) {
    if (factored_ || !type_with_hourglass_modes(body_->mesh())) report_singular(error);
    stabilize(at);
  }
  moduli_ = at.moduli;
  matrices_ = at.matrices;
  time_ = at.time;
  factored_ = true;
}

void FactoredBody::stabilize(const BodyConditions& at) {
  linalg::SparseMatrix all = body_->full_stiffness(at);
  hourglass_diagonal_ = all.diagonal();
  all.coeffs().setZero();
  add_own_hourglass_stiffness(*body_, hourglass_diagonal_, all);
  hourglass_ = body_->on_free_unknowns(all).pruned();
  stabilized_ = true;
  try {
    solver_->factorize(stiffness(at));
  } catch (const linalg::SingularMatrix& error) {
    report_singular(error);
  }
  log::warning(
      "body '{}': {} elements form single rows, where their reduced integration allows hourglass modes; a millionth "
      "of their stiffness is added against these modes",
      body_->name(), mesh::name(*type_with_hourglass_modes(body_->mesh())));
}

linalg::SparseMatrix FactoredBody::stiffness(const BodyConditions& at) const {
  linalg::SparseMatrix all = body_->full_stiffness(at);
  if (stabilized_) add_own_hourglass_stiffness(*body_, hourglass_diagonal_, all);
  return body_->on_free_unknowns(all);
}

linalg::SparseMatrix FactoredBody::stiffness(std::span<const Matrix6> moduli) const {
  linalg::SparseMatrix all = body_->discretization().stiffness(moduli);
  // The elastic one also here: it represents no material, and creep does not relax it.
  if (stabilized_) add_own_hourglass_stiffness(*body_, hourglass_diagonal_, all);
  return body_->on_free_unknowns(all);
}

std::pair<double, double> FactoredBody::stiffness_ratio(const BodyConditions& at) const {
  if (!body_->stiffness_changes() || time_ == at.time) return {1.0, 1.0};
  const auto bulk = [](const Moduli& h) { return h.lambda + 2.0 / 3.0 * h.mu; };
  double least = std::numeric_limits<double>::infinity(), largest = 0;
  for (std::size_t p = 0; p < at.matrices.size(); ++p) {
    const Tensor6 ratios = linalg::eigenvalue_ratios(at.matrices[p], matrices_[p]);
    least = std::min(least, ratios[0]);
    largest = std::max(largest, ratios[5]);
  }
  for (std::size_t p = 0; at.matrices.empty() && p < at.moduli.size(); ++p) {
    const Moduli &now = at.moduli[p], &then = moduli_[p];
    for (const double ratio : {now.mu / then.mu, bulk(now) / bulk(then)}) {
      least = std::min(least, ratio);
      largest = std::max(largest, ratio);
    }
  }
  return {least, largest};
}

void FactoredBody::residual(std::span<const double> external, std::span<const double> stress,
                            std::span<const double> free, std::span<double> residual) const {
  body_->residual(external, stress, residual);
  if (!stabilized_) return;
  const Index n = free.size();
  Eigen::Map<Eigen::VectorXd>(residual.data(), n) -=
      hourglass_.selfadjointView<Eigen::Lower>() * Eigen::Map<const Eigen::VectorXd>(free.data(), n);
}

void FactoredBody::report_singular(const linalg::SingularMatrix& error) const {
  const Constraints& constraints = body_->constraints();
  std::string position;
  if (error.row >= 0 && error.row < constraints.n_free()) {
    const std::int64_t node = constraints.node_of_free()[error.row];
    const Vector3& x = body_->mesh().nodes[node];
    position = fmt::format(" at the node ({:.6g}, {:.6g}, {:.6g})", x[0], x[1], x[2]);
  }
  throw ModelError(fmt::format(
      "body '{}': the stiffness is singular{} (reciprocal condition {:.2g}); a part of the body is attached at "
      "too few nodes, or the elements there are too thin or the material almost incompressible",
      body_->name(), position, error.rcond));
}

std::int64_t estimate_factor_bytes(const Body& body) {
  const FactoredBody factored(body, body.at(0), {});
  return factored.solver().factor_bytes() + factored.solver().work_bytes();
}

}  // namespace creepcontact::mechanics
