#include "criterion_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/units.hpp"
#include "creepcontact/model/materials.hpp"
#include "creepcontact/results/contact_values.hpp"
#include "creepcontact/results/probe_expression.hpp"
#include "creepcontact/results/probe_record.hpp"
#include "creepcontact/results/quantities.hpp"

namespace creepcontact::results {
namespace {

using config::Criterion;
using config::CriterionKind;
using config::CriterionLimit;

const CriterionLimit& limit_of(const Criterion& criterion) {
  return criterion.min ? *criterion.min : *criterion.max;
}

/// A maximum is made smaller by safety, a minimum larger.
double with_safety(double allowed, const Criterion& criterion) {
  return is_minimum(criterion) ? allowed * criterion.safety : allowed / criterion.safety;
}

/// The criterion as if its kind had been written out.
Criterion written_out(Criterion criterion) {
  if (!criterion.kind) return criterion;
  switch (*criterion.kind) {
    case CriterionKind::yield:
      criterion.quantity = "von_mises";
      criterion.max = CriterionLimit{CriterionLimit::Kind::yield_strength, 0.0};
      break;
    case CriterionKind::creep_life:
      criterion.quantity = "life_fraction";
      if (!criterion.max) criterion.max = CriterionLimit{CriterionLimit::Kind::function, 1.0};
      break;
    case CriterionKind::creep_strain:
      criterion.max = CriterionLimit{CriterionLimit::Kind::function, criterion.strains[0]};
      break;
    default:
      if (!criterion.min) criterion.min = CriterionLimit{CriterionLimit::Kind::function, 0.0};
  }
  return criterion;
}

Finding judged(const Criterion& criterion, double found, double allowed) {
  return {found, allowed, utilisation(found, allowed, is_minimum(criterion))};
}

/// Keeps the worse of two findings.
void take(Finding here, int body, const Vector3& place, std::optional<Finding>& worst) {
  here.body = body;
  here.position = place;
  if (!worst || here.utilisation > worst->utilisation) worst = here;
}

/// A probe, or an expression of probes: the name of a probe alone need not be one that expressions can have.
class ProbeMeasure final : public CriterionMeasure {
 public:
  using Value = std::function<double(Snapshot&)>;
  ProbeMeasure(const Criterion& criterion, Value value) : criterion_(criterion), value_(std::move(value)) {}
  std::optional<Finding> in(Snapshot& snapshot) const override {
    const double value = value_(snapshot);
    if (!std::isfinite(value)) return std::nullopt;
    return judged(criterion_, value, with_safety(limit_of(criterion_).value({.t = snapshot.time()}), criterion_));
  }

 private:
  Criterion criterion_;
  Value value_;
};

/// Stress at which the time to rupture is the life asked for, by temperature.
class RuptureStrength {
 public:
  RuptureStrength(std::shared_ptr<const material::RuptureData> data, double life)
      : data_(std::move(data)), life_(life) {}
  double at(double temperature) const {
    const auto [found, is_new] = known_.try_emplace(temperature, 0);
    if (is_new) found->second = solved(temperature);
    return found->second;
  }

 private:
  double solved(double temperature) const {
    double low = 1e-30, high = 1e30;
    constexpr int halvings = 200;
    for (int i = 0; i < halvings && high > low * (1 + 1e-12); ++i) {
      const double middle = std::sqrt(low * high);
      (data_->rate(middle, temperature).value * life_ < 1 ? low : high) = middle;
    }
    return low;
  }
  std::shared_ptr<const material::RuptureData> data_;
  double life_;
  mutable std::map<double, double> known_;
};

/// What is allowed at the points of bodies: a function, or a strength of their materials.
class FieldLimit {
 public:
  struct OfBody {
    std::size_t body;
    Function allowed;
    std::optional<RuptureStrength> rupture;
    double at(double time, double temperature) const {
      return rupture ? rupture->at(temperature) : allowed({.t = time, .T = temperature});
    }
  };

  FieldLimit(const Criterion& criterion, const config::Config& config, const model::Model& model) {
    for (std::size_t b = 0; b < model.bodies().size(); ++b) {
      if (criterion.body.given() && model.bodies()[b].name() != criterion.body.name) continue;
      const material::Material& material = model.bodies()[b].material();
      OfBody of{b, {}, {}};
      switch (limit_of(criterion).kind) {
        case CriterionLimit::Kind::function:
          of.allowed = limit_of(criterion).value;
          break;
        case CriterionLimit::Kind::yield_strength:
          if (!material.yield_strength) continue;
          of.allowed = *material.yield_strength;
          break;
        case CriterionLimit::Kind::rupture_strength: {
          const auto& rupture = config.material(config.bodies[b].material.name).rupture;
          if (!rupture) continue;
          of.rupture.emplace(model::rupture_data(*rupture), criterion.life.value_or(config.time.end));
        }
      }
      bodies_.push_back(std::move(of));
    }
  }
  const std::vector<OfBody>& bodies() const { return bodies_; }
  /// The least of all points: where a value belongs to a wall, not to a point.
  double least(Snapshot& snapshot) const {
    double least = std::numeric_limits<double>::infinity();
    for (const OfBody& of : bodies_)
      for (const double temperature : snapshot.fields(of.body).point_values(PointField::temperature))
        least = std::min(least, of.at(snapshot.time(), temperature));
    return least;
  }

