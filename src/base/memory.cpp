#include "creepcontact/base/memory.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace creepcontact {

const std::vector<double>& Memory::array(const std::string& name) const {
  const auto found = find(name);
  if (found == end()) throw std::out_of_range(fmt::format("the checkpoint has no array '{}'", name));
  return found->second;
}

const std::vector<double>& Memory::array(const std::string& name, std::size_t size) const {
  const std::vector<double>& numbers = array(name);
  if (numbers.size() != size)
    throw std::out_of_range(
        fmt::format("the array '{}' of the checkpoint has {} numbers instead of {}", name, numbers.size(), size));
  return numbers;
}

}  // namespace creepcontact
