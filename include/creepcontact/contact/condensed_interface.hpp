#pragma once
/// All contact pairs condensed onto their multipliers. With the contact unknowns eliminated last, K = L L^T, and rows B
/// of a body's weighted gaps, G = L22^-1 B^T holds all that contact needs:
///   y = L^-1 f,   gap = initial gap + G^T y2,   contact forces: y2 += G lambda,   u = L^-T y,   F = G^T G.
/// So contact costs no pass through the factor of its own.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "creepcontact/contact/mortar.hpp"
#include "creepcontact/contact/problem.hpp"
#include "creepcontact/mechanics/body.hpp"

namespace creepcontact::contact {

/// Two surfaces in contact, by bodies.
struct Pair {
  std::string name;
  std::string slave_surface, master_surface;
  std::size_t slave_body = 0, master_body = 0;
  MortarCoupling coupling;
  Function gap;                ///< given initial gap ...
  bool geometric_gap = false;  ///< ... or the one measured from the meshes
  int first_row = 0;           ///< in the multipliers of all pairs; set by CondensedInterface
};

class CondensedInterface {
 public:
  /// Factorises every body with its contact unknowns last. @param bodies must outlive the object
  /// @throws ModelError as Body::factorize
  /// Cost: the factorisations, and n_contact^2 x n_rows operations a body.
  CondensedInterface(std::span<const std::unique_ptr<mechanics::Body>> bodies, std::vector<Pair> pairs);

  const std::vector<Pair>& pairs() const { return pairs_; }
  const ContactProblem& problem() const { return problem_; }
  int n_rows() const { return problem_.n_rows(); }

  /// Weighted gaps without creep, loads and contact: given gap and prescribed displacements at the bodies' set time.
  Eigen::VectorXd initial_gap(double t) const;
  /// gap += G^T y2. @param y  L^-1 P f of the body, all free unknowns
  void add_trace(std::size_t body, std::span<const double> y, Eigen::VectorXd& gap) const;
  /// y2 += G lambda
  void add_multipliers(std::size_t body, const Eigen::VectorXd& multiplier, std::span<double> y) const;
  /// Nodal forces of the multipliers on a body, 3 n_nodes, added.
  void add_contact_forces(std::size_t body, const Eigen::VectorXd& multiplier, std::span<double> forces) const;
  /// Bytes of the dense interface matrices.
  std::size_t bytes() const;

 private:
  struct Side {
    std::vector<int> rows;
    RowMatrix full_rows;     // rows.size() x 3 n_nodes
    Eigen::MatrixXd traces;  // G, n_trailing x rows.size()
  };
  std::span<const std::unique_ptr<mechanics::Body>> bodies_;
  std::vector<Pair> pairs_;
  std::vector<Side> sides_;
  ContactProblem problem_;
};

/// Free unknowns of a body that its contact rows touch, ascending: what must be eliminated last.
std::vector<std::int64_t> contact_unknowns(const mechanics::Body& body, const RowMatrix& full_rows);
/// The contact rows of one body, those of all pairs stacked; `rows` receives their numbers.
RowMatrix body_rows(const std::vector<Pair>& pairs, std::size_t body, std::size_t n_nodes, std::vector<int>& rows);

}  // namespace creepcontact::contact
