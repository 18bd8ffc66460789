#include "restart_points.hpp"

#include <utility>

#include "creepcontact/base/team.hpp"

namespace creepcontact::run {

void RestartPoints::keep(io::Checkpoint here) {
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
