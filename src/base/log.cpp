#include "creepcontact/base/log.hpp"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <map>
#include <utility>

#include "creepcontact/base/log_notice.hpp"

namespace creepcontact::log {
namespace {

spdlog::level::level_enum native(Level level) {
  switch (level) {
    case Level::debug:
      return spdlog::level::debug;
    case Level::info:
      return spdlog::level::info;
    case Level::warning:
      return spdlog::level::warn;
    case Level::error:
      return spdlog::level::err;
    case Level::off:
      return spdlog::level::off;
  }
  return spdlog::level::info;
}

spdlog::logger& logger() {
  static const auto instance = [] {
    auto made = spdlog::stderr_color_mt("creepcontact");
    made->set_pattern("%^%l%$: %v");
    return made;
  }();
  return *instance;
}

/// The records that live, and what guards their list.
struct Records {
  std::mutex mutex;
  std::vector<WarningRecord*> all;
};
Records& records() {
  static Records instance;
  return instance;
}

/// What is called before messages.
struct Notice {
  std::mutex mutex;
  std::function<void()> f;
};
Notice& notice() {
  static Notice instance;
  return instance;
}

std::shared_ptr<const Sink>& own_sink() {
  thread_local std::shared_ptr<const Sink> own;
  return own;
}

}  // namespace

Redirection::Redirection(std::shared_ptr<const Sink> sink) : before_(std::exchange(own_sink(), std::move(sink))) {}

Redirection::~Redirection() {
  own_sink() = std::move(before_);
}

std::shared_ptr<const Sink> sink() {
  return own_sink();
}

void before_messages(std::function<void()> f) {
  const std::scoped_lock lock(notice().mutex);
  notice().f = std::move(f);
}

WarningRecord::WarningRecord() {
  const std::scoped_lock lock(records().mutex);
  records().all.push_back(this);
}

WarningRecord::~WarningRecord() {
  const std::scoped_lock lock(records().mutex);
  std::erase(records().all, this);
}

void WarningRecord::add(std::string_view message) {
  const std::scoped_lock lock(mutex_);
  constexpr std::size_t most = 10'000;  // beyond which repetitions are not counted any more
  if (texts_.size() < most || std::ranges::find(texts_, message) == texts_.end()) texts_.emplace_back(message);
}

std::vector<std::string> WarningRecord::texts() const {
  const std::scoped_lock lock(mutex_);
  std::vector<std::string> each;
  std::map<std::string_view, int> times;
  for (const std::string& text : texts_)
    if (times[text]++ == 0) each.push_back(text);
  for (std::string& text : each)
    if (const int n = times[text]; n > 1) text += fmt::format(" ({} times)", n);
  return each;
}

void set_level(Level level) {
  logger().set_level(native(level));
}

void write(Level level, std::string_view message) {
  if (level == Level::warning) {
    const std::scoped_lock lock(records().mutex);
    for (WarningRecord* record : records().all)
      if (record->sink_ == own_sink()) record->add(message);
  }
  if (const std::shared_ptr<const Sink> own = own_sink()) {
    (*own)(level, message);
    return;
  }
  if (logger().should_log(native(level))) {
    const std::scoped_lock lock(notice().mutex);
    if (notice().f) notice().f();
  }
  logger().log(native(level), message);
}

}  // namespace creepcontact::log
