#pragma once
/// The history of all contact iterations of a run, for `creepcontact run --log-contact`.

#include <cstdint>

#include "creepcontact/contact/solver/iteration_recorder.hpp"
#include "creepcontact/io/tables/csv_file.hpp"

namespace creepcontact::run {

class ContactLog final : public contact::IterationRecorder {
 public:
  /// @throws ConfigError if the file cannot be written
  ContactLog(const std::filesystem::path& file, CsvFormat format);

  void begin_solve(double time) override;
  /// A row. @throws Error if the disk does not take it
  void record(const contact::Iteration& iteration) override;

 private:
  io::CsvFile file_;
  double time_ = 0;
  std::int64_t solve_ = 0;
};

}  // namespace creepcontact::run
