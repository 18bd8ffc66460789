#include "creepcontact/io/tables/step_writer.hpp"

#include <array>

namespace creepcontact::io {

StepWriter::StepWriter(const std::filesystem::path& path, Continuation continuation, CsvFormat format)
    : file_(path,
            {"time", "step", "order", "rhs_evaluations", "elastic_solves", "schwarz_iterations", "active_contacts",
             "error_estimate"},
            continuation, format) {}

void StepWriter::write(const StepRow& row) {
  file_.write(std::to_array<CsvCell>({row.time, row.step, std::int64_t{row.order}, row.work.rhs_evaluations,
                                      row.work.elastic_solves, row.work.schwarz_iterations, row.active_contacts,
                                      row.error_estimate}));
}

}  // namespace creepcontact::io
