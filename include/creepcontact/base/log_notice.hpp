#pragma once
/// Notice of messages of the log, for what else is on the terminal.

#include <functional>

namespace creepcontact::log {

/// Calls f before every message that is shown, in the thread that writes it; to clear a line on the terminal. An empty
/// f ends this. Thread-safe.
void before_messages(std::function<void()> f);

}  // namespace creepcontact::log
