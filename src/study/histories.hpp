#pragma once
/// The histories of many runs, in bounded memory.

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "creepcontact/io/tables/csv_table.hpp"

namespace creepcontact::study {

class Histories {
 public:
  /// @param most  numbers that are kept in all: of longer histories every second, third, ... row and the last
  explicit Histories(std::vector<std::string> probes, std::size_t runs, std::size_t most = std::size_t{1} << 26);

  /// @param is_whole  whether the run came to the end of its time; else its last row, at which no other run has an
  ///   output, is left out
  void take(std::size_t run, const io::CsvTable& history, bool is_whole);

  /// The times that all whole runs among these have.
  std::vector<double> common_times(const std::vector<std::size_t>& runs) const;
  /// Values of a probe at a time, one per run; NaN: the run has none.
  std::vector<double> at(const std::vector<std::size_t>& runs, std::size_t probe, double time) const;

  const std::vector<std::string>& probes() const { return probes_; }
  bool is_thinned() const { return stride_ > 1; }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  struct Run {
    std::size_t times = none;    // index in times_
    std::vector<double> values;  // probe by probe
    bool is_whole = false;
  };
  std::size_t times_of(std::vector<double> times);

  std::vector<std::string> probes_;
  std::size_t n_runs_, most_, stride_ = 0;
  std::vector<Run> runs_;
  std::vector<std::vector<double>> times_;  // most runs share one
  std::map<std::vector<double>, std::size_t> known_times_;
};

}  // namespace creepcontact::study
