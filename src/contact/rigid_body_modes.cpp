#include "creepcontact/contact/rigid_body_modes.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "creepcontact/linalg/dense.hpp"

namespace creepcontact::contact {
namespace {

constexpr double unconstrained_rate = 1e-8;  // rounding of the contact rows
constexpr double sliding_rate = 3e-3;        // relative gap that facets open where a surface slides in itself
constexpr double min_part = 1e-6;            // of an amplitude in a description
constexpr double min_amplitude = 1e-10;      // of the largest amplitude: round-off of the decomposition

using mechanics::FreeMotion;
using mechanics::RigidMotion;

double size_of(const mechanics::Body& body) {
  Eigen::AlignedBox3d box;
  for (const Vector3& x : body.mesh().nodes) box.extend(x);
  return box.diagonal().norm();
}

/// The body's part of a combination; nullopt if it moves in parts.
std::optional<RigidMotion> rigid_part(const std::vector<FreeMotion>& motions, const Eigen::VectorXd& amplitudes) {
  std::vector<RigidMotion> rigid;
  for (const FreeMotion& motion : motions) {
    if (!motion.rigid) return std::nullopt;
    rigid.push_back(*motion.rigid);
  }
  return RigidMotion::combination(rigid, amplitudes);
}

/// Spans the same space, unit vectors first: the combinations then read as motions of single bodies where they can.
Eigen::MatrixXd readable_basis(const Eigen::MatrixXd& basis) {
  Eigen::MatrixXd rest = basis, result(basis.rows(), 0);
  const auto take = [&](const Eigen::VectorXd& v) {
    result.conservativeResize(Eigen::NoChange, result.cols() + 1);
    result.rightCols(1) = v;
  };
  for (Index j = 0; j < basis.rows(); ++j) {
    const Eigen::VectorXd unit = Eigen::VectorXd::Unit(basis.rows(), j);
    if ((basis * (basis.transpose() * unit) - unit).norm() < min_part) take(unit);
  }
  if (result.cols() < basis.cols()) {
    rest -= result * (result.transpose() * rest);
    const Eigen::MatrixXd left = linalg::singular_values(rest).left;
    for (Index j = 0; result.cols() < basis.cols(); ++j) take(left.col(j));
  }
  return result;
}

/// Bodies that a combination does not move take no part in it: times the loads on them, round-off would be work.
Eigen::MatrixXd without_round_off(const Eigen::MatrixXd& basis) {
  Eigen::MatrixXd result = basis;
  for (Index j = 0; j < result.cols(); ++j) {
    const double least = min_amplitude * result.col(j).cwiseAbs().maxCoeff();
    for (double& part : result.col(j))
      if (std::abs(part) < least) part = 0;
  }
  return result;
}

}  // namespace

RigidBodyModes::RigidBodyModes(Bodies bodies, std::span<const Pair> pairs) : bodies_(bodies) {
  std::size_t n_motions = 0;
  for (const auto& body : bodies) {
    first_.push_back(n_motions);
    n_motions += body.free_motions().size();
  }
  const Index n = n_motions;
  rates_.setZero(n, n);
  sliding_rates_ = rates_;
  if (n == 0) return;
  Index n_rows = 0;
  std::vector<int> resisting;  // rows, without those of friction
  Eigen::VectorXd scale;       // makes gaps of weighted rows, and of those their part in the mean of the pair
  for (const Pair& pair : pairs) {
    const Index width = pair.coupling.n_rows() / std::ssize(pair.coupling.nodes);
    double total = 0;
    for (const double area : pair.coupling.area) total += area;
    n_rows += pair.coupling.n_rows();
    scale.conservativeResize(n_rows);
    for (int r = 0; r < pair.coupling.n_rows(); ++r) {
      scale[pair.first_row + r] = 1 / std::sqrt(pair.coupling.area[r / width] * total);
      if (!pair.coupling.has_friction() || r % width == 0) resisting.push_back(static_cast<int>(pair.first_row) + r);
    }
  }
  Eigen::MatrixXd rates(n_rows, n);
  for (std::size_t b = 0; b < bodies.size(); ++b)
    rates.middleCols(first_[b], bodies[b].free_motions().size()) = scale.asDiagonal() * gaps(b, pairs);
  if (n_rows > 0) {
    rates_.topRows(std::min<Index>(n_rows, n)) = linalg::triangular_factor(rates);
    sliding_rates_.topRows(std::min<Index>(std::ssize(resisting), n)) =
        linalg::triangular_factor(Eigen::MatrixXd(rates(resisting, Eigen::all)));
  }
  unconstrained_ = without_round_off(readable_basis(combinations_below(rates_, unconstrained_rate, &held_)));
  held_ = without_round_off(held_);
}

void RigidBodyModes::require_contact(std::span<const Pair> pairs) const {
  std::string unheld;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const bool in_contact = std::any_of(
        pairs.begin(), pairs.end(), [&](const Pair& pair) { return pair.slave_body == b || pair.master_body == b; });
    if (in_contact || bodies_[b].free_motions().empty()) continue;
    std::string list;
    for (const FreeMotion& motion : bodies_[b].free_motions()) list += (list.empty() ? "" : ", ") + motion.description;
    unheld += fmt::format("{}body '{}' can move freely: {}; add supports, or a contact that holds it",
                          unheld.empty() ? "" : "\n", bodies_[b].name(), list);
  }
  if (!unheld.empty()) throw ModelError(unheld);
}

