#include "creepcontact/io/step_writer.hpp"

#include <fmt/format.h>

namespace creepcontact::io {

StepWriter::StepWriter(const std::filesystem::path& path, Continuation continuation)
    : file_(path,
            {"time", "step", "order", "rhs_evaluations", "elastic_solves", "schwarz_iterations", "active_contacts",
             "error_estimate"},
            continuation) {}

void StepWriter::write(const StepRow& row) {
  file_.write(fmt::format("{},{},{},{},{},{},{},{}", row.time, row.step, row.order, row.work.rhs_evaluations,
                          row.work.elastic_solves, row.work.schwarz_iterations, row.active_contacts,
                          row.error_estimate));
}

}  // namespace creepcontact::io
