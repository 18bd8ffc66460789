#pragma once
/// Values by numbers of nodes or elements, which mostly follow each other without large gaps.

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace creepcontact::deck {

/// Memory: a value and a mark per number where numbers are dense, several times that for the others.
template <class T>
class NumberMap {
 public:
  bool contains(std::int64_t number) const { return find_or_null(number) != nullptr; }
  const T* find_or_null(std::int64_t number) const {
    if (is_dense(number) && known_[static_cast<std::size_t>(number)]) return &dense_[static_cast<std::size_t>(number)];
    const auto found = sparse_.find(number);
    return found == sparse_.end() ? nullptr : &found->second;
  }
  /// Precondition: contains(number)
  const T& at(std::int64_t number) const { return *find_or_null(number); }
  /// Leaves a value that there is. @returns whether it is new
  bool insert(std::int64_t number, T value) {
    if (contains(number)) return false;
    ++size_;
    constexpr std::size_t gap = 8, start = 1024;
    if (number >= 0 && static_cast<std::size_t>(number) < gap * (size_ + start)) {
      if (!is_dense(number)) {
        dense_.resize(static_cast<std::size_t>(number) + 1);
        known_.resize(dense_.size(), false);
      }
      dense_[static_cast<std::size_t>(number)] = std::move(value);
      known_[static_cast<std::size_t>(number)] = true;
    } else {
      sparse_.emplace(number, std::move(value));
    }
    return true;
  }
  std::size_t size() const { return size_; }

 private:
  bool is_dense(std::int64_t number) const { return number >= 0 && static_cast<std::size_t>(number) < dense_.size(); }

  std::vector<T> dense_;
  std::vector<bool> known_;
  std::unordered_map<std::int64_t, T> sparse_;
  std::size_t size_ = 0;
};

}  // namespace creepcontact::deck
