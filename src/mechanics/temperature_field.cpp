#include "creepcontact/mechanics/temperature_field.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "creepcontact/base/checksum.hpp"
#include "creepcontact/mechanics/discretization.hpp"
#include "nodal_temperatures.hpp"
#include "scattered_interpolation.hpp"

namespace creepcontact::mechanics {

struct TemperatureField::Definition {
  virtual ~Definition() = default;
  virtual double value(const Arguments& at) const = 0;
  virtual std::unique_ptr<const TemperatureAtPositions> at(std::span<const Vector3> positions) const = 0;
  bool position = true, time = true;  // whether it depends on them
  virtual std::unique_ptr<const TemperatureAtPositions> at_points(const Discretization& of_mesh,
                                                                  const mesh::Mesh& /*mesh*/) const {
    return at(of_mesh.point_coordinates());
  }
  virtual NodeCover cover(const mesh::Mesh& /*mesh*/) const { return {}; }
  virtual std::vector<double> breakpoints(double end) const = 0;
  virtual PlaceOutside outside(const Vector3& /*place*/) const { return {}; }
  std::string text;
};

namespace {

class FunctionAtPositions final : public TemperatureAtPositions {
 public:
  FunctionAtPositions(Function function, std::span<const Vector3> positions)
      : function_(std::move(function)), positions_(positions.begin(), positions.end()) {}

  void evaluate(double t, std::span<double> values, TemperatureMemo& /*memo*/) const override {
    if (!function_.depends_on_position()) return std::fill(values.begin(), values.end(), function_({.t = t}));
    for (std::size_t p = 0; p < positions_.size(); ++p)
      values[p] = function_({.x = positions_[p][0], .y = positions_[p][1], .z = positions_[p][2], .t = t});
  }

 private:
  Function function_;
  std::vector<Vector3> positions_;
};

struct OfFunction final : TemperatureField::Definition {
  explicit OfFunction(Function given) : function(std::move(given)) {
    position = function.depends_on_position();
    time = function.depends_on_time();
    text = function.text();
  }
  double value(const Arguments& at) const override { return function(at); }
  std::unique_ptr<const TemperatureAtPositions> at(std::span<const Vector3> positions) const override {
    return std::make_unique<FunctionAtPositions>(function, positions);
  }
  std::vector<double> breakpoints(double end) const override { return function.breakpoints(end); }

  Function function;
};

/// The interval of the times that t lies in, by its end, and the weight of that end.
struct Moment {
  std::size_t before, after;
  double weight;
};

Moment moment(const std::vector<double>& times, double t) {
  const auto after = static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), t) - times.begin());
  if (after == 0) return {0, 0, 0};
  if (after == times.size()) return {after - 1, after - 1, 0};
  return {after - 1, after, (t - times[after - 1]) / (times[after] - times[after - 1])};
}

struct Scattered {
  explicit Scattered(ScatteredTemperatures from)
      : given(std::move(from)),
        interpolation(given.points),
        times(Function::table("t", given.times, numbers(), given.period)) {}

  /// Where among the points a place is.
  Vector3 place(const Vector3& position) const { return given.axis ? given.axis->in_section(position) : position; }
  Moment at(double t) const { return moment(given.times, given.period && t >= 0 ? std::fmod(t, *given.period) : t); }

  ScatteredTemperatures given;
  ScatteredInterpolation interpolation;
  Function times;  ///< their numbers, of t: it knows their repetitions

 private:
  std::vector<double> numbers() const {
    std::vector<double> all(given.times.size());
    std::iota(all.begin(), all.end(), 0.0);
    return all;
  }
};

double weighted(std::span<const PointWeight> weights, const std::vector<double>& values) {
  double sum = 0;
  for (const PointWeight& term : weights) sum += term.weight * values[term.point];
  return sum;
}

class ScatteredAtPositions final : public TemperatureAtPositions {
 public:
  ScatteredAtPositions(std::shared_ptr<const Scattered> field, std::span<const Vector3> positions)
      : field_(std::move(field)), weights_(positions.size()) {
    const auto n = static_cast<std::ptrdiff_t>(positions.size());
#pragma omp parallel for schedule(static)
    for (std::ptrdiff_t p = 0; p < n; ++p) weights_[p] = field_->interpolation.weights(field_->place(positions[p]));
  }

  ScatteredAtPositions(std::shared_ptr<const Scattered> field, std::vector<PointWeights> weights)
      : field_(std::move(field)), weights_(std::move(weights)) {}

  void evaluate(double t, std::span<double> values, TemperatureMemo& memo) const override {
    const Moment at = field_->at(t);
    interpolate(at.before, memo.before);
    if (at.weight > 0) interpolate(at.after, memo.after);
    for (std::size_t p = 0; p < values.size(); ++p)
      values[p] = at.weight > 0 ? (1 - at.weight) * memo.before.values[p] + at.weight * memo.after.values[p]
                                : memo.before.values[p];
  }

