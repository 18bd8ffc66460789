#include "load_words.hpp"

#include <fmt/format.h>

#include "creepcontact/base/overload.hpp"
#include "creepcontact/base/units.hpp"
#include "creepcontact/model/numbered_nodes.hpp"

namespace creepcontact::run {
namespace {

Vector3 position_of(const config::PointForce& force, const model::Model& model) {
  if (force.at) return Vector3(force.at->at(0), force.at->at(1), force.at->at(2));
  const model::NodeOfBody at = model::nodes_numbered(model.bodies(), force.node).front();
  return model.bodies()[at.body].mesh().nodes[at.node];
}

}  // namespace

std::string vector_text(const std::array<double, 3>& v) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", v[0], v[1], v[2]);
}

std::string vector_text(const std::array<Function, 3>& v) {
  return fmt::format("({}, {}, {})", v[0].text(), v[1].text(), v[2].text());
}

LoadWords load_words(const config::Load& load, const config::Config& config, const model::Model& model) {
  const std::string on = load.on.given() ? load.on.name : load.body.given() ? "body " + load.body.name : "";
  const auto with_unit = [&](const char* name, Dimension dimension, const std::string& value) {
    const std::string unit = unit_of(dimension, config.units);
    return unit.empty() ? fmt::format("{} = {}", name, value) : fmt::format("{} [{}] = {}", name, unit, value);
  };
  return std::visit(
      Overload{[&](const config::Pressure& pressure) {
                 const std::string value = pressure.value.text();
                 return LoadWords{on, with_unit("pressure", Dimension::stress, value),
                                  fmt::format("load '{}': pressure = {}", load.on.name, value)};
               },
               [&](const config::Traction& traction) {
                 return LoadWords{on, with_unit("force per area", Dimension::stress, vector_text(traction.value)),
                                  fmt::format("load '{}': traction", load.on.name)};
               },
               [&](const config::PointForce& force) {
                 const Vector3 x = position_of(force, model);
                 return LoadWords{force.at ? "point " + vector_text(*force.at) : fmt::format("node {}", force.node),
                                  with_unit("force", Dimension::force, vector_text(force.value)),
                                  fmt::format("load: force at ({:.6g}, {:.6g}, {:.6g})", x[0], x[1], x[2]), x};
               },
               [&](const config::BodyForce& force) {
                 return LoadWords{on, fmt::format("force per volume = {}", vector_text(force.value))};
               },
               [&](const config::Rotation& rotation) {
                 return LoadWords{on, fmt::format("rotation about {} through {}: angular velocity {}, density {}",
                                                  vector_text(rotation.axis), vector_text(rotation.origin),
                                                  rotation.angular_velocity.text(), rotation.density.text())};
               }},
      load.kind);
}

}  // namespace creepcontact::run
