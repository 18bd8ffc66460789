#include "restart_points.hpp"

#include <utility>

#include "creepcontact/base/team.hpp"

namespace creepcontact::run {

bool RestartPoints::is_worth_keeping(std::size_t size) const {
  constexpr std::size_t long_state = 20000;
  constexpr double seconds = 1;
  const bool is_late = std::chrono::steady_clock::now() - kept_ > std::chrono::duration<double>(seconds);
  return files_.team().any(is_late || size < long_state);
}

void RestartPoints::keep(io::Checkpoint here) {
  kept_ = std::chrono::steady_clock::now();
  if (files_.team().any(observers_.is_writing())) {
    after_files_ = std::move(here);
    return;
  }
  complete_files();
  newest_ = std::move(here);
}

void RestartPoints::complete_files() {
  std::optional<io::Checkpoint> later = std::exchange(after_files_, {});  // dropped if they fail
  together(files_.team(), [&] { observers_.wait(); });
  if (later) newest_ = std::move(later);
}

void RestartPoints::write() {
  complete_files();
  if (!newest_) return;
  together(files_.team(), [&] { observers_.sync(); });  // a checkpoint implies that all results before it are on disk
  files_.write(*newest_);
}

}  // namespace creepcontact::run
