#pragma once
/// Tells how far a study is: a bar on a terminal, a line a finished run elsewhere.

#include <cstddef>
#include <string>

#include "study_results.hpp"

namespace creepcontact::study {

class StudyProgress {
 public:
  /// @param runs  of the study, the reference among them
  explicit StudyProgress(std::size_t runs);
  ~StudyProgress();
  StudyProgress(const StudyProgress&) = delete;
  StudyProgress& operator=(const StudyProgress&) = delete;

  /// @param settings  of the run, for people
  void finished(const std::string& run, const std::string& settings, const StudyRow& row);
  void kept(const StudyRow& row);
  /// Draws the bar if anything has changed.
  void draw(std::size_t running);

 private:
  void count(const StudyRow& row);

  std::size_t runs_, done_ = 0, failed_ = 0;
  bool terminal_;
  std::string drawn_;
};

}  // namespace creepcontact::study
