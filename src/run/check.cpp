#include "creepcontact/run/check.hpp"

#include <fmt/format.h>

#include <ostream>

#include "checkpoints.hpp"
#include "creepcontact/config/writer.hpp"
#include "creepcontact/contact/load_balance.hpp"
#include "creepcontact/creep/elastic_survey.hpp"
#include "creepcontact/creep/state_layout.hpp"
#include "creepcontact/mechanics/factored_body.hpp"
#include "creepcontact/model/temperature.hpp"
#include "creepcontact/platform/memory.hpp"
#include "creepcontact/results/probes.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "gap_report.hpp"
#include "heat_alone.hpp"
#include "heat_lines.hpp"
#include "memory_need.hpp"
#include "model_record.hpp"
#include "model_view.hpp"
#include "preparation.hpp"
#include "sensitivity/changed_values.hpp"
#include "start_report.hpp"

namespace creepcontact::run {
namespace {

std::string contact_text(const contact::Pair& pair, const config::Contact& contact, const model::Model& model) {
  std::string text =
      fmt::format("contact '{}': slave '{}' on '{}', master '{}' on '{}', {} multipliers, {}{}\n", pair.name,
                  pair.slave_surface, model.bodies()[pair.slave_body].name(), pair.master_surface,
                  model.bodies()[pair.master_body].name(), pair.coupling.nodes.size(), gap_text(contact, pair),
                  pair.coupling.has_friction() ? ", friction " + contact.friction.text() : "");
  if (const auto warning = gap_warning(model, pair)) text += "  warning: " + *warning + "\n";
  return text;
}

}  // namespace

void check(const config::Config& given, std::ostream& report, const CheckOptions& options) {
  const config::Config config = with_what_is_computed(config::completed(given, vocabulary()));
  changed_values(config);
  const std::filesystem::path directory = output_directory(config, options.output);
  require_output(directory, options.resume);
  const model::Model model = model::build_model(config);
  results::make_probes(config, model);
  const creep::StateLayout layout(model.assembly);

  std::string text;
  for (const std::string& warning : settings_warnings(config)) text += "warning: " + warning + "\n";
  for (const std::string& warning : model::model_warnings(config, model)) text += "warning: " + warning + "\n";
  double contact_bytes = 0;
  for (const mechanics::Body& body : model.bodies()) {
    text += fmt::format("body '{}': {}, {} nodes, {} unknowns, {} integration points, material '{}'{}\n", body.name(),
                        element_names(body.mesh()), body.mesh().n_cell_nodes(), body.constraints().n_free(),
                        body.discretization().n_points(), body.material().name,
                        body.material().plasticity ? (body.material().creeps() ? " (creeps and yields)" : " (yields)")
                        : body.material().creeps() ? ""
                                                   : " (elastic)");
    for (const std::string& warning : model::mesh_warnings(body)) text += "  warning: " + warning + "\n";
    std::string described;
    for (const mechanics::FreeMotion& motion : body.free_motions())
      described += (described.empty() ? "" : ", ") + motion.description;
    text += fmt::format("  rigid-body modes: {}\n", described.empty() ? "none" : described);
  }
  for (std::size_t p = 0; p < model.pairs().size(); ++p) {
    const contact::Pair& pair = model.pairs()[p];
    const auto n = static_cast<double>(pair.coupling.n_rows());
    text += pair.ties_nodes() && pair.gasket
                ? fmt::format("spring '{}': between '{}' and '{}'\n", pair.name,
                              model.bodies()[pair.master_body].name(), model.bodies()[pair.slave_body].name())
            : pair.ties_nodes() ? fmt::format("{}: tied, {} multiplier{}\n", pair.name, pair.coupling.nodes.size(),
                                              pair.coupling.nodes.size() == 1 ? "" : "s")
                                : contact_text(pair, config.contacts[p], model);
    contact_bytes += 8 * n * n * 12;
  }
  const contact::RigidBodyModes& rigid_body_modes = model.assembly.rigid_body_modes();
  if (rigid_body_modes.held().cols() > 0)
    text += fmt::format("rigid-body motions held by contact only: {}\n", rigid_body_modes.held().cols());
  constexpr std::size_t most_motions = 6;
  const std::vector<std::string> motions = rigid_body_modes.describe_unconstrained();
  for (std::size_t i = 0; i < std::min(most_motions, motions.size()); ++i)
    text += fmt::format("not held by supports or contact, must not be loaded: {}\n", motions[i]);
  if (motions.size() > most_motions)
    text += fmt::format("... and {} more motions that nothing holds: give [[supports]] first\n",
                        motions.size() - most_motions);
  if (const auto range = model::temperature_range(config, model))
    text += range->low == range->high ? fmt::format("temperature: {:.6g} everywhere\n", range->low)
                                      : fmt::format("temperature: {:.6g} to {:.6g}\n", range->low, range->high);
  text += heat_check(config, model);
  text += fmt::format("unknowns of the time integration: {}\n", layout.size());
  if (contact_bytes > 1e6 * config.contact_solver.dense_limit_mb) contact_bytes = 0;
  const MemoryNeed need = memory_need(config, model.assembly, contact_bytes, [&](std::size_t b) {
    return static_cast<double>(mechanics::estimate_factor_bytes(model.bodies()[b]));
  });
  text += fmt::format("estimated memory: {}\n", platform::memory_text(need.total() + platform::peak_memory()));
  if (const std::string shortage = memory_shortage(need); !shortage.empty())
    text += fmt::format("warning: {}\n", shortage);
  report << text << std::flush;
  rigid_body_modes.require_contact(model.pairs());
  contact::require_balance(model.bodies(), model.pairs(), rigid_body_modes, model.assembly.at(0), 0);
  if (!config.is_heat_alone()) creep::require_loaded(model.assembly, config.time.output, model.distinct_breakpoints());
  if (options.resume) Checkpoints(config, model, creep::Distribution(model.assembly), directory).read();
  if (options.fields)
    for (const std::filesystem::path& file : write_model_view(config, model, directory))
      report << fmt::format("written: {}\n", file.string());
  if (options.start) report << start_report(config, model, options.processes) << std::flush;
  report << "no mistakes found\n" << std::flush;
}

}  // namespace creepcontact::run
