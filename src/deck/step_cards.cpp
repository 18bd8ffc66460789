/// Steps and their procedures.

#include <fmt/format.h>

#include "deck_reader.hpp"

namespace creepcontact::deck {

void DeckReader::step(const Card& card) {
  if (step_open_) mistake(card.place, "the step before it has no *END STEP");
  if (into_ != &deck_) return mistake(card.place, "a part or an instance has no steps");
  Step step;
  step.place = card.place;
  step.nonlinear_geometry = card.has("NLGEOM") && upper_case(card.value("NLGEOM")) != "NO";
  if (card.has("PERTURBATION"))
    deck_.impossible.push_back({card.place, card.name, "PERTURBATION: linear perturbation is not known"});
  deck_.steps.push_back(std::move(step));
  step_open_ = true;
}

void DeckReader::end_step(const Card& card) {
  if (!step_open_) mistake(card.place, "there is no *STEP before it");
  step_open_ = false;
}

void DeckReader::procedure(const Card& card, bool is_creep) {
  if (!step_open_) return mistake(card.place, "it belongs between *STEP and *END STEP");
  deck_.steps.back().is_creep = is_creep;
  on_data_ = [this](const DataLine& line) {
    const auto period = line.field(1).empty() ? std::nullopt : real(line, 1);
    if (period && !(*period > 0))
      return mistake(line.place, fmt::format("the step lasts {}; more than 0 is needed", *period));
    if (period) deck_.steps.back().period = *period;
    on_data_ = nullptr;
  };
}

void DeckReader::statics(const Card& card) {
  procedure(card, false);
}

void DeckReader::visco(const Card& card) {
  procedure(card, true);
}

void DeckReader::restart(const Card& card) {
  if (card.has("READ"))
    deck_.impossible.push_back({card.place, card.name, "READ: the deck goes on from the results of another one"});
}

}  // namespace creepcontact::deck