Eigen::MatrixXd RigidBodyModes::combinations_below(const Eigen::MatrixXd& rates, double limit,
                                                   Eigen::MatrixXd* others) {
  const auto [values, vectors] = linalg::right_singular_vectors(rates);
  const Index above = (values.array() >= limit).count();
  if (others != nullptr) *others = vectors.leftCols(above);
  return vectors.rightCols(rates.cols() - above);
}

Eigen::MatrixXd RigidBodyModes::gaps(std::size_t body, std::span<const Pair> pairs) const {
  const auto& motions = bodies_[body].free_motions();
  Index n_rows = 0;
  for (const Pair& pair : pairs) n_rows += pair.coupling.n_rows();
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n_rows, motions.size());
  for (std::size_t j = 0; j < motions.size(); ++j)
    for (const Pair& pair : pairs) {
      auto part = result.col(j).segment(pair.first_row, pair.coupling.n_rows());
      if (pair.slave_body == body) part += pair.coupling.slave_rows * motions[j].displacement;
      if (pair.master_body == body) part += pair.coupling.master_rows * motions[j].displacement;
    }
  return result;
}

std::string RigidBodyModes::describe(const Eigen::VectorXd& amplitudes) const {
  std::string text;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const auto& motions = bodies_[b].free_motions();
    Eigen::VectorXd own = amplitudes.segment(first_[b], std::ssize(motions));
    own = (own.array().abs() > min_part * amplitudes.cwiseAbs().maxCoeff()).select(own, 0.0);
    if (own.size() == 0 || own.isZero(0)) continue;
    std::string words;
    if (const auto rigid = rigid_part(motions, own)) {
      words = rigid->tidied(size_of(bodies_[b])).describe();
    } else {
      for (std::size_t j = 0; j < motions.size(); ++j)
        if (own[j] != 0 && words.find(motions[j].description) == std::string::npos)
          words += (words.empty() ? "" : " with ") + motions[j].description;
    }
    text += fmt::format("{}body '{}': {}", text.empty() ? "" : " and ", bodies_[b].name(), words);
  }
  return text;
}

std::vector<std::string> RigidBodyModes::describe_unconstrained() const {
  std::vector<std::string> result;
  for (Index j = 0; j < unconstrained_.cols(); ++j) {
    std::string words = describe(unconstrained_.col(j));
    if (std::find(result.begin(), result.end(), words) == result.end()) result.push_back(std::move(words));
  }
  return result;
}

namespace {

double largest_displacement(const RigidMotion& motion, const Pair& pair, const mesh::Mesh& slave) {
  double largest = 0;
  for (const MultiplierNode& at : pair.coupling.nodes)
    largest = std::max(largest, motion.displacement(slave.nodes[at.node]).norm());
  return largest;
}

}  // namespace

std::vector<std::vector<RigidMotion>> RigidBodyModes::sliding(std::span<const Pair> pairs) const {
  std::vector<std::vector<RigidMotion>> result(pairs.size());
  if (size() == 0) return result;
  const Eigen::MatrixXd combinations = combinations_below(sliding_rates_, sliding_rate, nullptr);
  if (combinations.cols() == combinations_below(sliding_rates_, unconstrained_rate, nullptr).cols())
    return result;  // unconstrained already
  for (std::size_t p = 0; p < pairs.size(); ++p)
    for (Index j = 0; j < combinations.cols(); ++j) {
      const auto part = [&](std::size_t b) {
        const auto& motions = bodies_[b].free_motions();
        return rigid_part(motions, combinations.col(j).segment(first_[b], std::ssize(motions)));
      };
      const auto master = part(pairs[p].master_body), slave = part(pairs[p].slave_body);
      if (!master || !slave) continue;
      const RigidMotion relative = RigidMotion::combination({*master, *slave}, Eigen::Vector2d(1, -1));
      const mesh::Mesh& mesh = bodies_[pairs[p].slave_body].mesh();
      const double size = largest_displacement(*master, pairs[p], mesh) + largest_displacement(*slave, pairs[p], mesh);
      // Bodies that move together do so to within the rate of what facets resist; the rest has no direction.
      if (largest_displacement(relative, pairs[p], mesh) > sliding_rate * size) result[p].push_back(relative);
    }
  return result;
}

}  // namespace creepcontact::contact
