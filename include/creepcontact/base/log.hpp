#pragma once
/// Program log: plain lines on standard error. Hot loops do not log. Thread-safe.

#include <fmt/format.h>

#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace creepcontact::log {

enum class Level { debug, info, warning, error, off };

/// Messages below this level are dropped; `off` drops all.
void set_level(Level level);
void write(Level level, std::string_view message);

/// Keeps the texts of all warnings that are written while it lives, by any thread, each once; whether they are shown
/// or dropped makes no difference. Several may live at the same time.
class WarningRecord {
 public:
  WarningRecord();
  ~WarningRecord();
  WarningRecord(const WarningRecord&) = delete;
  WarningRecord& operator=(const WarningRecord&) = delete;

  void add(std::string_view message);
  /// In the order of writing.
  std::vector<std::string> texts() const;

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> texts_;
};

template <typename... Args>
void debug(fmt::format_string<Args...> format, Args&&... args) {
  write(Level::debug, fmt::format(format, std::forward<Args>(args)...));
}
template <typename... Args>
void info(fmt::format_string<Args...> format, Args&&... args) {
  write(Level::info, fmt::format(format, std::forward<Args>(args)...));
}
template <typename... Args>
void warning(fmt::format_string<Args...> format, Args&&... args) {
  write(Level::warning, fmt::format(format, std::forward<Args>(args)...));
}
template <typename... Args>
void error(fmt::format_string<Args...> format, Args&&... args) {
  write(Level::error, fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace creepcontact::log
