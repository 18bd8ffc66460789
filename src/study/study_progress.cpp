#include "study_progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "creepcontact/base/log.hpp"

namespace creepcontact::study {
namespace {

constexpr std::size_t bar_width = 24;

}  // namespace

StudyProgress::StudyProgress(std::size_t runs) : runs_(runs), terminal_(isatty(STDERR_FILENO) != 0) {}

StudyProgress::~StudyProgress() {
  if (!drawn_.empty()) std::fputs("\r\033[K", stderr);
}

void StudyProgress::count(const StudyRow& row) {
  ++done_;
  if (row.status == "failed") ++failed_;
}

void StudyProgress::finished(const std::string& run, const std::string& settings, const StudyRow& row) {
  count(row);
  if (terminal_) return;
  log::info("{} ({} of {}): {}{}{}{}", run, done_, runs_, row.status,
            row.succeeded() ? fmt::format(", {:.2f} s", row.wall_seconds) : "", settings.empty() ? "" : "; " + settings,
            row.message.empty() ? "" : "; " + row.message);
}

void StudyProgress::kept(const StudyRow& row) {
  count(row);
}

void StudyProgress::draw(std::size_t running) {
  if (!terminal_) return;
  const std::size_t full = runs_ > 0 ? bar_width * done_ / runs_ : bar_width;
  const std::string line =
      fmt::format("[{}{}] {} of {} runs, {} under way{}", std::string(full, '#'), std::string(bar_width - full, '.'),
                  done_, runs_, running, failed_ > 0 ? fmt::format(", {} failed", failed_) : "");
  if (line == drawn_) return;
  std::fputs(("\r" + line + "\033[K").c_str(), stderr);
  std::fflush(stderr);
  drawn_ = line;
}

}  // namespace creepcontact::study
