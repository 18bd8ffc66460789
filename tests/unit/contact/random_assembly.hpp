#pragma once
/// Random assemblies of small boxes: stacks of two to four, and two columns side by side on one base. Boxes may differ
/// in size, mesh, element and stiffness by a factor of a thousand; above the lowest they are held, or float and are
/// pressed off centre.

#include <fmt/format.h>

#include <functional>
#include <random>

#include "creepcontact/mechanics/loads.hpp"
#include "support/contact/boxes.hpp"
#include "support/mechanics/meshes.hpp"
#include "support/mechanics/solve.hpp"

namespace creepcontact::test {

/// What may be chosen without another assembly for the same seed; functions are given the number of the body.
struct RandomChoice {
  std::function<material::Material(int, double young_modulus)> material = [](int, double young_modulus) {
    return elastic_material(young_modulus);
  };
  std::function<std::string(int)> course = [](int) { return "1"; };  ///< of its loads, a factor > 0 over t
  std::optional<mechanics::TemperatureField> temperature = std::nullopt;
};

class RandomBoxes {
 public:
  /// @param friction  coefficient, of all contacts
  explicit RandomBoxes(unsigned seed, double friction = 0, RandomChoice choice = {})
      : generator_(seed), friction_(friction), choice_(std::move(choice)) {
    const bool columns = one_of(4) == 0;
    const int n_bodies = columns ? 3 : 2 + one_of(3);
    strain_ = 1e-3 * (one_of(8) == 0 ? 1000 : 1);  // of gaps: as deformations, or first contact from far away
    Vector3 top = Vector3::Zero();                 // where the next box of a stack stands
    for (int b = 0; b < n_bodies; ++b) {
      Vector3 lengths(uniform(0.8, 1.2), uniform(0.8, 1.2), uniform(0.2, 2));
      if (columns && b == 0) lengths.x() *= 2.5;
      Vector3 origin = top;
      if (columns && b > 0) origin = Vector3(1.2 * (b - 1), 0, top.z());
      add_body(b, lengths, origin, b == n_bodies - 1 || (columns && b > 0));
      if (!columns || b == 0) top.z() += lengths.z();
    }
    for (int b = 1; b < n_bodies; ++b) add_pair(columns ? 0 : static_cast<std::size_t>(b - 1), b);
  }

  std::vector<mechanics::Body> bodies;
  std::vector<contact::Pair> pairs;
  std::string description;

 private:
  int one_of(int n) { return std::uniform_int_distribution<int>(0, n - 1)(generator_); }
  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(generator_); }

  void add_body(int number, const Vector3& lengths, const Vector3& origin, bool is_top) {
    constexpr CellType types[] = {CellType::hex8, CellType::hex20, CellType::tet10, CellType::wedge15, CellType::tet4};
    const CellType type = types[one_of(5)];
    // A single hex20 with its reduced rule has modes without strain.
    const int least = type == CellType::hex20 ? 2 : 1;
    const std::array<int, 3> divisions{least + one_of(4), least + one_of(4), least + one_of(2)};
    const double modulus = std::pow(10.0, uniform(-1.5, 1.5));
    mesh::Mesh mesh = box_mesh(type, divisions, lengths, origin, one_of(2) * 0.25);
    const bool symmetric = one_of(2) == 0, floats = number > 0 && one_of(3) > 0;
    std::vector<mechanics::Support> supports;
    if (symmetric) {
      supports = {support(mesh, "x0", Vector3::UnitX()), support(mesh, "y0", Vector3::UnitY())};
    } else {  // guided: free to tilt
      const std::int64_t a = nearest(mesh, origin), b = nearest(mesh, origin + Vector3(lengths.x(), 0, 0));
      supports = {{"guide", {a}, {Vector3::UnitX(), Vector3::UnitY()}, 0.0}, {"guide", {b}, {Vector3::UnitY()}, 0.0}};
    }
    const double squeeze = strain_ * uniform(-1.5, 0.2);
    if (number == 0)
      supports.push_back(support(mesh, "z0", Vector3::UnitZ()));
    else if (!floats)
      supports.push_back(support(mesh, is_top ? "z1" : "x1", Vector3::UnitZ(),
                                 is_top ? moved(number, squeeze) : moved(number, 0.2 * squeeze)));
    const std::vector<mesh::Face> head = mesh::boundary_faces(mesh, "z1");
    bodies.emplace_back(fmt::format("body {}", number), std::move(mesh), choice_.material(number, modulus),
                        std::move(supports), choice_.temperature);
    // Pressed within the middle third, so that the body does not tilt off.
    const Vector3 middle = origin + lengths / 2;
    if (is_top && floats)
      bodies.back().add_load(mechanics::pressure_load(
          bodies.back().mesh(), head,
          Function::expression(fmt::format("{}*({})*(1 + {}*(x - {}) + {}*(y - {}))", 1e-3, choice_.course(number),
                                           uniform(-0.5, 0.5), middle.x(), uniform(-0.5, 0.5), middle.y()),
                               {"x", "y", "z", "t"})));
    description += fmt::format("{}x{}x{} {} of {:.2f} x {:.2f} x {:.2f}, E {:.3g}{}{}; ", divisions[0], divisions[1],
                               divisions[2], mesh::name(type), lengths.x(), lengths.y(), lengths.z(), modulus,
                               symmetric ? ", symmetric" : "", floats ? ", floating" : "");
  }