 private:
  std::vector<OfBody> bodies_;
};

/// A quantity at all points of bodies, or at their nodes if it is one of nodes.
class FieldMeasure final : public CriterionMeasure {
 public:
  FieldMeasure(const Criterion& criterion, const config::Config& config, const model::Model& model)
      : criterion_(criterion), quantity_(quantity(criterion.quantity)), limit_(criterion, config, model) {}

  std::optional<Finding> in(Snapshot& snapshot) const override {
    std::optional<Finding> worst;
    const bool at_nodes = quantity_.variable->is<AtNodes>();
    for (const FieldLimit::OfBody& of : limit_.bodies()) {
      const BodyFields& fields = snapshot.fields(of.body);
      const std::size_t n = at_nodes ? fields.n_nodes() : fields.n_points();
      for (std::size_t p = 0; p < n; ++p) {
        const Sample sample = at_nodes ? snapshot.moved_node(of.body, p) : fields.at_point(p);
        if (is_left_out(sample.position)) continue;
        const double found = quantity_.value(sample);
        if (!std::isfinite(found)) continue;
        const double allowed = with_safety(of.at(snapshot.time(), sample.temperature), criterion_);
        take(judged(criterion_, found, allowed), static_cast<int>(of.body), sample.position, worst);
      }
    }
    return worst;
  }

 private:
  bool is_left_out(const Vector3& place) const {
    return std::ranges::any_of(criterion_.away_from, [&](const std::array<double, 3>& point) {
      return (place - Vector3(point.data())).norm() < criterion_.distance;
    });
  }

  Criterion criterion_;
  const Quantity& quantity_;
  FieldLimit limit_;
};

/// The mean pressure of a contact, or its normal force.
class ContactMeasure final : public CriterionMeasure {
 public:
  ContactMeasure(const Criterion& criterion, const model::Model& model) : criterion_(criterion) {
    const auto& pairs = model.assembly.pairs();
    pair_ = static_cast<std::size_t>(std::ranges::find(pairs, criterion.contact.name, &contact::Pair::name) -
                                     pairs.begin());
  }
  std::optional<Finding> in(Snapshot& snapshot) const override {
    const contact::Pair& pair = snapshot.assembly().pairs()[pair_];
    double force = normal_force(pair, snapshot.equilibrium().contact.multiplier);
    if (std::abs(force) <= round_off_force(snapshot.assembly(), pair)) force = 0;
    double area = 1;
    if (criterion_.kind == CriterionKind::leak) {
      area = 0;
      for (const double of_node : pair.coupling.area) area += of_node;
    }
    const double allowed = with_safety(limit_of(criterion_).value({.t = snapshot.time()}), criterion_);
    Finding finding = judged(criterion_, force / area, allowed);
    if (force <= 0) finding.utilisation = std::numeric_limits<double>::infinity();  // nothing presses
    return finding;
  }

 private:
  Criterion criterion_;
  std::size_t pair_ = 0;
};

/// Tensors of a body along a line through its wall: their mean, their linear part, and themselves. Simpson's rule.
class Path {
 public:
  /// @param tensors  names of quantities without their components: they are added
  Path(const Criterion& criterion, const std::vector<std::string>& tensors, const config::Config& config,
       const model::Model& model)
      : n_tensors_(tensors.size()) {
    config::Config on_path = config;
    on_path.probes.clear();
    const Vector3 first((*criterion.path)[0].data()), last((*criterion.path)[1].data());
    for (int i = 0; i < n_points; ++i) {
      const Vector3 x = first + (last - first) * i / (n_points - 1);
      places_.push_back(x);
      for (const std::string& tensor : tensors)
        for (const char* const component : {"xx", "yy", "zz", "xy", "yz", "zx"}) {
          config::Probe& probe = on_path.probes.emplace_back();
          probe.name = fmt::format("criterion '{}', point {} of its path", criterion.name, i + 1);
          probe.quantity = tensor + "_" + component;
          probe.at = {x.x(), x.y(), x.z()};
          probe.body = criterion.body;
          probe.location = criterion.location;
        }
    }
    try {
      probes_ = make_probes(on_path, model);
    } catch (const ModelError& error) {
      const std::string text = error.what();
      throw ModelError(text.substr(0, text.find('\n')));  // once, not for each component
    }
    for (std::size_t b = 0; b < model.bodies().size(); ++b)
      if (model.bodies()[b].name() == criterion.body.name) body_ = static_cast<int>(b);
  }

