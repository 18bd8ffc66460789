#include "creepcontact/simulation/check.hpp"

#include <fmt/format.h>

#include <ostream>

#include "creepcontact/base/error.hpp"
#include "creepcontact/simulation/probes.hpp"
#include "creepcontact/simulation/state_layout.hpp"

namespace creepcontact::simulation {
namespace {

constexpr double state_vectors = 14;  // of CVODE BDF with its Krylov space

std::string element_names(const mesh::Mesh& mesh) {
  std::string text;
  for (const mesh::CellBlock& block : mesh.blocks)
    if (mesh::dimension(block.type) == 3 && block.size() > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", block.size(), mesh::name(block.type));
  return text;
}

}  // namespace

void check(const config::Config& config, std::ostream& report) {
  const Model model = build_model(config);
  make_probes(config, model, model.pairs);
  const StateLayout layout(model);

  std::string text, mistakes;
  double bytes = 8 * state_vectors * static_cast<double>(layout.size());
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const mechanics::Body& body = *model.bodies[b];
    text += fmt::format("body '{}': {}, {} nodes, {} unknowns, {} integration points, material '{}'{}\n", body.name(),
                        element_names(body.mesh()), body.mesh().nodes.size(), body.constraints().n_free(),
                        body.discretization().n_points(), body.material().name,
                        body.material().creeps() ? "" : " (elastic)");
    const auto motions = mechanics::free_rigid_motions(body.mesh().nodes, body.constraints());
    std::string described;
    for (const mechanics::RigidMotion& motion : motions)
      described += (described.empty() ? "" : ", ") + motion.describe();
    text += fmt::format("  rigid-body modes: {}\n", motions.empty() ? "none" : described);
    if (!motions.empty())
      mistakes += fmt::format("{}body '{}' can move freely: {}; add supports that hold it",
                              mistakes.empty() ? "" : "\n", body.name(), described);
    bytes += motions.empty() ? static_cast<double>(body.estimate_factor_bytes()) : 0.0;
    // gradients, weights and coordinates at the integration points
    bytes += 8.0 * 75 * static_cast<double>(body.discretization().n_points());
  }
  for (std::size_t p = 0; p < model.pairs.size(); ++p) {
    const contact::Pair& pair = model.pairs[p];
    const double n = pair.coupling.n_rows();
    text += fmt::format("contact '{}': slave '{}' on '{}', master '{}' on '{}', {} multipliers\n", pair.name,
                        pair.slave_surface, model.bodies[pair.slave_body]->name(), pair.master_surface,
                        model.bodies[pair.master_body]->name(), pair.coupling.nodes.size());
    bytes += 8 * n * n * 12;
  }
  text += fmt::format("state of the differential equation: {} numbers\n", layout.size());
  text += fmt::format("estimated memory: {:.0f} MB\n", bytes / 1e6 + 60);
  report << text << std::flush;
  if (!mistakes.empty()) throw ModelError(mistakes);
}

}  // namespace creepcontact::simulation
