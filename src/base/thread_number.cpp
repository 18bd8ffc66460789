#include "thread_number.hpp"

#include <bitset>
#include <mutex>
#include <stdexcept>

namespace creepcontact {
namespace {

/// The numbers in use. Never destroyed: threads may end after main().
struct Numbers {
  std::mutex mutex;
  std::bitset<max_threads> used;
};
Numbers& numbers() {
  static auto* const all = new Numbers;
  return *all;
}

struct Own {
  Own() {
    const std::lock_guard lock(numbers().mutex);
    while (number < max_threads && numbers().used[number]) ++number;
    if (number == max_threads) throw std::length_error("more threads than any machine has cores");
    numbers().used.set(number);
  }
  ~Own() {
    const std::lock_guard lock(numbers().mutex);
    numbers().used.reset(number);
  }
  Own(const Own&) = delete;
  Own& operator=(const Own&) = delete;
  std::size_t number = 0;
};

}  // namespace

std::size_t thread_number() {
  thread_local const Own own;
  return own.number;
}

}  // namespace creepcontact
