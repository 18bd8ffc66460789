/// Transient conduction against closed forms: long cylinder and sphere with a film (Carslaw and Jaeger, Conduction of
/// Heat in Solids, 7.7 and 9.4), half spaces with a film, under a flux and brought into contact (2.7, 2.9, 2.15).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "creepcontact/heat/history.hpp"
#include "support/mechanics/meshes.hpp"
#include "support/mechanics/sections.hpp"

namespace creepcontact {
namespace heat_transients {
namespace {

using namespace test;
using heat::Conduction;
using heat::Definition;
using heat::History;
using Kind = heat::SurfaceFlow::Kind;
using enum CellType;
using std::numbers::pi;

mesh::Section section(settings::Analysis analysis) {
  mesh::Section result;
  result.analysis = analysis;
  return result;
}

/// Temperature of a node of body 0 at the end.
double at_end(const Conduction& problem, const mesh::Mesh& mesh, const History& history, const Vector3& x,
              std::size_t body = 0) {
  const std::vector<double> nodes = problem.at_nodes(body, history.values.back());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if ((mesh.nodes[i] - x).norm() < 1e-9) return nodes[i];
  ADD_FAILURE() << "no node there";
  return 0;
}

/// Sum of term(z) over the roots z of f, as long as exp(-z^2 fourier) is anything.
template <typename F, typename Term>
double series(const F& f, double fourier, const Term& term) {
  double sum = 0;
  for (double z = 1e-3; z * z * fourier < 40; z += 0.01) {
    if (f(z) * f(z + 0.01) > 0) continue;
    double low = z, high = z + 0.01;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (f(low) * f(middle) > 0 ? low : high) = middle;
    }
    sum += std::exp(-low * low * fourier) * term(low);
  }
  return sum;
}

/// Of radius 1, from 1 on in a fluid of 0.
double cylinder(double biot, double fourier, double r) {
  const auto J = [](int order, double z) { return std::cyl_bessel_j(order, z); };
  return series([&](double z) { return z * J(1, z) - biot * J(0, z); }, fourier,
                [&](double z) { return 2 / z * J(1, z) / (J(0, z) * J(0, z) + J(1, z) * J(1, z)) * J(0, z * r); });
}

double sphere(double biot, double fourier, double r) {
  return series([&](double z) { return (1 - biot) * std::sin(z) - z * std::cos(z); }, fourier,
                [&](double z) {
                  return 4 * (std::sin(z) - z * std::cos(z)) / (2 * z - std::sin(2 * z)) * std::sin(z * r) / (z * r);
                });
}

/// Cooling in a film, from 1 to 0; conductivity and capacity are 1. At points of the x axis.
void expect_cooling(const mesh::Mesh& mesh, double inner, double (*exact)(double, double, double)) {
  for (const double biot : {0.5, 5.0})
    for (const double fourier : {0.05, 0.3}) {
      Definition all;
      all.bodies = {{"body", &mesh, {1.0}, {}, 1.0}};
      all.flows = {{Kind::film, 0, mesh::boundary_faces(mesh, "x1"), biot, 0.0}};
      Conduction problem(std::move(all));
      const History history = integrate(problem, problem.unknowns(1.0), {fourier, {}, 1e-5});
      for (const double r : {inner, (inner + 1) / 2, 1.0})
        EXPECT_NEAR(at_end(problem, mesh, history, {r, 0, 0}), exact(biot, fourier, r), 2e-5)
            << biot << ' ' << fourier << ' ' << r;
    }
}

TEST(HeatTransients, LongCylinderWithAFilm) {
  expect_cooling(section_mesh(quad8, {16, 1}, {1, 0.1}, {0, 0}, section(settings::Analysis::axisymmetric)), 0,
                 cylinder);
}

TEST(HeatTransients, SphereWithAFilm) {
  const double inner = 1e-3;  // a hole that changes nothing
  const mesh::Mesh mesh =
      mapped(section_mesh(quad8, {16, 6}, {1 - inner, pi / 2}, {inner, 0}, section(settings::Analysis::axisymmetric)),
             [](const Vector3& x) { return Vector3(x.x() * std::cos(x.y()), x.x() * std::sin(x.y()), 0); });
  expect_cooling(mesh, inner, sphere);
}

/// A strip from x = 0 on, so long that its end does not matter before t = 1; conductivity 2, capacity 0.5.
struct HalfSpace {
  static constexpr double k = 2, diffusivity = 4;
  mesh::Mesh mesh = section_mesh(quad8, {80, 1}, {16, 0.2}, {0, 0}, section(settings::Analysis::plane_strain));

