#pragma once
/// Temperature as a function of position and time: an expression, or values at scattered points at one or more times.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/mesh/mesh.hpp"

namespace creepcontact::mechanics {

class Discretization;

/// The axis about which a section is revolved: at a place the field is that of the section at (r, z, 0), the distance
/// from the axis and the position along it.
struct RevolutionAxis {
  Vector3 origin = Vector3::Zero();      ///< where z is 0
  Vector3 direction = Vector3::UnitZ();  ///< of length 1
  Vector3 in_section(const Vector3& position) const;
};

/// Temperatures at scattered points; constant before the first and after the last time, linear in between unless rates
/// are given.
struct ScatteredTemperatures {
  std::vector<Vector3> points;              ///< no two equal
  std::vector<double> times;                ///< increasing; one: steady
  std::vector<std::vector<double>> values;  ///< [time][point]
  /// Given: between two times the cubic polynomial with the values and these rates at both, which may differ before and
  /// after a time. Then the field is smooth but for the kinks, some of the times.
  std::vector<std::vector<double>> rates_before = {}, rates_after = {};
  std::vector<double> kinks = {};
  std::optional<double> last_period = {};  ///< given: beyond the last time, the course of this time before it repeats
  bool is_of_state = false;  ///< these are the values at the start; the later ones are given to Body::update()
  /// The value at t is that at t modulo the period. Times then lie in [0, period], the first at 0
  /// (Function::period_error); where the values at both ends differ, there is a jump at each period.
  std::optional<double> period = {};
  std::optional<RevolutionAxis> axis = {};  ///< given: the points are those of a section, (r, z, 0)
  /// Given: a point within this distance of a node is that node. Where all corners of a mesh are points, its elements
  /// interpolate between their nodes. Precondition: no axis
  std::optional<double> node_tolerance = {};
};

/// How many nodes of the bulk elements of a mesh are points of a field.
struct NodeCover {
  std::size_t corners = 0, corners_given = 0, mid_sides = 0, mid_sides_given = 0;
  bool is_nodal = false;  ///< the shape functions of the elements interpolate the field
};

/// A place beyond the points of a field.
struct PlaceOutside {
  double distance = 0;                ///< to the nearest point; 0: not outside
  Vector3 nearest = Vector3::Zero();  ///< that point; with an axis (r, z, 0)
};

/// Temperatures interpolated to fixed positions at the two tabulated times around the last evaluation. Owned by the
/// caller of evaluate(); it affects the cost of an evaluation, not its value.
struct TemperatureMemo {
  struct AtTime {
    std::optional<std::size_t> time;  ///< index of the tabulated time; nullopt: none yet
    std::vector<double> values;       ///< one per position
    std::vector<double> rates;        ///< likewise, of fields that have them
  };
  AtTime before, after;
};

/// Temperature at positions chosen in advance, so that work depending on the positions is done only once. Immutable.
class TemperatureAtPositions {
 public:
  virtual ~TemperatureAtPositions() = default;
  /// @param values  one per position, overwritten
  virtual void evaluate(double t, std::span<double> values, TemperatureMemo& memo) const = 0;
};

/// A temperature field. Value semantics; copies share the immutable definition.
class TemperatureField {
 public:
  /// The field of a function of x, y, z, t; as thread-safe as the function.
  TemperatureField(Function value);  // NOLINT(google-explicit-constructor): a function is a field
  /// Interpolated between the points (ScatteredInterpolation).
  explicit TemperatureField(ScatteredTemperatures given);
  /// One field per body, which may jump between them. At other places that of the body with the nearest node counts.
  struct OnBody {
    std::vector<Vector3> nodes;  ///< of its mesh, by which it is known
    std::shared_ptr<const TemperatureField> field;
  };
  explicit TemperatureField(std::vector<OnBody> bodies);
  /// about + scale(t) (T - about), of this field T. @param scale  of t
  TemperatureField scaled(const Function& scale, double about) const;

  /// Value at one position and time.
  double operator()(const Arguments& at) const;
  /// The field for repeated evaluation at these positions; does not refer to the argument.
  std::unique_ptr<const TemperatureAtPositions> at(std::span<const Vector3> positions) const;
  /// The field for repeated evaluation at the integration points of a body, whose elements interpolate the field if it
  /// is nodal on the mesh. @param of_mesh  the body, or the part of it that a process has; its nodes are those of the
  /// mesh
  std::unique_ptr<const TemperatureAtPositions> at_points(const Discretization& of_mesh, const mesh::Mesh& mesh) const;
  /// The field on a body: what differs from it on others is left out. It lives as long as this one.
  const TemperatureField& on(const mesh::Mesh& mesh) const;
  /// How many nodes of the mesh are points of the field; zeros for a function, and where nodes are not matched.
  NodeCover cover(const mesh::Mesh& mesh) const;

  bool depends_on_position() const;
  bool depends_on_time() const;
  /// Times up to `end` at which the field is known to jump or to have a kink (discontinuity of the slope), increasing.
  std::vector<double> breakpoints(double end) const;
  /// The nearest point if `position` is so far outside the points that only this one counts.
  PlaceOutside outside(const Vector3& position) const;
  /// Identifies the field: equal texts mean equal fields.
  const std::string& text() const;

  struct Definition;

 private:
  explicit TemperatureField(std::shared_ptr<const Definition> definition) : definition_(std::move(definition)) {}
  std::shared_ptr<const Definition> definition_;
};

}  // namespace creepcontact::mechanics
