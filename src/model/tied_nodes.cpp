#include "tied_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "creepcontact/base/disjoint_sets.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/linalg/independent_rows.hpp"

namespace creepcontact::model {
namespace {

using contact::RowMatrix;

constexpr double same_value = 1e-8;

/// Projector on what supports hold.
Matrix3 held_part(const mechanics::Body& body, std::int64_t node) {
  return Matrix3::Identity() - contact::free_part(body.constraints(), node);
}

std::vector<double> prescribed(const mechanics::Body& body, double t) {
  std::vector<double> all(body.constraints().n_full());
  body.constraints().prescribed(t, all);
  return all;
}

std::string place(const Vector3& x) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", x[0], x[1], x[2]);
}

}  // namespace

void require_same_supports(std::span<const contact::NodeTie> ties, const mechanics::Body& slave,
                           const mechanics::Body& master, std::span<const double> times) {
  if (!slave.constraints().has_nonzero_values() && !master.constraints().has_nonzero_values()) return;
  std::vector<std::pair<const contact::NodeTie*, Matrix3>> held;
  for (const contact::NodeTie& tie : ties) {
    const Matrix3 both = held_part(slave, tie.slave) * held_part(master, tie.master);
    if (!both.isZero(same_value)) held.emplace_back(&tie, both);
  }
  if (held.empty()) return;
  for (const double t : times) {
    const std::vector<double> of_slave = prescribed(slave, t), of_master = prescribed(master, t);
    for (const auto& [tie, both] : held) {
      const Vector3 u_slave = Vector3::Map(of_slave.data() + 3 * tie->slave),
                    u_master = Vector3::Map(of_master.data() + 3 * tie->master);
      if ((both * (u_slave - u_master)).norm() <= same_value * (u_slave.norm() + u_master.norm())) continue;
      throw ModelError(
          fmt::format("supports move the node {}, at which bodies '{}' and '{}' are tied, by {} and by {} at t = "
                      "{:.6g}; tied nodes need the same supports",
                      place(slave.mesh().nodes[static_cast<std::size_t>(tie->slave)]), slave.name(), master.name(),
                      place(u_slave), place(u_master), t));
    }
  }
}

namespace {

/// One row of a tie.
struct TieRow {
  std::size_t pair = 0;
  Index row = 0;  // in the coupling
};

/// The rows of all ties, and what depends on what.
class TieRows {
 public:
  TieRows(const Bodies& bodies, std::vector<contact::Pair>& pairs) : bodies_(bodies), pairs_(pairs) {
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      const contact::MortarCoupling& coupling = pairs[p].coupling;
      if (coupling.type != contact::ContactType::tied || pairs[p].gap_per_value.size() > 0) continue;
      const bool all = pairs[p].ties_nodes() && coupling.rows_per_node() == 1;  // by mesh.share_nodes
      const Index first = all ? 0 : coupling.n_rows() - 3 * std::ssize(coupling.ties);
      for (Index row = first; row < coupling.n_rows(); ++row)
        if (coupling.slave_rows.innerVector(row).nonZeros() + coupling.master_rows.innerVector(row).nonZeros() > 0)
          rows_.push_back({p, row});
    }
    if (!rows_.empty()) reduce();
  }

  /// Sets of rows that may depend on each other.
  std::vector<std::vector<int>> suspicious() const {
    const std::vector<char> is_free = rows_with_columns_of_their_own();
    DisjointSets sets(rows_.size());
    std::map<int, int> first_of_column;
    for (int r = 0; r < reduced_.outerSize(); ++r) {
      if (is_free[static_cast<std::size_t>(r)] != 0) continue;
      for (RowMatrix::InnerIterator it(reduced_, r); it; ++it)
        if (const auto [place, is_new] = first_of_column.try_emplace(static_cast<int>(it.col()), r); !is_new)
          sets.join(static_cast<std::size_t>(place->second), static_cast<std::size_t>(r));
    }
    std::map<std::size_t, std::vector<int>> members;
    for (int r = 0; r < reduced_.outerSize(); ++r)
      if (is_free[static_cast<std::size_t>(r)] == 0) members[sets.find(static_cast<std::size_t>(r))].push_back(r);
    std::vector<std::vector<int>> result;
    for (auto& [set, rows] : members) result.push_back(std::move(rows));
    return result;
  }

