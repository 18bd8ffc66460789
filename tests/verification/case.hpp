#pragma once
/// Runs a configuration given as text, as a user would from its file, and reads the results back.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "creepcontact/config/reader.hpp"
#include "creepcontact/run/run.hpp"
#include "creepcontact/run/vocabulary.hpp"

namespace creepcontact::test {

/// history.csv, or steps.csv
struct History {
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;

  const std::vector<double>& row(double time) const {
    for (const auto& row : rows)
      if (std::abs(row[0] - time) <= 1e-9 * std::max(1.0, std::abs(time))) return row;
    throw std::out_of_range("no output at t = " + std::to_string(time));
  }
  double at(const std::string& name, double time) const {
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i] == name) return row(time)[i];
    throw std::out_of_range("no column " + name);
  }
  std::vector<double> times() const {
    std::vector<double> result;
    for (const auto& row : rows) result.push_back(row[0]);
    return result;
  }
};

struct Outcome {
  int exit_status = 0;
  std::string message;
  History history;
  std::string summary;
  History steps = {};  ///< steps.csv

  /// A number of summary.json.
  double count(const std::string& key) const {
    const std::size_t at = summary.find("\"" + key + "\":");
    return at == std::string::npos ? std::nan("") : std::stod(summary.substr(at + key.size() + 3));
  }
};

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline History read_history(const std::filesystem::path& path) {
  History history;
  std::ifstream file(path);
  std::string line, cell;
  std::getline(file, line);
  std::istringstream header(line);
  while (std::getline(header, cell, ',')) history.names.push_back(cell);
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    history.rows.emplace_back();
    while (std::getline(cells, cell, ',')) history.rows.back().push_back(std::stod(cell));
  }
  return history;
}

/// A directory of the running test's own with the geometry as "case.geo"; removed at the end.
class CaseDirectory {
 public:
  /// @param geo  text of that file; empty: none
  explicit CaseDirectory(const std::string& geo) {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(info->test_suite_name()) + "_" + info->name() + "_" + std::to_string(getpid());
    std::replace(name.begin(), name.end(), '/', '_');
    path_ = std::filesystem::temp_directory_path() / "creepcontact_verification" / name;
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
    if (!geo.empty()) std::ofstream(path_ / "case.geo") << geo;
  }
  ~CaseDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  CaseDirectory(const CaseDirectory&) = delete;
  CaseDirectory& operator=(const CaseDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }
  config::Config config(const std::string& toml, const std::vector<std::string>& overrides) const {
    return config::parse(toml, path_ / "case.toml", run::vocabulary(), overrides);
  }

 private:
  std::filesystem::path path_;
};

/// @param toml  configuration; it may name the mesh "case.geo"
/// @param geo   text of that file; empty: none
/// @param files  other files beside it: names and texts
inline Outcome run_case(const std::string& toml, const std::string& geo, const std::vector<std::string>& overrides = {},
                        const std::vector<std::pair<std::string, std::string>>& files = {}) {
  const CaseDirectory directory(geo);
  for (const auto& [name, text] : files) std::ofstream(directory.path() / name) << text;
  config::Config config = directory.config(toml, overrides);
  config.output.fields = false;
  const auto results = directory.path() / "results";
  const run::RunResult result = run::run(config, {.output = results.string()});
  Outcome outcome{result.exit_status, result.message, read_history(results / "history.csv"),
                  read_text(results / "summary.json"), read_history(results / "steps.csv")};
  EXPECT_EQ(outcome.exit_status, 0) << outcome.message;
  return outcome;
}

/// Relative to the exact value.
#define EXPECT_RELATIVE(value, exact, tolerance) EXPECT_NEAR((value) / (exact), 1.0, tolerance) << "exact: " << (exact)

}  // namespace creepcontact::test
