#pragma once
/// The contact problem in the multipliers, condensed from all bodies. With the multipliers lambda (contact pressures)
/// and the amplitudes alpha of the rigid-body modes that only contact holds:
///   gap = initial gap + sum_b F_b lambda + N alpha,   N^T lambda + resultant = 0,
///   lambda >= 0, gap >= 0, lambda . gap = 0
/// These are the conditions of a unilateral node. Each node has an admissible set K of multipliers; tied nodes (all of
/// space) have gap = 0, and nodes with Coulomb friction (a cone) have, in addition to the conditions of the normal row,
///   |lambda_t| <= mu lambda_n,   gap_t = -gamma lambda_t,   gamma >= 0,   gamma (|lambda_t| - mu lambda_n) = 0
/// where gap_t is the slip since the last accepted step.
/// A gasket makes the pressure a function of the closure instead, see ClosureCurve; where it is one line, such
/// a node is unilateral with its compliance on the diagonal of F, which is how ContactProblem::compliance arises.
/// F_b is the flexibility of body b on its rows: the gaps that unit multipliers open by straining the body. In a body
/// held by contact alone, some fixing dofs are held in a statically determinate way. F_b depends on their choice, the
/// solution does not: since N^T lambda + resultant = 0, they carry no force.
/// Source: Farhat and Roux (1991), rigid-body modes of floating subdomains in dual form.

#include <Eigen/Core>
#include <vector>

#include "creepcontact/base/index.hpp"
#include "creepcontact/base/memory.hpp"
#include "creepcontact/contact/solver/closure_curve.hpp"
#include "creepcontact/contact/solver/flexibility_operator.hpp"

namespace creepcontact::contact {

/// Flexibility of one body on its contact rows.
struct Flexibility {
  std::vector<int> rows;   ///< numbers among all rows, ascending
  Eigen::MatrixXd matrix;  ///< rows.size() square, symmetric positive semidefinite; empty with an operator
};

/// Admissible multipliers of a node.
enum class AdmissibleSet {
  half_line,  ///< unilateral, without friction: lambda >= 0
  space,      ///< tied: all
  cone        ///< unilateral, with friction: |lambda_t| <= mu lambda_n
};

/// The rows of one multiplier node.
struct ContactNode {
  AdmissibleSet set = AdmissibleSet::half_line;
  int first_row = 0;
  int n_rows = 1;  ///< half_line: 1; space: any number; cone: the normal row and one or two tangential ones
  int slave_body = 0, master_body = 0;
  /// Integral of the node's test function [area] if a gasket or a spring is there; else 0. Tied nodes are springs that
  /// pull.
  double gasket_area = 0;

  bool has_gasket() const { return gasket_area > 0; }
  /// Rows whose gap vanishes where the node is closed: the first ones; a cone's tangential rows follow Coulomb's law.
  int n_closed() const { return set == AdmissibleSet::space ? n_rows : 1; }
};

/// All data that does not depend on the load. Owned by CondensedInterface; solvers refer to it.
struct ContactProblem {
  std::vector<Flexibility> bodies;
  std::vector<ContactNode> nodes;  ///< with ascending rows, without gaps in the numbering
  std::vector<int> node_of_row;    ///< index into `nodes`
  Eigen::MatrixXd total;           ///< sum of the flexibilities of the bodies, n_rows square; empty if `large` is set
  const FlexibilityOperator* large = nullptr;  ///< the flexibility as an operator, not owned, or null
  /// N, n_rows x n_motions (no columns if supports hold all bodies): the gaps opened by unit amplitudes, summed over
  /// the bodies. One mode may move several bodies.
  Eigen::MatrixXd rigid;
  /// Contribution of each body to N, rows of the body x n_motions.
  std::vector<Eigen::MatrixXd> rigid_of_body;
  /// What is added to the diagonal of F, n_rows, for what lies between the surfaces; empty: nothing.
  Eigen::VectorXd compliance = {};
  /// The problem whose `bodies` and `total` these are, which must outlive this one; null: its own.
  const ContactProblem* owner = nullptr;

