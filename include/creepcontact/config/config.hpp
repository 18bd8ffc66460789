#pragma once
/// The complete configuration of a run as plain structs. Defaults of keys are defined here and nowhere else. Functions
/// depend on x, y, z, t unless said otherwise; units are a consistent set chosen by the user.

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "creepcontact/base/csv_format.hpp"
#include "creepcontact/base/function.hpp"
#include "creepcontact/config/location.hpp"
#include "creepcontact/settings/analysis.hpp"
#include "creepcontact/settings/contact_settings.hpp"
#include "creepcontact/settings/integrator_options.hpp"
#include "creepcontact/settings/stiffness_settings.hpp"

namespace creepcontact::config {

/// Treatment of nodes that several bodies share and no contact covers.
enum class SharedNodes { error, tie };
constexpr auto names_of(SharedNodes) {
  return std::to_array<settings::EnumName<SharedNodes>>({{"error", SharedNodes::error}, {"tie", SharedNodes::tie}});
}

/// [mesh]

/// [mesh] sizes: of the elements on a named surface and near it, or in a body.
struct MeshSize {
  Reference on, body;  ///< one of them
  double size = 0;
};

/// [mesh] cut: half of a CAD model.
enum class KeptSide { larger, smaller };
constexpr auto names_of(KeptSide) {
  return std::to_array<settings::EnumName<KeptSide>>({{"+", KeptSide::larger}, {"-", KeptSide::smaller}});
}
enum class CutAxis { x, y, z };
constexpr auto names_of(CutAxis) {
  return std::to_array<settings::EnumName<CutAxis>>({{"x", CutAxis::x}, {"y", CutAxis::y}, {"z", CutAxis::z}});
}
struct MeshCut {
  CutAxis axis = CutAxis::x;
  KeptSide keep = KeptSide::larger;
  double at = 0;
};

struct Mesh {
  std::filesystem::path file;                ///< resolved against the directory of the configuration
  int order = 2;                             ///< geometries only: 1, or 2 (linear tetrahedra lock in creep)
  std::map<std::string, double> parameters;  ///< .geo only: values of DefineConstant constants
  bool allow_locking = false;                ///< accept linear tetrahedra and wedges
  bool project_distorted = true;             ///< mesh::Section::project_distorted
  double time_limit = 3600;                  ///< .geo only: bound on the meshing time [s]
  int memory_limit_mb = 8192;                ///< .geo only: bound on the memory for meshing [MB]
  bool trust_geometry = false;               ///< .geo only: may run programs and write files; set on the command line
  SharedNodes share_nodes = SharedNodes::error;
  double thickness = 1;  ///< of plane sections
  // CAD files only:
  std::optional<double> size;       ///< of the elements
  double elements_per_circle = 12;  ///< of a curved face; 0: curvature does not count
  std::vector<MeshSize> sizes;
  std::vector<MeshCut> cut;
  Location location;  ///< of `file`
};

/// A plane, by a point and its normal.
struct SectionPlane {
  std::array<double, 3> origin{};
  std::array<double, 3> normal{};  ///< of any length; of a probe: points to the part whose force is recorded
};

/// [surfaces.<name>]: faces of the model, by number or by what is known of them: all conditions must hold.
struct Surface {
  std::string name;
  std::vector<int> faces;                                   ///< numbers, as `creepcontact faces` lists them
  std::optional<std::string> kind;                          ///< plane, cylinder, cone, sphere, torus, other
  std::optional<double> radius;                             ///< within one part in a thousand
  Reference touches;                                        ///< a body
  Reference body;                                           ///< that has the faces
  std::optional<std::array<std::array<double, 3>, 2>> box;  ///< lowest and highest corner: faces lie within
  std::optional<SectionPlane> plane;                        ///< in which faces lie
  Location location;
};

/// [bodies.<name>.material_axes.cylindrical]: axes 1, 2, 3 are radial, circumferential and axial.
struct CylindricalAxes {
  std::array<double, 3> axis{0, 0, 1};  ///< not zero
  std::array<double, 3> origin{};
};

/// [bodies.<name>.material_axes]: either two directions or cylindrical axes.
struct MaterialAxes {
  std::array<Function, 3> first, second;  ///< directions, functions of x, y, z
  std::optional<CylindricalAxes> cylindrical;
};

/// [bodies.<name>]
struct Body {
  std::string name;
  std::vector<Reference> region;        ///< physical volumes, in sections physical surfaces; at least one
  Reference material;                   ///< a name in Config::materials
  std::optional<double> thickness;      ///< plane stress: default Mesh::thickness
  std::optional<Function> axial_force;  ///< of t, generalised plane strain of each body by itself; default 0
  std::optional<MaterialAxes> material_axes;
  Location location;
};

/// Value of one key of a creep law; `values` has one entry unless the key takes a list. The value of a word is its
/// number.
struct CreepParameter {
  std::string key;
  std::vector<Function> values;  ///< of the variables that Vocabulary allows for this key
  Location location;
  bool given = true;                           ///< false: it is the default
  std::string word = {};                       ///< of a key whose value is a word
  bool is_list = false;                        ///< the key takes a list, of one value too
  std::vector<std::string> variables = {"T"};  ///< that Vocabulary allows for this key
};

/// [[materials.<name>.creep]]
struct CreepMechanism {
  std::string law;
  std::vector<CreepParameter> parameters;  ///< one per key of the law, in the order of Vocabulary
  Location location;
  bool depends_on_temperature = false;  ///< as reported by the law
  /// Where the data hold from which the constants come; not given: not known.
  std::optional<Interval> stress_range = {}, temperature_range = {}, time_range = {};
  std::string units = {};  ///< as Material::units
};

enum class StressMeasure { von_mises, principal, mixed };
constexpr auto names_of(StressMeasure) {
  return std::to_array<settings::EnumName<StressMeasure>>({{"von_mises", StressMeasure::von_mises},
                                                           {"principal", StressMeasure::principal},
                                                           {"mixed", StressMeasure::mixed}});
}

/// [materials.<name>.rupture]: time to rupture at constant stress, either `rupture_time` or Larson-Miller data.
struct Rupture {
  std::optional<Function> rupture_time;  ///< of q, T
  double larson_miller_constant = 20;
  std::vector<double> stress;
  std::vector<double> parameter;   ///< (T - absolute_zero) (larson_miller_constant + log10 rupture time) at `stress`
  double absolute_zero = -273.15;  ///< in the unit of T
  double time_unit = 1;            ///< unit of t, in the time unit of the data
  StressMeasure stress_measure = StressMeasure::von_mises;
  std::optional<double> alpha;  ///< only with `mixed`: S = alpha sigma_1 + (1 - alpha) q
  Location location;
};

/// [materials.<name>.orthotropic]: functions of T
struct Orthotropic {
  std::array<Function, 3> young_moduli;    ///< E1, E2, E3
  std::array<Function, 3> poisson_ratios;  ///< nu12, nu23, nu13
  std::array<Function, 3> shear_moduli;    ///< G12, G23, G13
};

/// [materials.<name>.hill]: ratios of Hill's equivalent stress
struct Hill {
  std::array<double, 3> normal{1, 1, 1};  ///< R11, R22, R33
  std::array<double, 3> shear{1, 1, 1};   ///< R12, R23, R13
};

/// [materials.<name>.fatigue]: number of cycles to failure, either `cycles_to_failure` or a fatigue curve.
struct Fatigue {
  std::optional<Function> cycles_to_failure;  ///< of eps (the strain range), T
  std::vector<double> strain_range, cycles;
  std::vector<std::vector<double>> interaction;  ///< points of the diagram: life fraction, cycle fraction
  Location location;
};

/// [materials.<name>.plasticity.curve]: one temperature of a yield stress that hardens
struct PlasticCurve {
  std::optional<double> T;             ///< needed where there are several curves
  std::vector<double> plastic_strain;  ///< ascending from 0
  std::vector<double> stress;          ///< not falling
};

/// [[materials.<name>.plasticity.kinematic]]: a back stress, functions of T
struct KinematicHardening {
  Function C;
  Function gamma{0.0};
};

/// [materials.<name>.plasticity]: rate-independent, von Mises
struct Plasticity {
  std::optional<Function> yield_stress;  ///< of T; or `curve`
  Function hardening_modulus{0.0};       ///< of T: d stress/d plastic strain
  std::vector<PlasticCurve> curve;       ///< by ascending T
  std::vector<KinematicHardening> kinematic;
  Location location;
};

/// [materials.<name>.data_range], an older way to give the ranges of all creep laws of a material at once: complete()
/// gives them to the laws.
struct DataRange {
  std::optional<Interval> stress;  ///< von Mises stress
  std::optional<Interval> temperature;
  std::optional<Interval> time;
};

/// [materials.<name>.override]: values by their paths. The reader puts them where they belong.
struct LibraryOverrides {};

/// [materials.<name>]
struct Material {
  std::string name;
  /// Names in the material library: the reader replaces them by the data, so that these are empty afterwards.
  std::vector<std::string> use;
  std::optional<LibraryOverrides> overrides;
  std::string units;       ///< of the numbers, which the reader converts: left only if the model names no units
  Function young_modulus;  ///< of T; not with `orthotropic`
  Function poisson_ratio;  ///< of T; not with `orthotropic`
  std::optional<Orthotropic> orthotropic;        ///< elasticity
  std::optional<Hill> hill;                      ///< of all creep laws
  std::vector<Function> thermal_expansion{0.0};  ///< secant, of T: one, or three along the material axes
  std::optional<double> reference_temperature;   ///< of zero thermal strain; not given: 0, where nothing depends on T
  std::vector<Function> conductivity;            ///< of heat, of T: one, or three along the material axes; empty: none
  std::optional<Function> heat_capacity;         ///< per mass, of T
  std::optional<double> density;                 ///< mass per volume
  std::vector<CreepMechanism> creep;
  std::optional<Plasticity> plasticity;
  std::optional<Function> yield_strength;  ///< of T: what the stress is compared with
  std::optional<Rupture> rupture;
  std::optional<DataRange> data_range;
  std::optional<Fatigue> fatigue;
  std::vector<std::string> sources;  ///< where the data come from, for reports
  Location location;
};

/// [[supports]]: prescribed displacements of a surface, curve or point; at least one component is given.
struct Support {
  Reference on;
  Reference body;                                       ///< optional: restricts it to the nodes of this body
  std::array<std::optional<Function>, 3> displacement;  ///< x, y, z
  std::optional<Function> normal;                       ///< along the outward normal
  /// Radial, tangential and axial components about an axis.
  std::array<std::optional<Function>, 3> cylindrical;
  std::array<double, 3> axis{0, 0, 1};
  std::array<double, 3> origin{};                  ///< of the axis
  std::optional<Function> along;                   ///< component along `direction`
  std::optional<std::array<double, 3>> direction;  ///< of any length; given if and only if `along` is
  std::optional<double> from, until;               ///< times between which it acts; not given: always
  bool relative = false;                           ///< displacements count from what is reached at `from`
  Location location;