  struct Linearised {
    std::vector<Matrix3> values;
    Matrix3 mean = Matrix3::Zero();
    Matrix3 slope = Matrix3::Zero();  ///< the linear part at the last point; at the first minus that
  };
  Linearised in(Snapshot& snapshot) const {
    Linearised result;
    std::size_t next = 0;
    for (int i = 0; i < n_points; ++i) {
      Matrix3& value = result.values.emplace_back(Matrix3::Zero());
      for (std::size_t k = 0; k < n_tensors_; ++k)
        for (const auto& [row, column] : {std::pair(0, 0), {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}) {
          const double component = snapshot.value(*probes_[next++]);
          value(row, column) += component;
          if (row != column) value(column, row) += component;
        }
      const double weight = (i == 0 || i == n_points - 1 ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) / (3.0 * (n_points - 1));
      const double along = 2.0 * i / (n_points - 1) - 1;  // -1 to 1
      result.mean += weight * value;
      result.slope += 3 * weight * along * value;
    }
    return result;
  }
  int body() const { return body_; }
  const std::vector<Vector3>& places() const { return places_; }
  const Vector3& middle() const { return places_[n_points / 2]; }

 private:
  static constexpr int n_points = 21;
  std::size_t n_tensors_;
  std::vector<Vector3> places_;
  std::vector<std::unique_ptr<Probe>> probes_;
  int body_ = -1;
};

std::vector<std::string> inelastic_strains(const Criterion& criterion, const config::Config& config) {
  std::vector<std::string> strains{"creep_strain"};
  const auto body = std::ranges::find(config.bodies, criterion.body.name, &config::Body::name);
  if (body != config.bodies.end() && config.material(body->material.name).plasticity)
    strains.emplace_back("plastic_strain");
  return strains;
}

/// Inelastic strain through a wall: its mean and its linear part, component by component, of which the largest
/// principal values count (ASME III-5, HBB-T-1310).
class StrainMeasure final : public CriterionMeasure {
 public:
  StrainMeasure(const Criterion& criterion, const config::Config& config, const model::Model& model)
      : criterion_(criterion), path_(criterion, inelastic_strains(criterion, config), config, model) {}

  std::optional<Finding> in(Snapshot& snapshot) const override {
    const Path::Linearised strain = path_.in(snapshot);
    std::optional<Finding> worst;
    const auto judge = [&](const Matrix3& value, double allowed, const Vector3& place) {
      take(judged(criterion_, tensor::principal_values(value)[2], allowed), path_.body(), place, worst);
    };
    const std::vector<Vector3>& places = path_.places();
    judge(strain.mean, criterion_.strains[0], path_.middle());
    judge(strain.mean - strain.slope, criterion_.strains[1], places.front());
    judge(strain.mean + strain.slope, criterion_.strains[1], places.back());
    for (std::size_t i = 0; i < places.size(); ++i) judge(strain.values[i], criterion_.strains[2], places[i]);
    return worst;
  }

 private:
  Criterion criterion_;
  Path path_;
};

/// The von Mises stress of a stress that is linearised through a wall.
class LinearisedMeasure final : public CriterionMeasure {
 public:
  LinearisedMeasure(const Criterion& criterion, const config::Config& config, const model::Model& model)
      : criterion_(criterion), path_(criterion, {"stress"}, config, model), limit_(criterion, config, model) {}

  std::optional<Finding> in(Snapshot& snapshot) const override {
    const Path::Linearised stress = path_.in(snapshot);
    const double allowed = limit_.least(snapshot);
    std::optional<Finding> worst;
    const auto judge = [&](const Matrix3& value, const Vector3& place) {
      const double found = tensor::von_mises(tensor::from_matrix(value));
      take(judged(criterion_, found, with_safety(allowed, criterion_)), path_.body(), place, worst);
    };
    if (criterion_.part == config::LinearisedPart::membrane) {
      judge(stress.mean, path_.middle());
    } else {
      judge(stress.mean - stress.slope, path_.places().front());
      judge(stress.mean + stress.slope, path_.places().back());
    }
    return worst;
  }