  /// The flexibilities of the bodies and their sum, without `compliance`; not to be used if `large` is set.
  const std::vector<Flexibility>& of_bodies() const { return owner ? owner->bodies : bodies; }
  const Eigen::MatrixXd& flexibility() const { return owner ? owner->total : total; }
  /// The diagonal of `compliance` on these rows; zeros without it.
  Eigen::VectorXd compliance_on(const std::vector<int>& rows) const;

  Index n_rows() const { return std::ssize(node_of_row); }
  Index n_motions() const { return rigid.cols(); }
  const ContactNode& node(Index row) const { return nodes[node_of_row[row]]; }
  bool has_friction() const;
  bool has_gaskets() const;
  /// Appends a node with the next rows.
  void add_node(AdmissibleSet set, int n_rows, int slave_body, int master_body);
  /// Nodes and rigid-body modes of another problem, without the flexibilities.
  static ContactProblem with_nodes_of(const ContactProblem& other);
  /// A problem that differs by its `compliance`, n_rows. @param owner  must outlive the result
  static ContactProblem with_compliance(const ContactProblem& owner, Eigen::VectorXd compliance);
};

/// Coulomb's law at one time.
struct Friction {
  Eigen::VectorXd coefficient;  ///< mu >= 0, one per node of the problem; not used for nodes without friction
  /// Direction of the shear traction at the last accepted step at nodes that slipped in it, in their tangential rows;
  /// elsewhere zero. In solids the slip increment is then parallel to the mean of this direction and the present one,
  /// which makes the slip second-order accurate in time where its direction turns.
  Eigen::VectorXd direction;
};

/// The loads as the contact solver takes them.
struct ContactLoad {
  /// Weighted gaps without contact forces, n_rows; in tangential rows from the slip of the last accepted step.
  Eigen::VectorXd gap;
  Eigen::VectorXd resultant;  ///< work of the loads on unit rigid-body modes, n_motions; empty: zero
  Friction friction = {};     ///< empty unless the problem has friction
  /// One mark per row, or empty: tied rows that do not act at present; their multipliers are zero, whatever their gap.
  std::vector<char> idle = {};
  /// What the loads add up to along the motions if nothing cancels, n_motions: the scale of round-off in `resultant`.
  /// Empty: zero.
  Eigen::VectorXd force = {};
  /// Laws of the gaskets: one per node, empty in nodes without. Without gaskets an empty list.
  std::vector<ClosureCurve> curves = {};

