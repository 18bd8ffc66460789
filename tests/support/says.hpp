#pragma once
/// Messages are compared by the facts that they name, not by their wording.

#include <gtest/gtest.h>

#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace creepcontact::test {

/// What a library error of kind E says, or "nothing was thrown".
template <typename E>
std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const E& error) {
    return error.what();
  }
  return "nothing was thrown";
}

/// Whether the message names all of the facts, in this order.
inline testing::AssertionResult says(const std::string& message, std::span<const std::string_view> facts) {
  std::size_t from = 0;
  for (const std::string_view fact : facts) {
    const std::size_t found = message.find(fact, from);
    if (found == std::string::npos)
      return testing::AssertionFailure() << "no \"" << fact << "\" after character " << from << " of: " << message;
    from = found + fact.size();
  }
  return testing::AssertionSuccess() << message;
}

/// EXPECT_TRUE(says(message, {"case.toml:3:1", "'botom'", "'bottom'"})).
inline testing::AssertionResult says(const std::string& message, std::initializer_list<std::string_view> facts) {
  return says(message, std::span(facts.begin(), facts.size()));
}

}  // namespace creepcontact::test
