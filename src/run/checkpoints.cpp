#include "checkpoints.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "fingerprint.hpp"

namespace creepcontact::run {
namespace {

const std::string prefix = "integrator.";   // of its arrays
constexpr std::size_t max_differences = 5;  // named

}  // namespace

Checkpoints::Checkpoints(const config::Config& config, const model::Model& model,
                         const std::filesystem::path& directory)
    : config_(config), path_(directory / checkpoint_name), fingerprint_(fingerprint(config, model)) {}

io::Checkpoint Checkpoints::read(std::size_t state_size) const {
  io::Checkpoint checkpoint = io::read_last_checkpoint(path_);
  std::vector<std::string> changes = differences(checkpoint.fingerprint, fingerprint_);
  if (changes.size() > max_differences) {
    const std::size_t more = changes.size() - max_differences;
    changes.resize(max_differences);
    changes.push_back(fmt::format("and {} more", more));
  }
  if (!changes.empty() || checkpoint.state.size() != state_size)
    throw ConfigError(
        fmt::format("{}: the checkpoint belongs to another model than '{}': {}; use the configuration it was written "
                    "with, or run without --resume",
                    path_.string(), config_.file.string(), fmt::join(changes, "; ")));
  return checkpoint;
}

io::Checkpoint Checkpoints::take(double time, const ode::Integrator* integrator,
                                 const creep::CreepSystem& system) const {
  io::Checkpoint checkpoint;
  checkpoint.fingerprint = fingerprint_;
  checkpoint.time = time;
  system.save(checkpoint.arrays);
  if (!integrator) return checkpoint;
  ode::RestartPoint point = integrator->save();
  checkpoint.integrator = config_.time.integrator;
  checkpoint.next_step = point.next_step;
  checkpoint.state = std::move(point.state);
  for (auto& [name, values] : point.memory) checkpoint.arrays[prefix + name] = std::move(values);
  return checkpoint;
}

bool Checkpoints::due() const {
  const std::chrono::duration<double> since = std::chrono::steady_clock::now() - last_;
  return since.count() >= config_.output.checkpoint_seconds;
}

void Checkpoints::write(const io::Checkpoint& checkpoint) {
  if (written_ == checkpoint.time) return;
  io::write_checkpoint(path_, checkpoint);
  written_ = checkpoint.time;
  last_ = std::chrono::steady_clock::now();
}

void restore(const io::Checkpoint& checkpoint, const config::Config& config, ode::Integrator& integrator) {
  if (checkpoint.integrator != config.time.integrator) {
    log::info(
        "time.integrator was '{}' up to t = {:.6g}; '{}' continues from there; results may differ in the last digits "
        "from those of either integrator alone",
        checkpoint.integrator, checkpoint.time, config.time.integrator);
    integrator.initialize(checkpoint.time, checkpoint.state);
    return;
  }
  ode::RestartPoint point{checkpoint.time, checkpoint.next_step, checkpoint.state, {}};
  for (const auto& [name, values] : checkpoint.arrays)
    if (name.starts_with(prefix)) point.memory[name.substr(prefix.size())] = values;
  integrator.restore(point);
}

}  // namespace creepcontact::run
