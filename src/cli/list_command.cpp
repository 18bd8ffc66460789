#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "command.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/config/suggestion.hpp"
#include "creepcontact/material/law_reference.hpp"
#include "creepcontact/simulation/vocabulary.hpp"

namespace creepcontact::cli {

int list(const Command& self, const Arguments& arguments) {
  const std::vector<std::string> lists{"integrators", "laws", "elements", "quantities"};
  CommandLine line(self);
  bool markdown = false;
  line.add_options()("markdown", boost::program_options::bool_switch(&markdown),
                     "laws: as in docs/materials.md, with all that is allowed");
  if (!line.parse(arguments, "one of integrators, laws, elements, quantities")) return 0;
  const std::string& what = line.positional();
  if (std::find(lists.begin(), lists.end(), what) == lists.end()) {
    throw ConfigError(
        fmt::format("list: unknown list '{}'; did you mean '{}'? (allowed: integrators, laws, elements, quantities)",
                    what, config::nearest(what, lists)));
  }
  if (markdown && what != "laws") throw ConfigError("list: --markdown is for laws only");
  std::cout << (markdown ? material::law_reference() : simulation::list(what));
  return 0;
}

}  // namespace creepcontact::cli
