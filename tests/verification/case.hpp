#pragma once
/// Runs a configuration given as text, as a user would from its file, and reads the results back.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "creepcontact/config/reader.hpp"
#include "creepcontact/run/run.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "support/run/result_files.hpp"

namespace creepcontact::test {

struct Outcome {
  int exit_status = 0;
  std::string message;
  Table history;
  SummaryFile summary;
  Table steps;
};

/// A directory of the running test's own with the geometry as "case.geo"; removed at the end.
class CaseDirectory {
 public:
  /// @param geo  text of that file; empty: none
  explicit CaseDirectory(const std::string& geo);
  ~CaseDirectory();
  CaseDirectory(const CaseDirectory&) = delete;
  CaseDirectory& operator=(const CaseDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }
  config::Config config(const std::string& toml, const std::vector<std::string>& overrides) const;

 private:
  std::filesystem::path path_;
};

/// @param toml  configuration; it may name the mesh "case.geo"
/// @param geo   text of that file; empty: none
/// @param files  other files beside it: names and texts
Outcome run_case(const std::string& toml, const std::string& geo, const std::vector<std::string>& overrides = {},
                 const std::vector<std::pair<std::string, std::string>>& files = {});

/// The same for a run that must end early: its exit status and message, and the results up to then.
Outcome run_to_failure(const std::string& toml, const std::string& geo, const std::vector<std::string>& overrides = {});

/// Relative to the exact value.
#define EXPECT_RELATIVE(value, exact, tolerance) EXPECT_NEAR((value) / (exact), 1.0, tolerance) << "exact: " << (exact)

}  // namespace creepcontact::test
