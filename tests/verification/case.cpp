#include "verification/case.hpp"

#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace creepcontact::test {

CaseDirectory::CaseDirectory(const std::string& geo) {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(info->test_suite_name()) + "_" + info->name() + "_" + std::to_string(getpid());
  std::replace(name.begin(), name.end(), '/', '_');
  path_ = std::filesystem::temp_directory_path() / "creepcontact_verification" / name;
  std::filesystem::remove_all(path_);
  std::filesystem::create_directories(path_);
  if (!geo.empty()) std::ofstream(path_ / "case.geo") << geo;
}

CaseDirectory::~CaseDirectory() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

config::Config CaseDirectory::config(const std::string& toml, const std::vector<std::string>& overrides) const {
  return config::parse(toml, path_ / "case.toml", run::vocabulary(), overrides);
}

namespace {

Outcome run_in(const CaseDirectory& directory, const std::string& toml, const std::vector<std::string>& overrides) {
  config::Config config = directory.config(toml, overrides);
  config.output.fields = false;
  const auto results = directory.path() / "results";
  const run::Summary result = run::run(config, {.output = results.string()});
  return {result.exit_status, result.message, Table(results / "history.csv"), SummaryFile(results / "summary.json"),
          Table(results / "steps.csv")};
}

}  // namespace

Outcome run_case(const std::string& toml, const std::string& geo, const std::vector<std::string>& overrides,
                 const std::vector<std::pair<std::string, std::string>>& files) {
  const CaseDirectory directory(geo);
  for (const auto& [name, text] : files) std::ofstream(directory.path() / name) << text;
  Outcome outcome = run_in(directory, toml, overrides);
  EXPECT_EQ(outcome.exit_status, 0) << outcome.message;
  return outcome;
}

Outcome run_to_failure(const std::string& toml, const std::string& geo, const std::vector<std::string>& overrides) {
  Outcome outcome = run_in(CaseDirectory(geo), toml, overrides);
  EXPECT_NE(outcome.exit_status, 0);
  return outcome;
}

}  // namespace creepcontact::test