 private:
  void interpolate(std::size_t time, TemperatureMemo::AtTime& kept) const {
    if (kept.time == time) return;
    kept.values.resize(weights_.size());
    for (std::size_t p = 0; p < weights_.size(); ++p)
      kept.values[p] = weighted(weights_[p], field_->given.values[time]);
    kept.time = time;
  }

  std::shared_ptr<const Scattered> field_;
  std::vector<PointWeights> weights_;
};

struct OfPoints final : TemperatureField::Definition {
  explicit OfPoints(ScatteredTemperatures given) : field(std::make_shared<Scattered>(std::move(given))) {
    const ScatteredTemperatures& kept = field->given;
    time = kept.times.size() > 1;
    Checksum sum;
    for (const Vector3& x : kept.points) sum.add(x.data(), 3);
    sum.add(kept.times.data(), kept.times.size());
    for (const std::vector<double>& values : kept.values) sum.add(values.data(), values.size());
    text = fmt::format("{} points at {} times, checksum {:016x}", kept.points.size(), kept.times.size(), sum.value());
    if (kept.period) text += fmt::format(", period {}", *kept.period);
    if (kept.node_tolerance) text += ", those of nodes interpolated by elements";
    if (kept.axis)
      text += fmt::format(", revolved about [{}] through [{}]", fmt::join(kept.axis->direction, ", "),
                          fmt::join(kept.axis->origin, ", "));
  }

  double value(const Arguments& at) const override {
    const std::vector<PointWeight> weights = field->interpolation.weights(field->place({at.x, at.y, at.z}));
    const Moment now = field->at(at.t);
    const double before = weighted(weights, field->given.values[now.before]);
    return before + now.weight * (weighted(weights, field->given.values[now.after]) - before);
  }
  std::unique_ptr<const TemperatureAtPositions> at(std::span<const Vector3> positions) const override {
    return std::make_unique<ScatteredAtPositions>(field, positions);
  }
  std::unique_ptr<const TemperatureAtPositions> at_points(const Discretization& of_mesh,
                                                          const mesh::Mesh& mesh) const override {
    if (field->given.node_tolerance) {
      const NodesAmongPoints nodes = nodes_of(mesh);
      if (nodes.cover.is_nodal)
        return std::make_unique<ScatteredAtPositions>(field, by_shape_functions(of_mesh, mesh.section, nodes.at_nodes));
    }
    return at(of_mesh.point_coordinates());
  }
  NodeCover cover(const mesh::Mesh& mesh) const override {
    return field->given.node_tolerance ? nodes_of(mesh).cover : NodeCover{};
  }
  NodesAmongPoints nodes_of(const mesh::Mesh& mesh) const {
    return nodes_among_points(mesh::PointTree(field->given.points), mesh, *field->given.node_tolerance);
  }
  std::vector<double> breakpoints(double end) const override {
    std::vector<double> result;
    if (!time) return result;
    for (const double t : field->times.breakpoints(end))
      if (t <= end) result.push_back(t);
    return result;
  }

  PlaceOutside outside(const Vector3& at) const override {
    const mesh::Neighbour nearest = field->interpolation.outside(field->place(at));
    if (nearest.distance == 0) return {};
    return {nearest.distance, field->given.points[nearest.point]};
  }

  std::shared_ptr<const Scattered> field;
};

}  // namespace

Vector3 RevolutionAxis::in_section(const Vector3& position) const {
  const Vector3 arm = position - origin;
  const double along = direction.dot(arm);
  return {(arm - along * direction).norm(), along, 0};
}

TemperatureField::TemperatureField(Function value) : definition_(std::make_shared<OfFunction>(std::move(value))) {}
TemperatureField::TemperatureField(ScatteredTemperatures given)
    : definition_(std::make_shared<OfPoints>(std::move(given))) {}

double TemperatureField::operator()(const Arguments& at) const {
  return definition_->value(at);
}
std::unique_ptr<const TemperatureAtPositions> TemperatureField::at(std::span<const Vector3> positions) const {
  return definition_->at(positions);
}
std::unique_ptr<const TemperatureAtPositions> TemperatureField::at_points(const Discretization& of_mesh,
                                                                          const mesh::Mesh& mesh) const {
  return definition_->at_points(of_mesh, mesh);
}
NodeCover TemperatureField::cover(const mesh::Mesh& mesh) const {
  return definition_->cover(mesh);
}
bool TemperatureField::depends_on_position() const {
  return definition_->position;
}
bool TemperatureField::depends_on_time() const {
  return definition_->time;
}
std::vector<double> TemperatureField::breakpoints(double end) const {
  return definition_->breakpoints(end);
}
PlaceOutside TemperatureField::outside(const Vector3& position) const {
  return definition_->outside(position);
}
const std::string& TemperatureField::text() const {
  return definition_->text;
}

}  // namespace creepcontact::mechanics