 private:
  Criterion criterion_;
  Path path_;
  FieldLimit limit_;
};

std::string of_bodies(const Criterion& criterion) {
  return criterion.body.given() ? fmt::format("'{}'", criterion.body.name) : "all bodies";
}

std::string subject(const Criterion& criterion) {
  if (criterion.probe.given()) return criterion.probe.name;
  if (criterion.expression.given()) return criterion.expression.name;
  if (!criterion.kind && criterion.path)
    return fmt::format("{} von Mises stress through the wall of {}",
                       criterion.part == config::LinearisedPart::membrane ? "membrane" : "membrane and bending",
                       of_bodies(criterion));
  if (!criterion.kind)
    return fmt::format("{} of {}", quantity(criterion.quantity).variable->label, of_bodies(criterion));
  switch (*criterion.kind) {
    case CriterionKind::yield:
      return fmt::format("von Mises stress of {}", of_bodies(criterion));
    case CriterionKind::creep_life:
      return fmt::format("creep life used in {}", of_bodies(criterion));
    case CriterionKind::creep_strain:
      return fmt::format("inelastic strain through the wall of {}", of_bodies(criterion));
    case CriterionKind::leak:
      return fmt::format("mean pressure of contact '{}'", criterion.contact.name);
    default:
      return fmt::format("normal force of contact '{}'", criterion.contact.name);
  }
}

std::string limit_text(const Criterion& given, const std::string& unit) {
  if (given.kind == CriterionKind::creep_strain)
    return fmt::format("at most {:.3g} % on average, {:.3g} % with bending, {:.3g} % anywhere", 100 * given.strains[0],
                       100 * given.strains[1], 100 * given.strains[2]);
  const Criterion criterion = written_out(given);
  if (given.kind == CriterionKind::interference_lost && !given.min) return "above 0";
  const CriterionLimit& limit = limit_of(criterion);
  std::string text = is_minimum(criterion) ? "at least " : "at most ";
  if (limit.kind == CriterionLimit::Kind::function)
    text += limit.value.text() + (unit.empty() ? "" : " " + unit);
  else
    text += limit.kind == CriterionLimit::Kind::yield_strength ? "the yield strength" : "the rupture strength";
  if (criterion.safety != 1) text += fmt::format(", with a safety of {:g}", criterion.safety);
  return text;
}

}  // namespace

bool is_minimum(const Criterion& criterion) {
  return criterion.min.has_value() || criterion.kind == CriterionKind::leak ||
         criterion.kind == CriterionKind::interference_lost;
}

std::string unit_of_criterion(const Criterion& criterion, const config::Config& config) {
  if (criterion.probe.given()) {
    const auto probe = std::ranges::find(config.probes, criterion.probe.name, &config::Probe::name);
    return probe == config.probes.end() ? "" : ProbeRecord::unit_of(*probe, config.units);
  }
  if (criterion.expression.given()) return "";
  if (criterion.kind == CriterionKind::leak) return unit_of(Dimension::stress, config.units);
  if (criterion.kind == CriterionKind::interference_lost) return unit_of(Dimension::force, config.units);
  if (criterion.kind == CriterionKind::creep_strain) return "";
  return unit_of(quantity(written_out(criterion).quantity).variable->dimension, config.units);
}

std::string demand_of(const Criterion& criterion, const std::string& unit) {
  return subject(criterion) + ": " + limit_text(criterion, unit);
}

std::unique_ptr<CriterionMeasure> make_measure(const Criterion& given, const config::Config& config,
                                               const model::Model& model,
                                               std::span<const std::unique_ptr<Probe>> probes) {
  const Criterion criterion = written_out(given);
  if (criterion.kind == CriterionKind::creep_strain) return std::make_unique<StrainMeasure>(criterion, config, model);
  if (criterion.kind == CriterionKind::leak || criterion.kind == CriterionKind::interference_lost)
    return std::make_unique<ContactMeasure>(criterion, model);
  if (!criterion.quantity.empty() && criterion.path)
    return std::make_unique<LinearisedMeasure>(criterion, config, model);
  if (!criterion.quantity.empty()) return std::make_unique<FieldMeasure>(criterion, config, model);
  if (criterion.expression.given())
    return std::make_unique<ProbeMeasure>(
        criterion, [value = ProbeExpression(criterion.expression.name, config.probes, probes)](Snapshot& snapshot) {
          return value.value(snapshot);
        });
  const auto probe = std::ranges::find(config.probes, criterion.probe.name, &config::Probe::name);
  const Probe& one = *probes[static_cast<std::size_t>(probe - config.probes.begin())];
  return std::make_unique<ProbeMeasure>(criterion, [&one](Snapshot& snapshot) { return snapshot.value(one); });
}

}  // namespace creepcontact::results
