#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "command.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/config/suggestion.hpp"
#include "creepcontact/simulation/vocabulary.hpp"

namespace creepcontact::cli {

int list(const Command& self, const Arguments& arguments) {
  const std::vector<std::string> lists{"integrators", "laws", "elements", "quantities"};
  CommandLine line(self);
  if (!line.parse(arguments, "one of integrators, laws, elements, quantities")) return 0;
  const std::string& what = line.positional();
  if (std::find(lists.begin(), lists.end(), what) == lists.end()) {
    throw ConfigError(
        fmt::format("list: unknown list '{}'; did you mean '{}'? (allowed: integrators, laws, elements, quantities)",
                    what, config::nearest(what, lists)));
  }
  std::cout << simulation::list(what);
  return 0;
}

}  // namespace creepcontact::cli
