#include "model_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "load_words.hpp"

namespace creepcontact::run {
namespace {

std::string held_directions(const config::Support& support) {
  std::string text;
  const auto add = [&](const char* name, const std::optional<Function>& value) {
    if (value) text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", name, value->text());
  };
  const std::array<const char*, 3> names{"x", "y", "z"}, cylindrical{"radial", "tangential", "axial"};
  for (std::size_t i = 0; i < 3; ++i) add(names[i], support.displacement[i]);
  add("normal", support.normal);
  for (std::size_t i = 0; i < 3; ++i) add(cylindrical[i], support.cylindrical[i]);
  add("along", support.along);
  return text;
}

}  // namespace

std::vector<Mark> marks(const config::Config& config, const model::Model& model) {
  std::vector<Mark> all;
  for (std::size_t i = 0; i < config.supports.size(); ++i) {
    const config::Support& support = config.supports[i];
    all.push_back({Mark::Kind::support, i, fmt::format("support '{}': {}", support.on.name, held_directions(support)),
                   support.on.name, support.body.name});
  }
  for (std::size_t i = 0; i < config.loads.size(); ++i) {
    const config::Load& load = config.loads[i];
    LoadWords words = load_words(load, config, model);
    if (words.label.empty()) continue;
    Mark& mark = all.emplace_back(Mark{Mark::Kind::load, i, std::move(words.label), load.on.name, load.body.name});
    mark.position = words.position;
  }
  for (std::size_t i = 0; i < config.contacts.size() && i < model.pairs().size(); ++i) {
    const contact::Pair& pair = model.pairs()[i];
    if (pair.ties_nodes()) continue;
    for (const bool slave : {true, false})
      all.push_back({Mark::Kind::contact, i,
                     fmt::format("contact '{}': {} '{}'", pair.name, slave ? "slave" : "master",
                                 slave ? pair.slave_surface : pair.master_surface),
                     slave ? pair.slave_surface : pair.master_surface,
                     model.bodies()[slave ? pair.slave_body : pair.master_body].name()});
  }
  return all;
}

}  // namespace creepcontact::run
