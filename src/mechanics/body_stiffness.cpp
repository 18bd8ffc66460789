/// The stiffness of a body and its factor.

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "body_impl.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "hourglass.hpp"

namespace creepcontact::mechanics {

linalg::SparseMatrix Body::Impl::free_stiffness() const {
  linalg::SparseMatrix all = discretization.stiffness(isothermal());
  if (stabilized) add_hourglass_stiffness(mesh, hourglass_diagonal, all);
  return on_free_unknowns(all);
}

void Body::Impl::stabilize() {
  linalg::SparseMatrix all = discretization.stiffness(isothermal());
  hourglass_diagonal = all.diagonal();
  all.coeffs().setZero();
  add_hourglass_stiffness(mesh, hourglass_diagonal, all);
  hourglass = on_free_unknowns(all).pruned();
  stabilized = true;
}

void Body::Impl::factorize(const linalg::SparseMatrix& stiffness) {
  factor->factorize(stiffness);
  factored_moduli.assign(moduli.begin(), moduli.end());
  factor_time = *time;
}

/// The pins' rows and columns are emptied but for the diagonal.
linalg::SparseMatrix Body::Impl::on_free_unknowns(const linalg::SparseMatrix& all) const {
  linalg::SparseMatrix stiffness = constraints.reduce(all);
  if (pins.empty()) return stiffness;
  std::vector<char> pinned(static_cast<std::size_t>(constraints.n_free()), 0);
  for (const std::int64_t pin : pins) pinned[static_cast<std::size_t>(pin)] = 1;
  for (std::int64_t column = 0; column < stiffness.outerSize(); ++column)
    for (linalg::SparseMatrix::InnerIterator it(stiffness, column); it; ++it)
      if (it.row() != column &&
          (pinned[static_cast<std::size_t>(it.row())] || pinned[static_cast<std::size_t>(column)]))
        it.valueRef() = 0;
  return stiffness;
}

bool Body::Impl::has_hex20() const {
  return std::any_of(mesh.blocks.begin(), mesh.blocks.end(), [](const mesh::CellBlock& block) {
    return block.type == mesh::CellType::hex20 && block.size() > 0;
  });
}

void Body::Impl::report_singular(const linalg::SingularMatrix& error) const {
  const auto& node_of_free = constraints.node_of_free();
  const bool located = error.row >= 0 && error.row < constraints.n_free();
  std::string place;
  if (located) {
    const Vector3& x = mesh.nodes[static_cast<std::size_t>(node_of_free[static_cast<std::size_t>(error.row)])];
    place = fmt::format(" at the node ({:.6g}, {:.6g}, {:.6g})", x[0], x[1], x[2]);
  }
  throw ModelError(
      fmt::format("body '{}': the stiffness is singular{} (reciprocal condition {:.2g}); a part of the body hangs on "
                  "too few nodes, or the elements there are too thin or the material almost incompressible",
                  name, place, error.rcond));
}

void Body::analyze(const std::vector<std::int64_t>& trailing) {
  impl_->analyzed = impl_->free_stiffness();
  impl_->factor.emplace(impl_->analyzed, impl_->constraints.node_of_free(), trailing);
}

void Body::factorize(const std::vector<std::int64_t>& trailing) {
  analyze(trailing);
  factorize();
}

void Body::factorize() {
  const linalg::SparseMatrix stiffness = std::exchange(impl_->analyzed, {});
  try {
    impl_->factorize(stiffness);
    return;
  } catch (const linalg::SingularMatrix& error) {
    if (!impl_->has_hex20()) impl_->report_singular(error);
  }
  impl_->stabilize();
  try {
    impl_->factorize(impl_->free_stiffness());
    log::warning(
        "body '{}': hex20 elements stand in single rows, where their reduced integration misses some motions; a "
        "millionth of "
        "their stiffness holds these",
        impl_->name);
  } catch (const linalg::SingularMatrix& error) {
    impl_->factor.reset();
    impl_->report_singular(error);
  }
}

bool Body::stiffness_changes() const {
  return impl_->thermal.moduli_change_in_time(impl_->material);
}

void Body::refactorize() {
  try {
    impl_->factorize(impl_->free_stiffness());
  } catch (const linalg::SingularMatrix& error) {
    impl_->report_singular(error);
  }
}

double Body::factor_time() const {
  return impl_->factor_time;
}

std::pair<double, double> Body::stiffness_ratio() const {
  if (!stiffness_changes() || impl_->factor_time == impl_->time) return {1.0, 1.0};
  const auto bulk = [](const Moduli& h) { return h.lambda + 2.0 / 3.0 * h.mu; };
  double least = std::numeric_limits<double>::infinity(), largest = 0;
  for (std::size_t p = 0; p < impl_->moduli.size(); ++p) {
    const Moduli &now = impl_->moduli[p], &then = impl_->factored_moduli[p];
    for (const double ratio : {now.mu / then.mu, bulk(now) / bulk(then)}) {
      least = std::min(least, ratio);
      largest = std::max(largest, ratio);
    }
  }
  return {least, largest};
}

std::int64_t Body::estimate_factor_bytes() const {
  const linalg::SupernodalCholesky factor(impl_->free_stiffness(), impl_->constraints.node_of_free(), {});
  return factor.factor_bytes() + factor.work_bytes();
}

linalg::SparseMatrix Body::stiffness() const {
  return impl_->free_stiffness();
}

linalg::SparseMatrix Body::stiffness(std::span<const Matrix6> moduli) const {
  linalg::SparseMatrix all = impl_->discretization.stiffness(moduli);
  // The elastic one also here: it stands for no material, and creep does not relax it.
  if (impl_->stabilized) add_hourglass_stiffness(impl_->mesh, impl_->hourglass_diagonal, all);
  return impl_->on_free_unknowns(all);
}

linalg::SupernodalCholesky& Body::factor() {
  return *impl_->factor;
}

ElasticState Body::factored() const {
  return {impl_->factored_moduli, {}};
}

}  // namespace creepcontact::mechanics
