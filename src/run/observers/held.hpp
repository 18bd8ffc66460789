#pragma once
/// Values of states that may still be undone.

#include <functional>
#include <utility>
#include <vector>

namespace creepcontact::run {

/// Uses values at once, or, while the run may go back behind their states, when it does not any more.
template <typename T>
class Held {
 public:
  explicit Held(std::function<void(const T&)> use) : use_(std::move(use)) {}
  void add(T value, bool is_tentative) {
    if (is_tentative)
      values_.push_back(std::move(value));
    else
      use_(value);
  }
  /// Uses all values, in the order of add(). @see Observer::keep
  void keep() {
    for (const T& value : values_) use_(value);
    values_.clear();
  }
  /// @see Observer::undo
  void undo() { values_.clear(); }

 private:
  std::function<void(const T&)> use_;
  std::vector<T> values_;
};

}  // namespace creepcontact::run
