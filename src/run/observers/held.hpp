#pragma once
/// Values of steps that may still be undone.

#include <utility>
#include <vector>

namespace creepcontact::run {

/// Keeps values until the run can no more go back behind them.
template <typename T>
class Held {
 public:
  void add(T value) { values_.push_back(std::move(value)); }
  /// Hands all values to use(), in the order of add(). Does nothing while the run is tentative.
  template <typename Use>
  void settle(bool is_tentative, const Use& use) {
    if (is_tentative) return;
    for (const T& value : values_) use(value);
    values_.clear();
  }
  void drop() { values_.clear(); }

 private:
  std::vector<T> values_;
};

}  // namespace creepcontact::run
