#include "contact_log.hpp"

#include <array>

namespace creepcontact::run {

ContactLog::ContactLog(const std::filesystem::path& file, CsvFormat format)
    : file_(file, {"time", "contact_solve", "set_change", "iteration", "method", "residual", "active"}, {}, format) {}

void ContactLog::begin_solve(double time) {
  time_ = time;
  ++solve_;
}

void ContactLog::record(const contact::Iteration& iteration) {
  file_.write(std::to_array<io::CsvCell>({time_, solve_, std::int64_t{iteration.set_change},
                                          std::int64_t{iteration.iteration}, std::string_view(iteration.method),
                                          iteration.residual, static_cast<std::int64_t>(iteration.active)}));
}

}  // namespace creepcontact::run