  /// From 0 on. @return  temperature at each x
  std::vector<double> heated(const heat::SurfaceFlow& flow, double time, const std::vector<double>& places) const {
    Definition all;
    all.bodies = {{"strip", &mesh, {k}, {}, k / diffusivity}};
    all.flows = {flow};
    Conduction problem(std::move(all));
    const History history = integrate(problem, problem.unknowns(0.0), {time, {}, 1e-5});
    std::vector<double> result;
    for (const double x : places) result.push_back(at_end(problem, mesh, history, {x, 0, 0}));
    return result;
  }
};

const std::vector<double> places{0, 0.4, 2};

TEST(HeatTransients, HalfSpaceWithAFilm) {
  const HalfSpace space;
  const double h = 3;
  for (const double time : {0.1, 1.0}) {
    const auto T = space.heated({Kind::film, 0, mesh::boundary_faces(space.mesh, "x0"), h, 1.0}, time, places);
    const double spread = std::sqrt(HalfSpace::diffusivity * time), H = h / HalfSpace::k;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double x = places[i], s = x / (2 * spread);
      const double exact = std::erfc(s) - std::exp(H * x + H * H * spread * spread) * std::erfc(s + H * spread);
      EXPECT_NEAR(T[i], exact, 2e-5) << time << ' ' << x;
    }
  }
}

TEST(HeatTransients, HalfSpaceUnderAFlux) {
  const HalfSpace space;
  const double q = 1;
  for (const double time : {0.1, 1.0}) {
    const auto T = space.heated({Kind::flux, 0, mesh::boundary_faces(space.mesh, "x0"), q, 0.0}, time, places);
    const double spread = std::sqrt(HalfSpace::diffusivity * time);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double s = places[i] / (2 * spread);
      const double exact = 2 * q / HalfSpace::k * spread * (std::exp(-s * s) / std::sqrt(pi) - s * std::erfc(s));
      EXPECT_NEAR(T[i], exact, 2e-5) << time << ' ' << places[i];
    }
  }
}

/// Two half spaces of 1 and 0 brought into contact: the surface takes the mean weighted by the effusivities 1 and 6.
TEST(HeatTransients, HalfSpacesBroughtIntoContact) {
  const mesh::Mesh hot = section_mesh(quad8, {80, 2}, {8, 0.2}, {-8, 0}, section(settings::Analysis::plane_strain));
  const mesh::Mesh cold = section_mesh(quad8, {80, 3}, {8, 0.2}, {0, 0}, section(settings::Analysis::plane_strain));
  Definition all;
  all.bodies = {{"hot", &hot, {1.0}, {}, 1.0}, {"cold", &cold, {4.0}, {}, 9.0}};
  all.interfaces = {{"joint", 0, 1,
                     contact::facing_faces(hot, mesh::boundary_faces(hot, "x1"), cold, mesh::boundary_faces(cold, "x0"),
                                           std::nullopt),
                     0.0, true}};
  Conduction problem(std::move(all));
  const std::vector<std::vector<double>> start{std::vector<double>(hot.nodes.size(), 1.0),
                                               std::vector<double>(cold.nodes.size(), 0.0)};
  const History history = integrate(problem, problem.unknowns(start), {1, {}, 1e-5});
  const double at_contact = 1.0 / 7;
  for (const double x : {0.0, 0.4, 2.0}) {
    EXPECT_NEAR(at_end(problem, hot, history, {-x, 0, 0}), at_contact + (1 - at_contact) * std::erf(x / 2), 3e-5) << x;
    EXPECT_NEAR(at_end(problem, cold, history, {x, 0, 0}, 1), at_contact * std::erfc(x / 2 * 1.5), 3e-5) << x;
  }
}

}  // namespace
}  // namespace heat_transients
}  // namespace creepcontact
