#include "creepcontact/io/tables/history_writer.hpp"

namespace creepcontact::io {
namespace {

std::vector<std::string> columns(const std::vector<std::string>& probes) {
  std::vector<std::string> result{"time"};
  result.insert(result.end(), probes.begin(), probes.end());
  return result;
}

}  // namespace

HistoryWriter::HistoryWriter(const std::filesystem::path& path, const std::vector<std::string>& probes,
                             Continuation continuation, CsvFormat format)
    : file_(path, columns(probes), continuation, format) {}

void HistoryWriter::write(double time, std::span<const double> values) {
  row_.assign(1, time);
  row_.insert(row_.end(), values.begin(), values.end());
  file_.write(row_);
}

}  // namespace creepcontact::io
