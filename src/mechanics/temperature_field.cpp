#include "creepcontact/mechanics/temperature_field.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
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
  virtual const TemperatureField* on(const mesh::Mesh& /*mesh*/) const { return nullptr; }  // null: it is the same
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

/// Weight of a rate at the beginning and at the end of an interval, in the cubic polynomial.
struct RateWeights {
  double before = 0, after = 0;
};

struct Scattered {
  explicit Scattered(ScatteredTemperatures from)
      : given(std::move(from)),
        interpolation(given.points),
        times(Function::table("t", given.times, numbers(), given.period)) {}

  /// Where among the points a place is.
  Vector3 place(const Vector3& position) const { return given.axis ? given.axis->in_section(position) : position; }
  Moment at(double t) const { return moment(given.times, tabulated(t)); }
  /// The time in the table that a time of the run is like.
  double tabulated(double t) const {
    const double last = given.times.back();
    if (given.last_period && t > last) return t - std::ceil((t - last) / *given.last_period) * *given.last_period;
    return given.period && t >= 0 ? std::fmod(t, *given.period) : t;
  }
  bool is_cubic() const { return !given.rates_after.empty(); }
  /// Makes the weight of the later value that of the cubic polynomial (Hermite).
  RateWeights make_cubic(Moment& at) const {
    const double s = at.weight, h = given.times[at.after] - given.times[at.before];
    at.weight = s * s * (3 - 2 * s);
    return {h * s * (1 - s) * (1 - s), -h * s * s * (1 - s)};
  }

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
    Moment at = field_->at(t);
    const ScatteredTemperatures& given = field_->given;
    interpolate(at.before, given.rates_after, memo.before);
    if (at.weight > 0) interpolate(at.after, given.rates_before, memo.after);
    if (at.weight > 0 && field_->is_cubic()) {
      const RateWeights of_rates = field_->make_cubic(at);
      for (std::size_t p = 0; p < values.size(); ++p)
        values[p] = (1 - at.weight) * memo.before.values[p] + at.weight * memo.after.values[p] +
                    of_rates.before * memo.before.rates[p] + of_rates.after * memo.after.rates[p];
      return;
    }
    for (std::size_t p = 0; p < values.size(); ++p)
      values[p] = at.weight > 0 ? (1 - at.weight) * memo.before.values[p] + at.weight * memo.after.values[p]
                                : memo.before.values[p];
  }

 private:
  /// @param rates  of all times; empty: none
  void interpolate(std::size_t time, const std::vector<std::vector<double>>& rates,
                   TemperatureMemo::AtTime& kept) const {
    if (kept.time == time) return;
    kept.values.resize(weights_.size());
    for (std::size_t p = 0; p < weights_.size(); ++p)
      kept.values[p] = weighted(weights_[p], field_->given.values[time]);
    kept.rates.resize(rates.empty() ? 0 : weights_.size());
    for (std::size_t p = 0; p < kept.rates.size(); ++p) kept.rates[p] = weighted(weights_[p], rates[time]);
    kept.time = time;
  }

  std::shared_ptr<const Scattered> field_;
  std::vector<PointWeights> weights_;
};

struct OfPoints final : TemperatureField::Definition {
  explicit OfPoints(ScatteredTemperatures given) : field(std::make_shared<Scattered>(std::move(given))) {
    const ScatteredTemperatures& kept = field->given;
    time = kept.times.size() > 1 || kept.is_of_state;
    Checksum sum;
    for (const Vector3& x : kept.points) sum.add(x.data(), 3);
    sum.add(kept.times.data(), kept.times.size());
    for (const auto* all : {&kept.values, &kept.rates_before, &kept.rates_after})
      for (const std::vector<double>& values : *all) sum.add(values.data(), values.size());
    text = fmt::format("{} points at {} times, checksum {:016x}", kept.points.size(), kept.times.size(), sum.value());
    if (kept.last_period) text += fmt::format(", the last {:.17g} of them repeated", *kept.last_period);
    if (kept.period) text += fmt::format(", period {}", *kept.period);
    if (kept.node_tolerance) text += ", those of nodes interpolated by elements";
    if (kept.axis)
      text += fmt::format(", revolved about [{}] through [{}]", fmt::join(kept.axis->direction, ", "),
                          fmt::join(kept.axis->origin, ", "));
  }

