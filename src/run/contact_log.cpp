#include "contact_log.hpp"

#include <fmt/format.h>

namespace creepcontact::run {

ContactLog::ContactLog(const std::filesystem::path& file)
    : file_(file, {"time", "contact_solve", "set_change", "iteration", "method", "residual", "active"}, {}) {}

void ContactLog::begin_solve(double time) {
  time_ = time;
  ++solve_;
}

void ContactLog::record(const contact::Iteration& iteration) {
  file_.write(fmt::format("{},{},{},{},{},{:.6g},{}", time_, solve_, iteration.set_change, iteration.iteration,
                          iteration.method, iteration.residual, iteration.active));
}

}  // namespace creepcontact::run
