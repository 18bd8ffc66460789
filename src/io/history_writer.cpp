#include "creepcontact/io/history_writer.hpp"

#include <fmt/format.h>

#include <iterator>

namespace creepcontact::io {
namespace {

std::vector<std::string> columns(const std::vector<std::string>& probes) {
  std::vector<std::string> result{"time"};
  result.insert(result.end(), probes.begin(), probes.end());
  return result;
}

}  // namespace

HistoryWriter::HistoryWriter(const std::filesystem::path& path, const std::vector<std::string>& probes,
                             Continuation continuation)
    : file_(path, columns(probes), continuation) {}

void HistoryWriter::write(double time, std::span<const double> values) {
  row_.clear();
  fmt::format_to(std::back_inserter(row_), "{}", time);
  for (double value : values) fmt::format_to(std::back_inserter(row_), ",{}", value);
  file_.write(row_);
}

}  // namespace creepcontact::io
