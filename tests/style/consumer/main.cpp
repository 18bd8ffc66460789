// A program of somebody else's on the installed package: a bar under tension, built in code, creeps by Norton's law;
// then a run of a configuration file, and a probe in its history. Exit status 0 if both are right.
#include <cmath>
#include <creepcontact/config/reader.hpp>
#include <creepcontact/creep/creep_system.hpp>
#include <creepcontact/io/tables/csv_table.hpp>
#include <creepcontact/material/registry.hpp>
#include <creepcontact/ode/integrator.hpp>
#include <creepcontact/results/snapshot.hpp>
#include <creepcontact/run/run.hpp>
#include <creepcontact/run/vocabulary.hpp>
#include <cstdio>
#include <fstream>

using namespace creepcontact;

namespace {

/// One hexahedron, 1 x 1 x 1, with the surfaces x0, x1, y0, z0.
mesh::Mesh cube() {
  mesh::Mesh cube;
  for (const double z : {0.0, 1.0})
    for (const auto& [x, y] : {std::pair(0.0, 0.0), {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
      cube.nodes.emplace_back(x, y, z);
  cube.blocks.push_back({mesh::CellType::hex8, {0, 1, 2, 3, 4, 5, 6, 7}});
  cube.blocks.push_back({mesh::CellType::quad4, {0, 4, 7, 3, 1, 2, 6, 5, 0, 1, 5, 4, 0, 3, 2, 1}});
  cube.groups["x0"] = {"x0", 2, {{1, 0}}};
  cube.groups["x1"] = {"x1", 2, {{1, 1}}};
  cube.groups["y0"] = {"y0", 2, {{1, 2}}};
  cube.groups["z0"] = {"z0", 2, {{1, 3}}};
  return cube;
}

bool bar_creeps_as_it_should() {
  constexpr double stress = 100, young = 2e5, A = 1e-12, n = 3, end = 1000;
  material::Material material;
  material.name = "steel";
  material.young_modulus = young;
  material.poisson_ratio = 0.3;
  material.creep.push_back(material::find_creep_law("norton")->make_by_key({{"A", {A}}, {"n", {n}}}));

  const mesh::Mesh mesh = cube();
  std::vector<mechanics::Support> supports;
  for (const auto& [surface, axis] : {std::pair("x0", 0), {"y0", 1}, {"z0", 2}})
    supports.push_back({surface, mesh::group_nodes(mesh, surface), {Vector3(Vector3::Unit(axis))}, 0.0});
  std::vector<mechanics::Body> bodies;
  bodies.emplace_back("bar", mesh, material, supports, std::nullopt);
  bodies[0].add_load(mechanics::traction_load(mesh, mesh::boundary_faces(mesh, "x1"), {stress, 0.0, 0.0}));
  const creep::Assembly assembly(std::move(bodies), {});

  Stopwatch watch;
  creep::EquilibriumSolver solver(assembly, {}, watch);
  creep::CreepSystem system(solver, creep::survey_elastic_stress(solver, {0, end}, {}), 1e-6, watch);
  const auto integrator = ode::make_integrator("auto", system, {.tolerance = 1e-6, .end_time = end});
  integrator->initialize(0, std::vector<double>(system.size()));
  while (integrator->time() < end) integrator->step(end);
  results::Snapshot snapshot(system, end, system.evaluate_output(end, integrator->state()));
  const double strain = snapshot.fields(0).at_node(1).displacement.x();
  const double exact = stress / young + A * std::pow(stress, n) * end;
  std::printf("strain of the bar %.8g, exact %.8g\n", strain, exact);
  return std::abs(strain / exact - 1) < 1e-5;
}

/// @param directory  to write to
bool configuration_runs(const std::string& directory, const char* configuration) {
  config::Config config = config::read(configuration, run::vocabulary(), {"output.fields=false"});
  config.probes.resize(1);
  const run::Summary result = run::run(config, {.output = directory});
  if (result.exit_status != 0) return false;
  const io::CsvTable history = io::read_csv_table(directory + "/history.csv");
  std::printf("%s: %g at t = %g\n", history.names[1].c_str(), history.columns[1].back(), history.columns[0].back());
  return history.rows() > 1 && std::isfinite(history.columns[1].back());
}

}  // namespace

int main(int count, char** arguments) {
  return count == 3 && bar_creeps_as_it_should() && configuration_runs(arguments[1], arguments[2]) ? 0 : 1;
}