  bool acts_always() const { return !from && !until; }
};

/// Kinds of loads; units are those of stress, force, force per volume, angle per time, mass per volume.
struct Pressure {
  Function value;  ///< positive if it pushes on the body
};
struct Traction {
  std::array<Function, 3> value;  ///< force per area, x, y, z
};
struct PointForce {
  std::optional<std::array<double, 3>> at;  ///< applied to the nearest mesh node ...
  std::optional<double> tolerance;          ///< ... within this distance; nullopt: 1e-6 of the model size
  int node = 0;                             ///< without `at`: number of the node in the mesh file
  std::array<Function, 3> value;
};
struct BodyForce {
  std::array<Function, 3> value;  ///< force per volume, x, y, z
};
/// Centrifugal force about an axis through `origin`.
struct Rotation {
  std::array<double, 3> axis{0, 0, 1};
  std::array<double, 3> origin{};
  Function angular_velocity;  ///< of t
  Function density;
};

/// [[loads]]
struct Load {
  Reference on;    ///< required with pressure and traction
  Reference body;  ///< required with body_force and rotation; else optional: restricts the load to this body
  std::variant<Pressure, Traction, PointForce, BodyForce, Rotation> kind;
  Location location;
};

/// [temperature]
struct Temperature {
  Function value;  ///< used unless files are given
  /// Temperatures at points, resolved against the directory of the configuration. The name of a single one may have a
  /// '*': all files of that form; the number there is the time.
  std::vector<std::filesystem::path> files;
  std::vector<double> times;                   ///< of the files, one each; empty: the files say themselves
  std::map<std::string, std::string> columns;  ///< names of the columns of x, y, z, r, t, T, as far as given
  std::string thousands;         ///< what separates them in CSV tables: ".", ",", " ", "'"; empty: nothing
  std::optional<double> period;  ///< of the repetition in time
  /// Axis about which the points of a section (radius, position along the axis) are revolved ...
  std::optional<std::array<double, 3>> axis;
  std::array<double, 3> origin{};  ///< ... and the point on it from which positions count
  double refactor_change = 0.05;   ///< relative change of the stiffness beyond which it is factored again, 0 to 0.5
  Function scale = 1.0;            ///< of t: factor on the temperature less `scale_about`
  double scale_about = 0;
  Location location;
};

/// [initial_stress.<body>]: of the undeformed body at its reference temperature, before loads act.
struct InitialStress {
  std::string name;                                                         ///< of the body
  std::array<Function, 6> along_coordinates{0.0, 0.0, 0.0, 0.0, 0.0, 0.0};  ///< xx, yy, zz, xy, yz, zx of x, y, z
  std::array<Function, 3> about_axis{0.0, 0.0, 0.0};                        ///< instead: radial, tangential, axial
  std::array<double, 3> axis{0, 0, 1};
  std::array<double, 3> origin{};
  std::optional<std::filesystem::path> file;  ///< instead: stresses at points
  Location location;
};

/// What flows through a surface in [heat]; units are those of the material data.
struct HeatFilm {
  Reference on, body;
  Function coefficient;  ///< heat per area, degree and time
  Function fluid;        ///< temperature
};
struct HeatFlux {
  Reference on, body;
  Function value;  ///< into the body
};
struct HeatRadiation {
  Reference on, body;
  Function emissivity, ambient;
};
struct HeatSource {
  Reference body;
  Function value;  ///< per volume
};
struct HeatTemperature {
  Reference on, body;
  Function value;
};
struct HeatPointFlow {
  Reference on, body;
  Function value;  ///< into each node
};

/// [heat]: the temperature is computed
struct Heat {
  std::optional<Function> start;    ///< temperature at t = 0; nullopt: the steady one
  std::optional<double> time_unit;  ///< of t, in the unit of time of the data
  std::vector<HeatFilm> films;
  std::vector<HeatFlux> fluxes;
  std::vector<HeatTemperature> temperatures;
  std::vector<HeatRadiation> radiation;
  std::vector<HeatSource> sources;
  std::vector<HeatPointFlow> point_flows;
  std::optional<double> stefan_boltzmann, absolute_zero;
  double tolerance = 1e-4;                    ///< of temperatures, relative to their range
  double refactor_change = 0.05;              ///< as Temperature::refactor_change
  std::optional<std::filesystem::path> keep;  ///< file of the computed temperatures, for other runs
  std::optional<bool> alone;                  ///< without mechanics; nullopt: if no material has elastic constants
  Location location;
};

/// How a contact conducts heat.
struct Conductance {
  enum class Kind { not_given, function, perfect, insulated };
  Kind kind = Kind::not_given;
  Function value = 0.0;  ///< per area and degree; of x, y, z, t, T, and of the pressure p and the gap
};

using settings::Acceleration;
using settings::ContactMethod;
using settings::ContactType;
using settings::InnerIteration;
using settings::LinearSolver;
using settings::StepMode;

/// Normal force of a contact instead of its gap.
struct Preload {
  double force = 0;
  double time = 0;  ///< at which it is applied
};

/// A measured curve of a gasket.
struct GasketCurve {
  std::optional<double> T;  ///< temperature; needed if there are several
  std::vector<double> closure, pressure;
};

/// [gaskets.<name>.unloading]: straight lines, or curves
struct GasketUnloading {
  std::optional<double> T;
  std::vector<double> from, modulus;  ///< pressures at which unloading begins, and the moduli from there
  std::vector<GasketCurve> curves;
};

/// [gaskets.<name>.relaxation]: P_QR of EN 13555 with the rig in which it was measured
struct GasketRelaxation {
  double factor = 0;        ///< residual over initial pressure
  double pressure = 0;      ///< initial
  double stiffness = 0;     ///< of the rig [force/length]
  double area = 0;          ///< of the gasket that was tested
  double time = 0;          ///< of the test
  std::optional<double> T;  ///< temperature of the test; nullopt: the reference temperature
  double n = 5;             ///< exponent of the pressure, which P_QR does not tell
};

/// [gaskets.<name>]
struct Gasket {
  std::string name;
  double thickness = 0;
  std::vector<GasketCurve> loading;        ///< by ascending T
  std::vector<GasketUnloading> unloading;  ///< one for all, or one per curve of `loading`; empty: as loading
  Function thermal_expansion = 0.0;        ///< of T, through the thickness
  std::optional<double> reference_temperature;
  std::vector<CreepMechanism> creep;
  std::optional<GasketRelaxation> relaxation;
  Location location;
};

/// [[contacts]]
struct Contact {
  std::string name;                  ///< default: "<first surface>-<second surface>"
  std::array<Reference, 2> between;  ///< physical surfaces
  ContactType type = ContactType::unilateral;
  int slave = -1;              ///< 0 or 1: index into `between`; -1: "auto"
  bool geometric_gap = false;  ///< gap = "geometric": measured from the meshes
  Function gap = 0.0;          ///< initial normal distance; negative: interference
  std::optional<Preload> preload;
  Reference gasket;         ///< between the surfaces
  Function friction = 0.0;  ///< coefficient of friction, of x, y, z, t, T
  Conductance conductance;  ///< of heat; used with [heat]
  Location location;
};

/// The force of a spring over its closure.
struct SpringCurve {
  std::vector<double> closure, force;
};

/// [[springs]]: between two surfaces, of which it takes the means, two points, or a surface and the ground
struct Spring {
  std::string name;
  std::optional<std::array<Reference, 2>> between;
  std::optional<std::array<std::array<double, 3>, 2>> at;
  Reference on;
  bool ground = false;
  std::array<double, 3> direction{};  ///< from the first to the second: they come closer along it
  std::optional<double> stiffness;
  std::optional<SpringCurve> curve;
  double preload = 0;  ///< force where nothing has moved
  std::vector<CreepMechanism> creep;
  Location location;
};

/// [[cyclic]]: the model is one of the sectors that make up a full circle.
struct Cyclic {
  std::array<Reference, 2> between;  ///< the second surface is the first, turned about the axis by the angle
  std::array<double, 3> axis{0, 0, 1};
  std::array<double, 3> origin{};
  double angle = 0;  ///< degrees
  Location location;
};

/// [[rigid]]: a surface that moves as a rigid body, by small rotations. What is not prescribed is free.
struct Rigid {
  std::vector<Reference> on;                            ///< of any bodies
  std::optional<std::array<double, 3>> origin;          ///< default: the mean of the nodes
  std::array<std::optional<Function>, 3> displacement;  ///< of the origin, functions of t
  std::array<std::optional<Function>, 3> rotation;      ///< about axes through the origin [rad], functions of t
  std::array<Function, 3> force{0.0, 0.0, 0.0};         ///< at the origin, functions of t
  std::array<Function, 3> moment{0.0, 0.0, 0.0};
  Location location;
};

/// Parameters of the Schwarz iteration, in (0, 1].
struct Alpha {
  struct OfBody {
    Reference body;
    double value = 0;
  };
  std::optional<double> all;    ///< for all bodies; "diagonal" if neither this nor `of_body` is given
  std::vector<OfBody> of_body;  ///< for single bodies, in the order of the keys
};

/// [[equations]]: sum of coefficient . u(node) over the terms = value
struct Equation {
  struct Term {
    int node = 0;  ///< number in the mesh file
    std::array<double, 3> coefficient{};
  };
  std::vector<Term> terms;  ///< at least one; no node twice
  Function value = 0.0;     ///< [length] times a coefficient; of t
  Location location;
};

/// [contact_solver]
struct ContactSolver : settings::ContactSettings {
  Alpha alpha;
};

/// [time]
struct Time : settings::IntegratorOptions {
  double end = 0;
  std::string integrator = "auto";
  std::vector<double> output;              ///< increasing, from 0 to end, both included
  bool stop_at_output = false;             ///< steps end at output times; else results are interpolated within steps
  std::vector<double> breakpoints;         ///< increasing; those of tables in t are not among them
  std::optional<double> cycle;             ///< period of the loads
  std::optional<double> stop_when_steady;  ///< change per cycle below which the run ends
  bool jump_cycles = false;                ///< extrapolate over cycles
  double jump_tolerance = 1e-3;            ///< error of a jump, relative to the stress
  Location location;
};

/// [output]
struct Output {
  /// Relative to the working directory; default: results/<stem> next to the configuration.
  std::filesystem::path directory;
  bool fields = true;  ///< write fields.pvd, contact.pvd and their .vtu files ...
  /// ... at these times only, increasing, all among Time::output; nullopt: at all output times.
  std::optional<std::vector<double>> field_times;
  bool frd = false;                ///< write fields.frd, at the same times
  int revolve = 0;                 ///< axisymmetric: segments of the solid in revolved.pvd; 0: none
  bool unit_names = true;          ///< their arrays carry the unit in their names
  double checkpoint_seconds = 30;  ///< wall time between checkpoints [s]; 0: after every step
  CsvFormat csv;                   ///< of history.csv, steps.csv and the log of contact iterations
};

/// A still picture of [report].
struct ReportPicture {
  std::string field;                    ///< a quantity of the field files
  std::optional<double> time;           ///< the nearest output time with fields is drawn; nullopt: the last one
  std::optional<SectionPlane> section;  ///< what lies on the side of the normal is cut away
  std::string view = "iso";             ///< one of settings::views
  std::optional<Interval> range;        ///< of the colours; nullopt: that of the values shown
};

/// [report]: what a report says next to the results. The run copies it into its output.
struct Report {
  std::string title, project, drawing, revision, author, checker;
  std::filesystem::path logo;                    ///< PNG, JPEG or SVG, relative to the working directory; may be empty
  std::string purpose, assumptions, assessment;  ///< Markdown
  bool appendix = true;                          ///< with steps, cost and origin
  std::vector<ReportPicture> pictures;           ///< empty: those that a report chooses
};

enum class Reduce { mean, max, min, sum };
constexpr auto names_of(Reduce) {
  return std::to_array<settings::EnumName<Reduce>>(
      {{"mean", Reduce::mean}, {"max", Reduce::max}, {"min", Reduce::min}, {"sum", Reduce::sum}});
}

/// [[probes]]
struct Probe {
  std::string name;
  std::string quantity;                     ///< empty: `expression`
  Reference on;                             ///< a physical surface (curve, point), or ...
  std::optional<std::array<double, 3>> at;  ///< ... a point, or ...
  Reference body;                           ///< ... a whole body; with `on` or `at`: restricts it to this body
  std::optional<Function> where;            ///< of x, y, z: only the part where it is not 0
  Reduce reduce = Reduce::mean;             ///< over a surface or body; `sum` for areas, forces and reactions
  std::array<double, 3> axis{0, 0, 1};      ///< axis of cylindrical components (axisymmetric: y) ...
  std::array<double, 3> origin{};           ///< ... and a point on it; or the point that moments refer to
  std::optional<SectionPlane> section;      ///< given if and only if the quantity is of a section
  Reference expression;                     ///< its text: of the names of other probes and t
  double scale = 1;                         ///< factor on the value
  std::optional<std::string> unit;          ///< of the value, for tables and plots; nullopt: from the quantity
  Location location;
};

/// [[events]]: the first time at which a condition holds.
struct Event {
  std::string name;
  Reference when;     ///< text of the condition: of the names of probes and t
  bool stop = false;  ///< the run ends there
  Location location;
};

/// What a criterion allows: a function, or what the material of the place has at its temperature.
struct CriterionLimit {
  enum class Kind { function, yield_strength, rupture_strength };
  Kind kind = Kind::function;
  Function value = 0.0;  ///< of t; of a field also of T
};

/// Criteria that need little else.
enum class CriterionKind { yield, creep_life, creep_strain, leak, interference_lost };
constexpr auto names_of(CriterionKind) {
  return std::to_array<settings::EnumName<CriterionKind>>({{"yield", CriterionKind::yield},
                                                           {"creep_life", CriterionKind::creep_life},
                                                           {"creep_strain", CriterionKind::creep_strain},
                                                           {"leak", CriterionKind::leak},
                                                           {"interference_lost", CriterionKind::interference_lost}});
}

/// What of a linearised stress counts: its mean over the path, or that with its linear part.
enum class LinearisedPart { membrane, membrane_and_bending };
constexpr auto names_of(LinearisedPart) {
  return std::to_array<settings::EnumName<LinearisedPart>>(
      {{"membrane", LinearisedPart::membrane}, {"membrane_and_bending", LinearisedPart::membrane_and_bending}});
}

/// [[criteria]]: a demand on the run, judged at the end of every step. One of `probe`, `expression`, `quantity` and
/// `kind` says of what.
struct Criterion {
  std::string name;
  Reference probe;
  Reference expression;  ///< of names of probes and t
  std::string quantity;  ///< a field, over all of a body
  std::optional<CriterionKind> kind;
  Reference body;     ///< of `quantity`, yield, creep_life, creep_strain; not given: all of them
  Reference contact;  ///< of leak, interference_lost
  std::vector<std::array<double, 3>> away_from;  ///< points near which the field does not count, within ...
  double distance = 0;
  std::optional<std::array<std::array<double, 3>, 2>> path;  ///< through the wall: of creep_strain, or of von_mises ...
  LinearisedPart part = LinearisedPart::membrane_and_bending;  ///< ... that is linearised along it
  std::array<double, 3> strains{0.01, 0.02, 0.05};             ///< of creep_strain: membrane, with bending, local
  std::optional<CriterionLimit> min, max;                      ///< one of them
  double safety = 1;                                           ///< what is allowed is divided by it (min: times it)
  std::optional<double> life;             ///< time for which the rupture strength counts; nullopt: time.end
  std::optional<double> from, until, at;  ///< times that count
  Location location;
};

/// [generalized_plane_strain]
struct GeneralizedPlaneStrain {
  std::optional<Function> strain;  ///< of t: the axial strain of all bodies; if not given it follows from ...
  Function force = 0.0;            ///< ... the axial force on all bodies together, of t
  bool per_body = false;           ///< each body has its own axial strain, which follows from Body::axial_force
};

/// [sensitivity]
struct Sensitivity {
  std::vector<Reference> keys;  ///< numbers of the configuration, with respect to which results are differentiated
  std::vector<double> changes;  ///< a typical change of each, empty: their values
};

/// A configuration that has been read and checked, or made in code and completed (writer.hpp).
struct Config {
  std::filesystem::path file;  ///< as given by the user
  std::string title;
  std::string units;
  std::vector<std::string> remarks;  ///< what check and run repeat as warnings
  settings::Analysis analysis = settings::Analysis::solid;
  Mesh mesh;
  std::vector<Surface> surfaces;
  std::vector<Body> bodies;  ///< at least one; in the order of the file, like the materials
  std::vector<Material> materials;
  std::vector<Support> supports;
  std::vector<Load> loads;
  GeneralizedPlaneStrain generalized_plane_strain;
  std::optional<Temperature> temperature;
  std::optional<Heat> heat;
  std::vector<InitialStress> initial_stress;
  std::vector<Gasket> gaskets;
  std::vector<Contact> contacts;
  std::vector<Spring> springs;
  std::vector<Cyclic> cyclic;
  std::vector<Rigid> rigid;
  std::vector<Rigid> coupling;  ///< the mean motion of the surfaces, not each of their nodes
  std::vector<Equation> equations;
  ContactSolver contact_solver;
  settings::StiffnessSettings linear_solver;
  Time time;
  Output output;
  Report report;
  std::vector<Probe> probes;
  std::vector<Event> events;
  std::vector<Criterion> criteria;
  Sensitivity sensitivity;

  /// @throws std::out_of_range if the name is unknown (reading has checked those that bodies refer to)
  const Material& material(const std::string& name) const;
  /// Whether a temperature is given or computed.
  bool has_temperature() const { return temperature.has_value() || heat.has_value(); }
  /// Whether [heat] is computed without any mechanics.
  bool is_heat_alone() const;
  /// Whether contact changes the flow of heat: then the temperature is part of the state of the run.
  bool has_coupled_heat() const;
  /// Whether it is a function of the place and the time.
  bool has_temperature_function() const { return temperature && temperature->files.empty(); }
};

}  // namespace creepcontact::config
