#pragma once
/// Heat conduction in all bodies together: C(T) dT/dt + K(T) T = q(t, T) at the nodes of the mechanical meshes, with
/// their shape functions, consistent capacities and full quadrature. Units are those of the data.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/contact/geometry/facing_points.hpp"
#include "creepcontact/linalg/stiffness_solver.hpp"
#include "creepcontact/mechanics/material_axes.hpp"
#include "creepcontact/mesh/mesh.hpp"
#include "creepcontact/ode/implicit_integrator.hpp"

namespace creepcontact::heat {

/// A body that conducts heat.
struct Conductor {
  std::string name;
  const mesh::Mesh* mesh = nullptr;    ///< must outlive the problem
  std::vector<Function> conductivity;  ///< of T: one, or three along the material axes
  std::optional<mechanics::MaterialAxes> axes;
  Function capacity;  ///< of T: heat per mass and degree; per volume and degree if the density is 1
  double density = 1;
};

/// What flows through a surface: inwards h (T_f - T), the flux, or sigma eps (T_a^4 - T^4) from absolute zero.
struct SurfaceFlow {
  enum class Kind { film, flux, radiation };
  Kind kind{};
  std::size_t body = 0;
  std::vector<mesh::Face> faces;
  Function factor;        ///< of x, y, z, t, T: h, the flux into the body, or eps sigma
  Function beyond;        ///< of x, y, z, t: temperature of the fluid or of the surroundings
  std::string name = {};  ///< for the balance
};

/// Heat that arises in a volume, per volume and time of the data.
struct Source {
  std::size_t body = 0;
  Function value;  ///< of x, y, z, t, T
  std::string name = {};
};

/// Nodes whose temperature is given.
struct GivenTemperature {
  std::size_t body = 0;
  std::vector<std::int64_t> nodes;
  Function value;  ///< of x, y, z, t
  std::string name = {};
};

struct BodyNode {
  std::size_t body = 0;
  std::int64_t node = 0;
};

/// Heat that flows into each of some nodes, per time of the data. Nodes that share a temperature count once.
struct PointFlow {
  std::vector<BodyNode> nodes;
  Function value;  ///< of x, y, z, t
  std::string name = {};
};

/// What presses or parts the surfaces of contacts, at the nodes of contact in their order.
struct ContactAtNodes {
  std::span<const double> pressure, gap;  ///< >= 0
};

/// Heat flows across the points of two surfaces by conductance times the difference of their temperatures.
struct Interface {
  std::string name;
  std::size_t first = 0, second = 0;  ///< bodies
  std::vector<contact::FacingFaces> faces;
  Function conductance;     ///< of x, y, z, t, T, the mean of both temperatures; unless it is perfect:
  bool is_perfect = false;  ///< 1000 times the conductivity over the size of the faces
  /// Given if the conductance depends on p or gap: for each node of the first mesh its number in ContactAtNodes, or -1.
  /// Both are interpolated linearly between the corners of faces. Where no corner of a face is a node of contact, no
  /// heat flows.
  std::vector<int> contact_nodes = {};
  double linear_below = 0;  ///< pressure below which the conductance is taken linear in p, so that its slope is finite
};

struct Definition {
  std::vector<Conductor> bodies;
  std::vector<SurfaceFlow> flows;
  std::vector<Source> sources;
  std::vector<PointFlow> point_flows;
  std::vector<GivenTemperature> given;
  std::vector<Interface> interfaces;
  std::vector<std::pair<BodyNode, BodyNode>> equal;  ///< nodes of one temperature
  double time_unit = 1;                              ///< of t, in the unit of time of the data
  double absolute_zero = 0;                          ///< for radiation
};

/// Heat per time of the data.
struct Balance {
  std::vector<double> flows;       ///< into the bodies, as Definition::flows
  std::vector<double> sources;     ///< as Definition::sources
  std::vector<double> points;      ///< as Definition::point_flows
  std::vector<double> given;       ///< that the given temperatures need, as Definition::given
  std::vector<double> interfaces;  ///< from the first to the second body, as Definition::interfaces
  double stored = 0;               ///< in the capacities
  /// Sum of all that flows in, less what is stored: zero but for the errors of the solution.
  double rest() const;
};

/// One unknown per temperature; nodes that share one have it together. The symmetric part of the Jacobian is factored
/// (linalg::default_stiffness_solver), without derivatives of conductivities and coefficients. The factor is kept for
/// others near it, which conjugate gradients solve.
class Conduction final : public ode::ImplicitSystem {
 public:
  /// @throws ModelError if a body has no conductivity
  explicit Conduction(Definition definition);
  ~Conduction() override;

  const Definition& definition() const;
  std::size_t size() const override;
  /// Numbers of the unknowns, by body and node.
  const std::vector<std::vector<int>>& unknown_of() const;
  /// Unknowns of these temperatures at all nodes.
  std::vector<double> unknowns(const Function& temperature) const;
  /// Unknowns of these temperatures of the nodes, by body.
  std::vector<double> unknowns(std::span<const std::vector<double>> at_nodes) const;
  /// Temperatures of the nodes of a body without its axial node.
  std::vector<double> at_nodes(std::size_t body, std::span<const double> unknowns) const;

  /// Times between which functions of t are smooth: derivatives of given temperatures do not look beyond them.
  void set_segment(double begin, double end);
  void residual(double t, std::span<const double> y, std::span<const double> rate, std::span<double> residual) override;
  void prepare(double t, std::span<const double> y, std::span<const double> rate, double c) override;
  void shift(double c) override;
  void solve(std::span<double> x, double tolerance) override;

  /// Steady temperatures at time t by Newton's method with a line search, to 1e-12 of the largest heat flow.
  /// @param y  in: start; out: the solution
  /// @throws ModelError naming a body that nothing holds at a temperature; SolverError without convergence
  void steady(double t, std::span<double> y, const ContactAtNodes& contact = {});
  /// Sets given temperatures in y, and the rates with which the equations hold at t.
  void make_consistent(double t, std::span<double> y, std::span<double> rate, const ContactAtNodes& contact = {});
  Balance balance(double t, std::span<const double> y, std::span<const double> rate,
                  const ContactAtNodes& contact = {}) const;
  /// The largest flow that one node at its temperature would make among others at zero: what is far smaller than that
  /// is rounding.
  double flow_scale(double t, std::span<const double> y, const ContactAtNodes& contact = {});

  /// The temperature is given there, whatever y says.
  bool is_given(std::size_t unknown) const;
  double given_value(std::size_t unknown, double t) const;
  double given_rate(std::size_t unknown, double t) const;
  /// What flows into the unknowns, q - K T; zero where the temperature is given.
  void inflow(double t, std::span<const double> y, const ContactAtNodes& contact, std::span<double> into);
  /// The lower triangle of conduction times K and capacity times C at these temperatures, with the largest entry
  /// of the diagonal where the temperature is given. It is valid until the next call of a non-const member.
  const linalg::SparseMatrix& matrix(double t, std::span<const double> y, const ContactAtNodes& contact,
                                     double conduction, double capacity);
  bool has_constant_capacity() const;

  std::size_t n_factorizations() const;
  /// Passes through the factors.
  std::size_t n_passes() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace creepcontact::heat
