#include "creepcontact/simulation/check.hpp"

#include <fmt/format.h>

#include <ostream>

#include "creepcontact/simulation/probes.hpp"
#include "creepcontact/simulation/state_layout.hpp"
#include "gap_report.hpp"
#include "temperature.hpp"

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

  std::string text;
  for (const std::string& warning : settings_warnings(config)) text += "warning: " + warning + "\n";
  double bytes = 8 * state_vectors * static_cast<double>(layout.size());
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const mechanics::Body& body = *model.bodies[b];
    text += fmt::format("body '{}': {}, {} nodes, {} unknowns, {} integration points, material '{}'{}\n", body.name(),
                        element_names(body.mesh()), body.mesh().nodes.size(), body.constraints().n_free(),
                        body.discretization().n_points(), body.material().name,
                        body.material().creeps() ? "" : " (elastic)");
    for (const std::string& warning : mesh_warnings(body)) text += "  warning: " + warning + "\n";
    std::string described;
    for (const mechanics::FreeMotion& motion : body.free_motions())
      described += (described.empty() ? "" : ", ") + motion.description;
    text += fmt::format("  rigid-body modes: {}\n", described.empty() ? "none" : described);
    const bool has_tangent = config.time.linear_solver == config::LinearSolver::tangent && body.material().creeps();
    bytes += (has_tangent ? 2 : 1) * static_cast<double>(body.estimate_factor_bytes());
    // gradients, weights and coordinates at the integration points; what a tangent eliminates there
    const auto stride = static_cast<double>(layout.stride(b));
    const double numbers = 75 + (has_tangent ? 36 + stride * (stride + 6) : 0);
    bytes += 8 * numbers * static_cast<double>(body.discretization().n_points());
  }
  for (std::size_t p = 0; p < model.pairs.size(); ++p) {
    const contact::Pair& pair = model.pairs[p];
    const double n = pair.coupling.n_rows();
    text += fmt::format("contact '{}': slave '{}' on '{}', master '{}' on '{}', {} multipliers, {}\n", pair.name,
                        pair.slave_surface, model.bodies[pair.slave_body]->name(), pair.master_surface,
                        model.bodies[pair.master_body]->name(), pair.coupling.nodes.size(),
                        gap_text(config.contacts[p], pair));
    if (const auto warning = gap_warning(model, pair)) text += "  warning: " + *warning + "\n";
    bytes += 8 * n * n * 12;
  }
  const contact::FloatingMotions floating(model.bodies, model.pairs);
  if (floating.held().cols() > 0) text += fmt::format("held by contact alone: {} motions\n", floating.held().cols());
  for (const std::string& motion : floating.describe_idle())
    text += fmt::format("held by nothing, must not be loaded: {}\n", motion);
  if (const auto range = temperature_range(config, model))
    text += range->low == range->high ? fmt::format("temperature: {:.6g} everywhere\n", range->low)
                                      : fmt::format("temperature: {:.6g} to {:.6g}\n", range->low, range->high);
  text += fmt::format("state of the differential equation: {} numbers\n", layout.size());
  text += fmt::format("estimated memory: {:.0f} MB\n", bytes / 1e6 + 60);
  report << text << std::flush;
  floating.require_contact(model.pairs);
  report << "no mistakes found\n" << std::flush;
}

}  // namespace creepcontact::simulation
