#pragma once
/// A contact pair: two surfaces of two bodies, ties between their nodes, or equations between displacements.

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "creepcontact/base/index.hpp"
#include "creepcontact/contact/friction_coefficient.hpp"
#include "creepcontact/contact/gasket.hpp"
#include "creepcontact/contact/geometry/mortar.hpp"

namespace creepcontact::contact {

/// A normal force that a contact is given by an interference.
struct Preload {
  double force = 0;  ///< > 0: pressure times area of a unilateral contact, tension across a tied one
  double time = 0;   ///< at which it is applied; the interference found then is kept
};

/// Plain values; bodies are given by their index in the model.
struct Pair {
  std::string name;
  std::string slave_surface, master_surface;  ///< both empty for node ties and equations
  std::size_t slave_body = 0, master_body = 0;
  MortarCoupling coupling;
  Function gap;                        ///< given initial gap [length], used unless ...
  bool geometric_gap = false;          ///< ... it is measured from the meshes
  Eigen::VectorXd gap_per_value = {};  ///< of equations, whose value is `gap` (equation_rows.hpp); else empty
  std::shared_ptr<const Gasket> gasket = nullptr;  ///< between the surfaces of a contact that is not tied; null: none
  FrictionCoefficient friction = {};               ///< one value per multiplier node; used if the coupling has friction
  std::optional<Preload> preload = {};
  double from = -std::numeric_limits<double>::infinity();  ///< of tied pairs: they act from this time on ...
  double until = std::numeric_limits<double>::infinity();  ///< ... up to this one, which is no longer among them
  bool is_relative = false;  ///< of equations that act from a time on: their value counts from what is reached then
  Index first_row = 0;       ///< number of the first row among those of all pairs
  Index first_node = 0;      ///< likewise of the first multiplier node

  bool acts_always() const { return std::isinf(from) && std::isinf(until); }
  bool acts(double t) const { return t >= from && t < until; }
  bool ties_nodes() const { return slave_surface.empty(); }
  /// Weighted initial gaps, n_rows of the coupling; with a gasket those from its surface as it has grown by
  /// temperature.
  Eigen::VectorXd initial_gap(double t) const;
  /// Change of the weighted gaps per unit of interference, n_rows of the coupling: a unilateral contact overlaps by it,
  /// the surfaces of a tied one are drawn together over this distance along their mean normal. The normal force of a
  /// preload is minus its product with the multipliers.
  Eigen::VectorXd interference_gap() const;
};

/// Sets first_row and first_node of all pairs. @returns the number of rows of all pairs
Index number_rows(std::vector<Pair>& pairs);

/// Marks the rows of pairs that do not act at time t; empty if all pairs always act. They are numbered.
std::vector<char> idle_rows(std::span<const Pair> pairs, double t);

/// The contact rows of one body from all pairs, rows.size() x 3 n_nodes. @param rows  overwritten with their numbers
RowMatrix body_rows(std::span<const Pair> pairs, std::size_t body, std::size_t n_nodes, std::vector<int>& rows);

}  // namespace creepcontact::contact
