#include "static_steps.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "plasticity_tables.hpp"

namespace creepcontact::deck {
namespace {

/// Whether the state depends on the order of the loads.
bool depends_on_path(const Deck& deck) {
  const bool some_yield = std::ranges::any_of(deck.sections, [&](const Section& section) {
    const auto material = deck.materials.find(section.material);
    return material != deck.materials.end() && yields(material->second);
  });
  const auto slides = [](const RawCard& raw) {
    return raw.card.name == "FRICTION" && std::ranges::any_of(raw.data, [](const std::vector<std::string>& line) {
             return !line.empty() && number(line[0]).value_or(0) != 0;
           });
  };
  return some_yield || std::ranges::any_of(deck.cards, slides) ||
         std::ranges::any_of(deck.steps, [&](const Step& step) { return std::ranges::any_of(step.cards, slides); });
}

bool is_condition(const RawCard& raw) {
  static const std::set<std::string> conditions{"BOUNDARY", "CLOAD",       "DLOAD",
                                                "DSLOAD",   "TEMPERATURE", "CHANGE FRICTION"};
  return conditions.contains(raw.card.name);
}

/// Whether a bolt is held while other loads come: its force is that before them.
bool holds_bolts_under_loads(const Deck& deck) {
  const auto holds = [](const RawCard& raw) { return raw.card.name == "BOUNDARY" && raw.card.has("FIXED"); };
  const auto loads = [&](const RawCard& raw) { return is_condition(raw) && !holds(raw) && !raw.data.empty(); };
  if (std::ranges::none_of(deck.cards, [](const RawCard& raw) { return raw.card.name == "PRE-TENSION SECTION"; }))
    return false;
  const auto first =
      std::ranges::find_if(deck.steps, [&](const Step& step) { return std::ranges::any_of(step.cards, holds); });
  return std::any_of(first, deck.steps.end(), [&](const Step& step) { return std::ranges::any_of(step.cards, loads); });
}

bool has_amplitude(const RawCard& raw) {
  return is_condition(raw) && !raw.card.value("AMPLITUDE").empty();
}

bool is_one_load_that_lasts(const Deck& deck) {
  const auto is_static = [](const Step& step) { return !step.takes_time() && step.deforms; };
  return is_static(deck.steps.front()) && std::ranges::count_if(deck.steps, is_static) == 1 &&
         std::ranges::none_of(deck.cards, has_amplitude) &&
         std::ranges::none_of(deck.steps.front().cards, has_amplitude) &&
         std::ranges::none_of(deck.steps[1].cards, is_condition);
}

}  // namespace

double time_of_static_step(const Deck& deck) {
  constexpr double of_shortest = 1e-6;
  constexpr double of_all = 1e-8;  // outputs just before a jump are 1e-9 of the time before it
  const bool warms_up = std::ranges::any_of(deck.steps, &Step::is_transient);
  const bool counts_order = depends_on_path(deck) && !is_one_load_that_lasts(deck);
  if (!warms_up && !counts_order && !holds_bolts_under_loads(deck)) return 0;
  double shortest = std::numeric_limits<double>::infinity(), all = 0;
  for (const Step& step : deck.steps)
    if (step.takes_time()) {
      shortest = std::min(shortest, step.period);
      all += step.period;
    }
  return std::max(of_shortest * shortest, of_all * all);
}

}  // namespace creepcontact::deck
