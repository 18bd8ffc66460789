#pragma once
/// Program log: plain lines on standard error, or what a caller does with them. Hot loops do not log. Thread-safe.

#include <fmt/format.h>

#include <functional>
#include <memory>
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

using Sink = std::function<void(Level, std::string_view)>;

/// Gives the messages of this thread to a sink instead, while it lives: all of them, whatever their level. Helper
/// threads have the sink of the thread that gives them work (platform::Background).
class Redirection {
 public:
  /// @param sink  may be called by helper threads while this one goes on; null: standard error
  explicit Redirection(std::shared_ptr<const Sink> sink);
  ~Redirection();
  Redirection(const Redirection&) = delete;
  Redirection& operator=(const Redirection&) = delete;

 private:
  std::shared_ptr<const Sink> before_;
};
/// The sink of this thread; null: standard error.
std::shared_ptr<const Sink> sink();

/// Keeps the texts of all warnings that are written while it lives, by any thread with the sink of its own, each once;
/// whether they are shown or dropped makes no difference. Several may live at the same time.
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
  friend void write(Level level, std::string_view message);

  std::shared_ptr<const Sink> sink_ = sink();
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
