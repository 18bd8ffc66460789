#pragma once
/// The whole configuration of a run as plain structs. The default of every key stands here and nowhere else.
/// Functions are of x, y, z, t unless said otherwise; units are the user's own consistent set.

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/config/location.hpp"

namespace creepcontact::config {

/// What becomes of nodes that several bodies share and no contact covers.
enum class SharedNodes { error, tie };

struct Mesh {
  std::filesystem::path file;                ///< .geo or .msh; already relative to the working directory
  int order = 2;                             ///< .geo only: 1, or 2 (linear tetrahedra lock in creep)
  std::map<std::string, double> parameters;  ///< .geo only: constants made with DefineConstant
  bool allow_locking = false;                ///< accept linear tetrahedra and wedges
  double time_limit = 3600;                  ///< .geo only: seconds that meshing may take
  int memory_limit_mb = 8192;                ///< .geo only: memory that meshing may take
  bool trust_geometry = false;               ///< .geo only: may run programs and write files; the command line says so
  SharedNodes share_nodes = SharedNodes::error;
  Location location;  ///< of `file`
};

struct Body {
  std::string name;
  std::vector<Reference> region;  ///< physical volumes, at least one
  Reference material;             ///< a name in Config::materials
  Location location;
};

/// One value of a creep law's key; `values` has one entry unless the key takes a list.
struct CreepParameter {
  std::string key;
  std::vector<Function> values;  ///< of the variables that Vocabulary allows at this key
  Location location;
  bool given = true;  ///< false: the default
};

struct CreepMechanism {
  std::string law;
  std::vector<CreepParameter> parameters;  ///< one a key of the law, in the order of Vocabulary
  Location location;
  bool depends_on_temperature = false;  ///< the law says so
};

enum class StressMeasure { von_mises, principal, mixed };

/// Time to rupture at constant stress: `rupture_time`, or else Larson-Miller data.
struct Rupture {
  std::optional<Function> rupture_time;  ///< of q, T
  double larson_miller_constant = 20;
  std::vector<double> stress;
  std::vector<double> parameter;   ///< (T - absolute_zero) (larson_miller_constant + log10 rupture time) at these
  double absolute_zero = -273.15;  ///< in the unit of T
  double time_unit = 1;            ///< unit of t in that of the data
  StressMeasure stress_measure = StressMeasure::von_mises;
  std::optional<double> alpha;  ///< given with `mixed`: alpha sigma_1 + (1 - alpha) q
  Location location;
};

struct Material {
  std::string name;
  Function young_modulus;            ///< of T
  Function poisson_ratio;            ///< of T
  Function thermal_expansion = 0.0;  ///< secant, of T
  double reference_temperature = 0.0;
  std::vector<CreepMechanism> creep;
  std::optional<Rupture> rupture;
  Location location;
};

/// Prescribed displacements of a surface, curve or point; at least one component is given.
struct Support {
  Reference on;
  Reference body;                                       ///< optional: only the nodes of this body
  std::array<std::optional<Function>, 3> displacement;  ///< x, y, z
  std::optional<Function> normal;                       ///< along the outward normal
  Location location;
};

struct Pressure {
  Function value;  ///< positive towards the body
};
struct Traction {
  std::array<Function, 3> value;  ///< force per area
};
struct PointForce {
  std::array<double, 3> at{};       ///< acts at the nearest mesh node ...
  std::optional<double> tolerance;  ///< ... no further than this; not given: 1e-6 of the model size
  std::array<Function, 3> value;
};
struct BodyForce {
  std::array<Function, 3> value;  ///< force per volume
};
struct Rotation {
  std::array<double, 3> axis{0, 0, 1};
  std::array<double, 3> origin{};
  Function angular_velocity;  ///< of t
  Function density;
};

struct Load {
  Reference on;    ///< given with pressure and traction
  Reference body;  ///< given with body_force and rotation; optional else: only this body
  std::variant<Pressure, Traction, PointForce, BodyForce, Rotation> kind;
  Location location;
};

struct Temperature {
  Function value;                 ///< unless `file` is given
  std::filesystem::path file;     ///< of temperatures at points; relative to the working directory
  double refactor_change = 0.05;  ///< of the stiffness, relative, beyond which it is factored anew; 0 to 0.5
  Location location;
};

enum class ContactType { unilateral, tied };

struct Contact {
  std::string name;                  ///< not given: "<first surface>-<second surface>"
  std::array<Reference, 2> between;  ///< physical surfaces
  ContactType type = ContactType::unilateral;
  int slave = -1;              ///< 0 or 1: index into `between`; -1: "auto"
  bool geometric_gap = false;  ///< gap = "geometric": measured from the mesh
  Function gap = 0.0;          ///< initial normal distance, negative: interference
  Location location;
};

enum class ContactMethod { schwarz, active_set };
enum class Acceleration { none, aitken, anderson, cg };

/// Iteration parameters in (0, 1].
struct Alpha {
  struct OfBody {
    Reference body;
    double value = 0;
  };
  std::optional<double> all;    ///< of all bodies; neither this nor a body's own given: "diagonal"
  std::vector<OfBody> of_body;  ///< in the order of the keys
};

struct ContactSolver {
  ContactMethod method = ContactMethod::schwarz;
  Alpha alpha;
  double damping = 1.0;  ///< part of each sweep that is taken, in (0, 1]
  Acceleration acceleration = Acceleration::cg;
  double tolerance = 1e-10;
  int max_iterations = 200;
  double dense_limit_mb = 2000;  ///< memory of the contact zones' matrices; beyond it they are not formed
};

enum class StepMode { fixed, stable, adaptive };

struct TimeStep {
  StepMode mode = StepMode::stable;
  double length = 0;  ///< fixed
};

enum class InnerIteration { fixed_point, newton };

enum class LinearSolver { krylov, tangent };

struct Time {
  double end = 0;
  std::string integrator = "auto";
  double tolerance = 1e-4;                             ///< relative stress accuracy
  LinearSolver linear_solver = LinearSolver::krylov;   ///< of cvode_bdf and arkode_dirk
  std::vector<double> output;                          ///< increasing, from 0 to end, both included
  TimeStep step;                                       ///< Euler schemes
  double step_factor = 1.0;                            ///< times the stable step
  double beta = 1.0;                                   ///< beta_euler, in [0.5, 1]
  InnerIteration inner = InnerIteration::fixed_point;  ///< beta_euler
  double inner_tolerance = 1e-10;
  int inner_anderson = 0;  ///< beta_euler: depth of Anderson acceleration; 0: the plain iterations of the article
  double residual_correction = 0.0;
  std::string table;                ///< arkode_erk, arkode_dirk: Butcher table; empty: the integrator's own choice
  std::vector<double> breakpoints;  ///< increasing; those of tables in t are not among them
  Location location;
};

struct Output {
  std::filesystem::path directory;  ///< relative to the working directory; not given: results/<stem> beside the file
  bool fields = true;               ///< write fields.pvd, contact.pvd and their .vtu files
  double checkpoint_seconds = 30;   ///< wall time between checkpoints; 0: one after every step
};

enum class Reduce { mean, max, min, sum };

struct Probe {
  std::string name;
  std::string quantity;
  Reference on;                             ///< a physical surface (curve, point), or ...
  std::optional<std::array<double, 3>> at;  ///< ... a point, or ...
  Reference body;                           ///< ... a whole body; beside `on` and `at`: only in this body
  Reduce reduce = Reduce::mean;             ///< over a surface or body; sum for areas, forces and reactions
  std::array<double, 3> axis{0, 0, 1};      ///< of cylindrical components ...
  std::array<double, 3> origin{};           ///< ... and a point of it
  Location location;
};

struct Config {
  std::filesystem::path file;  ///< as given by the user
  std::string title;
  std::string units;
  Mesh mesh;
  std::vector<Body> bodies;  ///< at least one; these and materials in the order of the file
  std::vector<Material> materials;
  std::vector<Support> supports;
  std::vector<Load> loads;
  std::optional<Temperature> temperature;
  std::vector<Contact> contacts;
  ContactSolver contact_solver;
  Time time;
  Output output;
  std::vector<Probe> probes;

  /// @throws std::out_of_range for a name that no body refers to (reading has checked them all)
  const Material& material(const std::string& name) const;
};

}  // namespace creepcontact::config