  bool is_idle(Index row) const { return !idle.empty() && idle[static_cast<std::size_t>(row)] != 0; }
};

enum class ContactStatus { open, stick, slip };

/// Which linear equations a node with friction fulfils near a solution. With the tangential multipliers tau and gaps v:
///   open: all multipliers zero;   stick: gap = 0, v = 0
///   slip: gap = 0, e . tau = mu lambda_n, and (with two tangential rows) a . v + rho m . tau = 0, m = e turned by 90
///   degrees
struct NodeLinearization {
  ContactStatus status = ContactStatus::open;
  double friction = 0;                                  ///< mu
  Eigen::Vector2d direction = Eigen::Vector2d::Zero();  ///< e, unit vector
  Eigen::Vector2d equation = Eigen::Vector2d::Zero();   ///< a
  double flexibility = 0;                               ///< rho
  bool operator==(const NodeLinearization&) const = default;
  static constexpr auto members =
      std::tuple{Member{"status", &NodeLinearization::status}, Member{"friction", &NodeLinearization::friction},
                 Member{"direction", &NodeLinearization::direction}, Member{"equation", &NodeLinearization::equation},
                 Member{"flexibility", &NodeLinearization::flexibility}};
};

/// State of contact. All members empty: nothing known.
struct ContactState {
  Eigen::VectorXd multiplier;  ///< contact pressures and shear tractions, n_rows [force/area]
  Eigen::VectorXd rigid;       ///< amplitudes of the rigid-body modes, n_motions
  std::vector<int> active;     ///< rows in contact, ascending; their gaps are zero, but in nodes with a gasket
  /// One per node of the problem, if it has friction; otherwise empty. A node without friction that is open or closed
  /// has status open or stick, a tied one stick.
  std::vector<NodeLinearization> nodes = {};
  /// Equations whose factor serves later solves as preconditioner; those of some earlier state, or empty.
  std::vector<NodeLinearization> factored = {};
  Eigen::VectorXd image = {};  ///< F multiplier, with friction; empty: not known
  /// With gaskets: closure of their nodes, per node of the problem, and their compliance there
  /// (ContactProblem::compliance), per row; zero elsewhere. Else empty.
  Eigen::VectorXd closure = {}, compliance = {};
  static constexpr auto members =
      std::tuple{Member{"multiplier", &ContactState::multiplier}, Member{"rigid", &ContactState::rigid},
                 Member{"active", &ContactState::active},         Member{"nodes", &ContactState::nodes},
                 Member{"factored", &ContactState::factored},     Member{"image", &ContactState::image},
                 Member{"closure", &ContactState::closure},       Member{"compliance", &ContactState::compliance}};
};

/// Solution of a contact problem, and the work it took.
struct ContactResult {
  ContactState state;
  Eigen::VectorXd gap;  ///< weighted gaps of all rows in this state
  int iterations = 0;   ///< Schwarz sweeps or conjugate-gradient iterations; 0 for the active-set method
  int set_changes = 0;  ///< updates of the active set
  static constexpr auto members =
      std::tuple{Member{"state", &ContactResult::state}, Member{"gap", &ContactResult::gap},
                 Member{"iterations", &ContactResult::iterations}, Member{"set_changes", &ContactResult::set_changes}};
};

/// Thrown if no contact tractions can balance the loads. Not a std::exception: callers translate it. Along `motion`
/// (amplitudes of the rigid-body modes) no contact closes, and the loads do work.
struct UnbalancedLoad {
  Eigen::VectorXd motion;
  double force = 0;  ///< generalised force along `motion` that contact cannot balance; 0: not computed
};

/// Weighted gaps of all rows: load.gap + (F + compliance) lambda + N alpha
Eigen::VectorXd contact_gaps(const ContactProblem& problem, const ContactLoad& load, const ContactState& state);

/// (F + compliance) lambda
Eigen::VectorXd flexibility_product(const ContactProblem& problem, const Eigen::VectorXd& multiplier);
/// Diagonal of F + compliance; an estimate if F is an operator.
Eigen::VectorXd flexibility_diagonal(const ContactProblem& problem);

/// Gap that a unit multiplier opens at its own row, to convert gaps to multipliers. F_ii may vanish at the fixing dofs
/// of a body held by contact alone; a lower bound from the rigid-body modes is used there.
Eigen::VectorXd row_flexibility(const ContactProblem& problem);

/// Rows along which neither body can move, because supports hold both sides; ascending. Their multipliers are zero,
/// whatever their gap.
std::vector<int> immovable_rows(const ContactProblem& problem);

/// The factor c that makes F + c N N^T regular at the fixing dofs without introducing a new scale: trace F / |N|^2; 0
/// without rigid-body modes.
double fixing_flexibility(const ContactProblem& problem);

/// Round-off threshold below which a multiplier counts as zero: 1e-13 of the largest multiplier that closing the gaps
/// of the load would need, and 1e-12 of those that would carry ContactLoad::force.
double multiplier_rounding(const ContactProblem& problem, const ContactLoad& load);

/// Round-off threshold of resultants: what may remain unbalanced.
double resultant_rounding(const ContactLoad& load);

/// The next active set: rows with lambda_i - gap_i/F_ii > 0, and all tied ones that are not idle, ascending. Changes
/// below 1e-12 of the largest multiplier, or below `rounding`, are ignored. Tangential rows are left out.
/// @param current  ascending @param load  its idle rows are left out
std::vector<int> updated_set(const ContactProblem& problem, const ContactLoad& load, const std::vector<int>& current,
                             const Eigen::VectorXd& multiplier, const Eigen::VectorXd& gap, double rounding);

/// The first active set: that of the warm start, or the rows that overlap without contact forces; and the tied rows.
std::vector<int> first_set(const ContactProblem& problem, const ContactLoad& load, const ContactState& warm);

}  // namespace creepcontact::contact
