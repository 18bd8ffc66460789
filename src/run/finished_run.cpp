#include "finished_run.hpp"

#include <fmt/format.h>

#include "checkpoints.hpp"
#include "creepcontact/creep/state_layout.hpp"
#include "creepcontact/io/tables/summary.hpp"

namespace creepcontact::run {

std::string nothing_left(const config::Config& config, const model::Model& model,
                         const std::filesystem::path& directory) {
  using Status = io::Summary::Status;
  const auto summary = io::read_summary(directory / "summary.json");
  if (!summary || (summary->status != Status::completed && summary->status != Status::ruptured)) return {};
  const double reached = Checkpoints(config, model, creep::Distribution(model.assembly), directory).read().time;
  if (summary->status == Status::ruptured)
    return fmt::format("nothing is left to do: the run ended by rupture at t = {:.6g}", summary->time_reached);
  for (const config::Event& event : config.events)
    if (const auto found = summary->events.find(event.name);
        event.stop && found != summary->events.end() && found->second && summary->time_reached == *found->second)
      return fmt::format(
          "nothing is left to do: event '{}' stopped the run at t = {:.6g}; to continue it, set stop = false",
          event.name, summary->time_reached);
  if (const auto& cycles = summary->cycles;
      cycles && cycles->steady && config.time.stop_when_steady.value_or(0) >= cycles->steady_within)
    return fmt::format(
        "nothing is left to do: cycle {} repeats the one before it; to continue the run, set a smaller "
        "time.stop_when_steady, or remove it",
        *cycles->steady);
  if (reached < config.time.end) return {};
  return fmt::format(
      "nothing is left to do: the run is complete up to t = {:.6g}; to continue it, set a later time.end", reached);
}

}  // namespace creepcontact::run
