#pragma once
/// What the results of a run depend on, as text: settings, version, and the files that its configuration names.

#include <filesystem>
#include <map>
#include <string>

#include "creepcontact/config/study.hpp"
#include "creepcontact/config/vocabulary.hpp"

namespace creepcontact::study {

class RunRecords {
 public:
  /// Both are referred to and must outlive this.
  RunRecords(const config::Study& study, const config::Vocabulary& vocabulary)
      : study_(study), vocabulary_(vocabulary) {}

  /// Files are read when the first run that names them is asked for. @throws ConfigError as config::read
  std::string of(const config::PlannedRun& run);

 private:
  const std::string& files_of(const std::vector<std::string>& overrides);

  const config::Study& study_;
  const config::Vocabulary& vocabulary_;
  std::map<std::string, std::string> files_;  // lines by the overrides that decide which files there are
};

}  // namespace creepcontact::study
