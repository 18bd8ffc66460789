#pragma once
/// What was made for the last few active sets. Evaluations start again and again from the set of the last accepted step
/// and end on a neighbour of it: both stay at hand.

#include <algorithm>
#include <list>
#include <vector>

namespace creepcontact::contact {

/// @tparam T  has active()
template <typename T>
class ActiveSetCache {
 public:
  template <typename Make>
  const T& at(const std::vector<int>& active, const Make& make) {
    const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const T& one) { return one.active() == active; });
    if (found != kept_.end()) {
      kept_.splice(kept_.begin(), kept_, found);
    } else {
      if (kept_.size() == most) kept_.pop_back();
      kept_.push_front(make(active));
    }
    return kept_.front();
  }
  void clear() { kept_.clear(); }

 private:
  static constexpr std::size_t most = 3;
  std::list<T> kept_;  // the last used first
};

}  // namespace creepcontact::contact
