#include "checkpoints.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/base/team.hpp"
#include "fingerprint.hpp"

namespace creepcontact::run {
namespace {

const std::string integrator_name = "integrator";
const std::string integrator_vectors = vectors_like_state + ".integrator";
constexpr std::size_t max_differences = 5;  // named
const std::string jumps_name = "run.jumps";

bool is_like_state(const std::string& name) {
  return name.starts_with(vectors_like_state + ".");
}

/// The body over whose points an array is.
std::optional<std::size_t> body_of_points(const std::string& name) {
  const std::string part = fmt::format(".{}.", creep::point_arrays);
  const std::size_t at = name.find(part);
  if (at == std::string::npos) return std::nullopt;
  return std::stoul(name.substr(at + part.size()));
}

}  // namespace

Checkpoints::Checkpoints(const config::Config& config, const model::Model& model,
                         const creep::Distribution& distribution, const std::filesystem::path& directory)
    : config_(config),
      distribution_(distribution),
      path_(directory.empty() ? "" : directory / checkpoint_name),
      fingerprint_(fingerprint(config, model)) {}

io::Checkpoint Checkpoints::read() const {
  io::Checkpoint checkpoint;
  together(distribution_.team(), [&] {
    checkpoint = whole();
    checkpoint.state = distribution_.own_states(checkpoint.state);
    for (auto& [name, values] : checkpoint.arrays)
      if (is_like_state(name))
        values = distribution_.own_states(values);
      else if (const auto body = body_of_points(name); body && !values.empty())
        values = distribution_.own_points(*body, values);
  });
  return checkpoint;
}

bool Checkpoints::exist() const {
  return !path_.empty() && path_exists(path_);
}

io::Checkpoint Checkpoints::whole() const {
  io::Checkpoint checkpoint = io::read_last_checkpoint(path_);
  std::vector<std::string> changes = differences(checkpoint.fingerprint, fingerprint_);
  if (changes.size() > max_differences) {
    const std::size_t more = changes.size() - max_differences;
    changes.resize(max_differences);
    changes.push_back(fmt::format("and {} more", more));
  }
  if (!changes.empty() || checkpoint.state.size() != creep::StateLayout(distribution_.whole()).size())
    throw ConfigError(
        fmt::format("{}: the checkpoint belongs to another model than '{}': {}; use the configuration it was written "
                    "with, or run without --resume",
                    path_.string(), config_.file.string(), fmt::join(changes, "; ")));
  return checkpoint;
}

io::Checkpoint Checkpoints::take(const RunState& state, const RunCounters& work, const ode::Integrator& integrator,
                                 const creep::CreepSystem& system) const {
  io::Checkpoint checkpoint;
  checkpoint.fingerprint = fingerprint_;
  checkpoint.time = state.time;
  checkpoint.counters = work;
  checkpoint.arrays.save(jumps_name, state.jumps);
  system.save(checkpoint.arrays);
  ode::RestartPoint point = integrator.save();
  checkpoint.integrator = config_.time.integrator;
  checkpoint.next_step = point.next_step;
  checkpoint.state = std::move(point.state);
  checkpoint.arrays.add(integrator_name, std::move(point.memory));
  checkpoint.arrays.add(integrator_vectors, std::move(point.states));
  return checkpoint;
}

RunState Checkpoints::run_state(const io::Checkpoint& checkpoint) {
  RunState state{.time = checkpoint.time, .y = checkpoint.state, .earlier = checkpoint.counters};
  checkpoint.arrays.restore(jumps_name, state.jumps);
  return state;
}

bool Checkpoints::due() const {
  const std::chrono::duration<double> since = std::chrono::steady_clock::now() - last_;
  const bool own = since.count() >= config_.output.checkpoint_seconds;
  return distribution_.team().any(distribution_.is_root() && own);
}

void Checkpoints::write(const io::Checkpoint& checkpoint) {
  if (path_.empty() || written_ == checkpoint.time) return;
  if (distribution_.team().size() == 1) {
    io::write_checkpoint(path_, checkpoint);
  } else {
    io::Checkpoint all = checkpoint;
    all.state = distribution_.gather_states(checkpoint.state);
    for (auto& [name, values] : all.arrays)
      if (is_like_state(name))
        values = distribution_.gather_states(values);
      else if (const auto body = body_of_points(name))
        values = distribution_.gather_points(*body, values);
    together(distribution_.team(), [&] {
      if (distribution_.is_root()) io::write_checkpoint(path_, all);
    });
  }
  written_ = checkpoint.time;
  last_ = std::chrono::steady_clock::now();
}

void Checkpoints::restore(const io::Checkpoint& checkpoint, ode::Integrator& integrator) const {
  if (checkpoint.integrator != config_.time.integrator && !integrator.name().empty()) {
    log::info(
        "time.integrator was '{}' up to t = {:.6g}; '{}' continues from there; results may differ in the last digits "
        "from those of either integrator alone",
        checkpoint.integrator, checkpoint.time, config_.time.integrator);
    integrator.initialize(checkpoint.time, checkpoint.state);
    return;
  }
  integrator.restore({.time = checkpoint.time,
                      .next_step = checkpoint.next_step,
                      .state = checkpoint.state,
                      .memory = checkpoint.arrays.part(integrator_name),
                      .states = checkpoint.arrays.part(integrator_vectors)});
}

}  // namespace creepcontact::run
