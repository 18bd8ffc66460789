#include "print_cards.hpp"

#include <algorithm>

namespace creepcontact::deck {

bool asks_for(const RawCard& raw, const std::string& what) {
  return std::ranges::any_of(raw.data, [&](const std::vector<std::string>& line) {
    return std::ranges::any_of(line, [&](const std::string& field) { return upper_case(field) == what; });
  });
}

}  // namespace creepcontact::deck