  double value(const Arguments& at) const override {
    const std::vector<PointWeight> weights = field->interpolation.weights(field->place({at.x, at.y, at.z}));
    Moment now = field->at(at.t);
    const ScatteredTemperatures& given = field->given;
    const RateWeights of_rates = field->is_cubic() && now.weight > 0 ? field->make_cubic(now) : RateWeights();
    const double before = weighted(weights, given.values[now.before]);
    double value = before + now.weight * (weighted(weights, given.values[now.after]) - before);
    if (of_rates.before != 0) value += of_rates.before * weighted(weights, given.rates_after[now.before]);
    if (of_rates.after != 0) value += of_rates.after * weighted(weights, given.rates_before[now.after]);
    return value;
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
    if (field->is_cubic() || field->given.is_of_state) {
      std::ranges::copy_if(field->given.kinks, std::back_inserter(result), [=](double t) { return t <= end; });
      return result;
    }
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

/// Positions on several bodies, each evaluated by the field of one of them.
class OnBodiesAtPositions final : public TemperatureAtPositions {
 public:
  struct Part {
    std::vector<std::size_t> places;  ///< among the positions
    std::unique_ptr<const TemperatureAtPositions> field;
  };
  explicit OnBodiesAtPositions(std::vector<Part> parts) : parts_(std::move(parts)) {}

  void evaluate(double t, std::span<double> values, TemperatureMemo& /*memo*/) const override {
    for (const Part& part : parts_) {
      TemperatureMemo memo;
      std::vector<double> own(part.places.size());
      part.field->evaluate(t, own, memo);
      for (std::size_t i = 0; i < own.size(); ++i) values[part.places[i]] = own[i];
    }
  }

 private:
  std::vector<Part> parts_;
};

struct OfBodies final : TemperatureField::Definition {
  explicit OfBodies(std::vector<TemperatureField::OnBody> given) : bodies(std::move(given)) {
    time = false;
    for (const TemperatureField::OnBody& body : bodies) {
      trees.emplace_back(body.nodes);
      time = time || body.field->depends_on_time();
      text += (text.empty() ? "" : "; ") + body.field->text();
    }
  }

  const TemperatureField* on(const mesh::Mesh& mesh) const override {
    for (const TemperatureField::OnBody& body : bodies)
      if (body.nodes.size() == mesh.n_cell_nodes() &&
          std::equal(body.nodes.begin(), body.nodes.end(), mesh.nodes.begin()))
        return body.field.get();
    return nullptr;
  }
  std::size_t nearest(const Vector3& position) const {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < trees.size(); ++b)
      if (const double distance = trees[b].nearest(position, 1).front().distance; distance < least) {
        least = distance;
        best = b;
      }
    return best;
  }
  double value(const Arguments& at) const override { return (*bodies[nearest({at.x, at.y, at.z})].field)(at); }
  std::unique_ptr<const TemperatureAtPositions> at(std::span<const Vector3> positions) const override {
    std::vector<OnBodiesAtPositions::Part> parts(bodies.size());
    std::vector<std::vector<Vector3>> own(bodies.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const std::size_t b = nearest(positions[i]);
      parts[b].places.push_back(i);
      own[b].push_back(positions[i]);
    }
    for (std::size_t b = 0; b < bodies.size(); ++b) parts[b].field = bodies[b].field->at(own[b]);
    return std::make_unique<OnBodiesAtPositions>(std::move(parts));
  }
  std::unique_ptr<const TemperatureAtPositions> at_points(const Discretization& of_mesh,
                                                          const mesh::Mesh& mesh) const override {
    const TemperatureField* own = on(mesh);
    return own != nullptr ? own->at_points(of_mesh, mesh) : at(of_mesh.point_coordinates());
  }
  std::vector<double> breakpoints(double end) const override { return bodies.front().field->breakpoints(end); }

  std::vector<TemperatureField::OnBody> bodies;
  std::vector<mesh::PointTree> trees;
};

class ScaledAtPositions final : public TemperatureAtPositions {
 public:
  ScaledAtPositions(std::unique_ptr<const TemperatureAtPositions> field, Function scale, double about)
      : field_(std::move(field)), scale_(std::move(scale)), about_(about) {}

  void evaluate(double t, std::span<double> values, TemperatureMemo& memo) const override {
    field_->evaluate(t, values, memo);
    const double factor = scale_({.t = t});
    for (double& value : values) value = about_ + factor * (value - about_);
  }

 private:
  std::unique_ptr<const TemperatureAtPositions> field_;
  Function scale_;
  double about_;
};

struct OfScaled final : TemperatureField::Definition {
  OfScaled(TemperatureField given, Function factor, double fixed)
      : field(std::move(given)), scale(std::move(factor)), about(fixed) {
    position = field.depends_on_position();
    time = field.depends_on_time() || scale.depends_on_time();
    text = fmt::format("{:.17g} plus {} times ({} less that)", about, scale.text(), field.text());
  }

  double value(const Arguments& at) const override { return about + scale(at) * (field(at) - about); }
  std::unique_ptr<const TemperatureAtPositions> at(std::span<const Vector3> positions) const override {
    return std::make_unique<ScaledAtPositions>(field.at(positions), scale, about);
  }
  std::unique_ptr<const TemperatureAtPositions> at_points(const Discretization& of_mesh,
                                                          const mesh::Mesh& mesh) const override {
    return std::make_unique<ScaledAtPositions>(field.at_points(of_mesh, mesh), scale, about);
  }
  NodeCover cover(const mesh::Mesh& mesh) const override { return field.cover(mesh); }
  std::vector<double> breakpoints(double end) const override {
    std::vector<double> result = field.breakpoints(end);
    for (const double t : scale.breakpoints(end))
      if (t <= end) result.push_back(t);
    std::ranges::sort(result);
    const auto [first, last] = std::ranges::unique(result);
    result.erase(first, last);
    return result;
  }
  PlaceOutside outside(const Vector3& place) const override { return field.outside(place); }

  TemperatureField field;
  Function scale;
  double about;
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

TemperatureField::TemperatureField(std::vector<OnBody> bodies)
    : definition_(std::make_shared<OfBodies>(std::move(bodies))) {}

TemperatureField TemperatureField::scaled(const Function& scale, double about) const {
  return TemperatureField(std::make_shared<const OfScaled>(*this, scale, about));
}

const TemperatureField& TemperatureField::on(const mesh::Mesh& mesh) const {
  const TemperatureField* own = definition_->on(mesh);
  return own != nullptr ? *own : *this;
}
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