  /// @returns the rows among these that follow from the others
  std::vector<int> dependent(const std::vector<int>& among, std::span<const double> times) const {
    RowMatrix part(std::ssize(among), reduced_.cols());
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < among.size(); ++i)
      for (RowMatrix::InnerIterator it(reduced_, among[i]); it; ++it)
        entries.emplace_back(static_cast<int>(i), static_cast<int>(it.col()), it.value() / scale(among[i]));
    part.setFromTriplets(entries.begin(), entries.end());
    const linalg::IndependentRows found = linalg::independent_rows(part);
    if (found.dependent.empty()) return {};
    for (const double t : times) require_consistent(among, found, t);
    std::vector<int> result;
    for (const int i : found.dependent) result.push_back(among[static_cast<std::size_t>(i)]);
    return result;
  }

  void empty(const std::vector<int>& rows) {
    std::map<std::size_t, std::vector<char>> dropped;  // by pair: marks of its rows
    for (const int r : rows) {
      const TieRow& at = rows_[static_cast<std::size_t>(r)];
      auto& marks = dropped[at.pair];
      marks.resize(static_cast<std::size_t>(pairs_[at.pair].coupling.n_rows()), 0);
      marks[static_cast<std::size_t>(at.row)] = 1;
    }
    for (const auto& of_pair : dropped) {
      const std::vector<char>& marks = of_pair.second;
      contact::MortarCoupling& coupling = pairs_[of_pair.first].coupling;
      for (RowMatrix* matrix : {&coupling.slave_rows, &coupling.master_rows})
        matrix->prune([&](Index row, Index, double) { return marks[static_cast<std::size_t>(row)] == 0; });
    }
  }

 private:
  void reduce() {
    std::vector<Eigen::Triplet<double>> entries;
    Index first_free = 0;
    full_.resize(bodies_.size());
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      std::vector<Eigen::Triplet<double>> own;
      const auto add = [&](const RowMatrix& from, Index row, std::size_t number) {
        for (RowMatrix::InnerIterator it(from, row); it; ++it)
          own.emplace_back(static_cast<int>(number), static_cast<int>(it.col()), it.value());
      };
      for (std::size_t r = 0; r < rows_.size(); ++r) {
        const contact::Pair& pair = pairs_[rows_[r].pair];
        if (pair.slave_body == b) add(pair.coupling.slave_rows, rows_[r].row, r);
        if (pair.master_body == b) add(pair.coupling.master_rows, rows_[r].row, r);
      }
      full_[b].resize(std::ssize(rows_), 3 * std::ssize(bodies_[b].mesh().nodes));
      full_[b].setFromTriplets(own.begin(), own.end());
      const RowMatrix reduced = bodies_[b].constraints().reduce_rows(full_[b]);
      for (int r = 0; r < reduced.outerSize(); ++r)
        for (RowMatrix::InnerIterator it(reduced, r); it; ++it)
          if (std::abs(it.value()) > nothing * scale(r))
            entries.emplace_back(r, static_cast<int>(first_free + it.col()), it.value());
      first_free += bodies_[b].constraints().n_free();
    }
    reduced_.resize(std::ssize(rows_), first_free);
    reduced_.setFromTriplets(entries.begin(), entries.end());
  }

  /// Area of the row's node.
  double scale(int row) const {
    const TieRow& at = rows_[static_cast<std::size_t>(row)];
    const contact::MortarCoupling& coupling = pairs_[at.pair].coupling;
    return coupling.area[static_cast<std::size_t>(at.row / coupling.rows_per_node())];
  }

  /// A row with a displacement that no other row has depends on none; without it, others may have one.
  std::vector<char> rows_with_columns_of_their_own() const {
    std::map<int, std::vector<int>> rows_of;
    for (int r = 0; r < reduced_.outerSize(); ++r)
      for (RowMatrix::InnerIterator it(reduced_, r); it; ++it) rows_of[static_cast<int>(it.col())].push_back(r);
    std::vector<char> is_free(rows_.size(), 0);
    std::vector<int> next;
    std::map<int, int> left;  // rows by column
    for (const auto& [column, rows] : rows_of) {
      left[column] = static_cast<int>(rows.size());
      if (rows.size() == 1) next.push_back(column);
    }
    while (!next.empty()) {
      const int column = next.back();
      next.pop_back();
      for (const int r : rows_of.at(column)) {
        if (is_free[static_cast<std::size_t>(r)] != 0) continue;
        is_free[static_cast<std::size_t>(r)] = 1;
        for (RowMatrix::InnerIterator it(reduced_, r); it; ++it)
          if (--left.at(static_cast<int>(it.col())) == 1) next.push_back(static_cast<int>(it.col()));
      }
    }
    return is_free;
  }

  void require_consistent(const std::vector<int>& among, const linalg::IndependentRows& found, double t) const {
    Eigen::VectorXd moved = Eigen::VectorXd::Zero(std::ssize(rows_));
    bool moves = false;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      std::vector<double> all(bodies_[b].constraints().n_full());
      if (!bodies_[b].constraints().prescribed(t, all)) continue;
      moves = true;
      moved += full_[b] * Eigen::Map<const Eigen::VectorXd>(all.data(), std::ssize(all));
    }
    if (!moves) return;
    for (std::size_t i = 0; i < found.dependent.size(); ++i) {
      const auto value = [&](int local) {
        const int row = among[static_cast<std::size_t>(local)];
        return moved[row] / scale(row);
      };
      double implied = 0, size = std::abs(value(found.dependent[i]));
      for (std::size_t j = 0; j < found.independent.size(); ++j) {
        const double part =
            found.combination(static_cast<Index>(i), static_cast<Index>(j)) * value(found.independent[j]);
        implied += part;
        size += std::abs(part);
      }
      if (std::abs(implied - value(found.dependent[i])) <= same_value * size) continue;
      const TieRow& at = rows_[static_cast<std::size_t>(among[static_cast<std::size_t>(found.dependent[i])])];
      const contact::Pair& pair = pairs_[at.pair];
      const std::int64_t node =
          pair.coupling.nodes[static_cast<std::size_t>(at.row / pair.coupling.rows_per_node())].node;
      throw ModelError(
          fmt::format("supports move bodies that are tied at the node {} of body '{}' apart at t = {:.6g}; tied nodes "
                      "need the same supports",
                      place(bodies_[pair.slave_body].mesh().nodes[static_cast<std::size_t>(node)]),
                      bodies_[pair.slave_body].name(), t));
    }
  }

  static constexpr double nothing = 1e-12;  // of a row's scale: rounding
  const Bodies& bodies_;
  std::vector<contact::Pair>& pairs_;
  std::vector<TieRow> rows_;
  std::vector<RowMatrix> full_;  // by body: all rows on its displacements
  RowMatrix reduced_;            // on the free displacements of all bodies
};

}  // namespace

void leave_out_dependent_ties(const Bodies& bodies, std::span<const double> times, std::vector<contact::Pair>& pairs) {
  TieRows rows(bodies, pairs);
  std::vector<int> left_out;
  for (const std::vector<int>& among : rows.suspicious()) {
    const std::vector<int> found = rows.dependent(among, times);
    left_out.insert(left_out.end(), found.begin(), found.end());
  }
  if (left_out.empty()) return;
  rows.empty(left_out);
  log::info("{} conditions at tied nodes follow from supports, links and other ties", left_out.size());
}

}  // namespace creepcontact::model
