#pragma once
/// Runs that are interrupted and resumed, against the same run at once.

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "verification/case.hpp"

namespace creepcontact::test {

/// Interrupts a run at the first step that reaches a time.
class Interrupter final : public run::Observer {
 public:
  explicit Interrupter(double after) : after_(after) {}
  run::Reaction step(run::StepView& view) override {
    if (view.time() >= after_ && !done_) std::raise(SIGINT);
    done_ = done_ || view.time() >= after_;
    return run::Reaction::advance;
  }

 private:
  double after_;
  bool done_ = false;
};

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Runs at once in `whole` and with interruptions in `parts` of the directory; expects the same histories and steps.
/// @param times  of the interruptions
inline void expect_same_when_resumed(const config::Config& config, const std::filesystem::path& directory,
                                     const std::vector<double>& times) {
  const std::string whole = (directory / "whole").string(), parts = (directory / "parts").string();
  ASSERT_EQ(run::run(config, {.output = whole}).exit_status, 0);
  bool resume = false;
  for (const double time : times) {
    Interrupter interrupter(time);
    ASSERT_EQ(run::run(config, {.output = parts, .resume = resume, .observers = {&interrupter}}).exit_status, 130);
    resume = true;
  }
  ASSERT_EQ(run::run(config, {.output = parts, .resume = true}).exit_status, 0);
  for (const char* file : {"history.csv", "steps.csv"})
    EXPECT_EQ(text_of(directory / "parts" / file), text_of(directory / "whole" / file)) << file;
}

}  // namespace creepcontact::test