  Function moved(int number, double by) const {
    return Function::expression(fmt::format("{}*({})", by, choice_.course(number)), {"t"});
  }

  void add_pair(std::size_t lower, std::size_t upper) {
    const auto surface = [&](std::size_t b, const char* name) {
      return contact::Surface{name, &bodies[b].mesh(), &bodies[b].constraints(),
                              mesh::boundary_faces(bodies[b].mesh(), name), 1.0};
    };
    const contact::Surface low = surface(lower, "z1"), up = surface(upper, "z0");
    const bool lower_is_slave = one_of(2) == 0;
    contact::Pair pair;
    pair.name = fmt::format("{}-{}", lower, upper);
    pair.slave_body = lower_is_slave ? lower : upper;
    pair.master_body = lower_is_slave ? upper : lower;
    const auto type = contact::ContactType::unilateral;
    const contact::Surface &slave = lower_is_slave ? low : up, &master = lower_is_slave ? up : low;
    pair.coupling = contact::mortar_coupling(slave, master, type, {}, friction_ > 0);
    std::vector<Vector3> positions;
    for (const contact::MultiplierNode& node : pair.coupling.nodes) positions.push_back(slave.mesh->nodes[node.node]);
    pair.friction = {friction_, std::nullopt, std::move(positions)};
    pair.gap = Function::expression(
        fmt::format("{}*({} + {}*x + {}*y)", strain_, uniform(-0.5, 0.5), uniform(-1, 1), uniform(-1, 1)),
        {"x", "y", "z", "t"});
    description += fmt::format("slave {}; ", pair.slave_body);
    pairs.push_back(std::move(pair));
  }

  static std::int64_t nearest(const mesh::Mesh& mesh, const Vector3& position) {
    const auto found = std::min_element(mesh.nodes.begin(), mesh.nodes.end(), [&](const Vector3& a, const Vector3& b) {
      return (a - position).norm() < (b - position).norm();
    });
    return found - mesh.nodes.begin();
  }

  std::mt19937 generator_;
  double friction_;
  RandomChoice choice_;
  double strain_ = 1e-3;
};

/// RandomBoxes condensed onto their contact.
class RandomAssembly {
 public:
  explicit RandomAssembly(unsigned seed, double friction = 0) {
    RandomBoxes boxes(seed, friction);
    description = boxes.description;
    condensed = std::make_unique<Condensed>(std::move(boxes.bodies), std::move(boxes.pairs));
  }

  contact::ContactLoad load() {
    std::vector<std::vector<double>> y;
    return condensed->load(0, y);
  }

  std::unique_ptr<Condensed> condensed;
  std::string description;
};

}  // namespace creepcontact::test
