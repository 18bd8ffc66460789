#include "contact_broadcast.hpp"

#include <fmt/format.h>

#include <sstream>
#include <string>
#include <vector>

#include "creepcontact/base/memory.hpp"

namespace creepcontact::creep {
namespace {

/// Sends two messages: the sizes and names of the arrays, a line each, and their numbers.
void broadcast(const Team& team, Memory& memory) {
  std::string table;
  std::vector<double> numbers;
  for (const auto& [name, values] : memory) {
    table += fmt::format("{} {}\n", values.size(), name);
    numbers.insert(numbers.end(), values.begin(), values.end());
  }
  creepcontact::broadcast(team, table, 0);
  creepcontact::broadcast(team, numbers, 0);
  if (team.rank() == 0) return;
  std::istringstream lines(table);
  auto next = numbers.begin();
  std::ptrdiff_t size = 0;
  for (std::string name; lines >> size && lines.get() && std::getline(lines, name); next += size)
    memory[name].assign(next, next + size);
}

template <typename T>
void broadcast_value(const Team& team, T& value) {
  if (team.size() == 1) return;
  Memory memory;
  if (team.rank() == 0) memory.save("", value);
  broadcast(team, memory);
  memory.restore("", value);
}

}  // namespace

void broadcast(const Team& team, std::vector<PathPoint>& points) {
  broadcast_value(team, points);
}

void broadcast(const Team& team, contact::ContactState& state) {
  broadcast_value(team, state);
}

void broadcast(const Team& team, contact::ContactResult& result) {
  broadcast_value(team, result);
}

}  // namespace creepcontact::creep
