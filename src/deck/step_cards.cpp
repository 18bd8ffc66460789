/// Steps and their procedures.

#include <fmt/format.h>

#include <algorithm>

#include "deck_reader.hpp"

namespace creepcontact::deck {

void DeckReader::step(const Card& card) {
  if (step_open_) mistake(card.place, "the step before it has no *END STEP");
  if (into_ != &deck_) return mistake(card.place, "a part or an instance has no steps");
  Step step;
  step.place = card.place;
  step.nonlinear_geometry = card.has("NLGEOM") && upper_case(card.value("NLGEOM")) != "NO";
  step.ramps = upper_case(card.value("AMPLITUDE"));
  deck_.steps.push_back(std::move(step));
  step_open_ = true;
}

void DeckReader::end_step(const Card& card) {
  if (!step_open_) return mistake(card.place, "there is no *STEP before it");
  if (const Step& step = deck_.steps.back(); !step.has_procedure && deck_.impossible.empty())
    deck_.impossible.push_back(
        {step.place, "STEP", "it has no procedure; *STATIC, *VISCO and *HEAT TRANSFER are known"});
  step_open_ = false;
}

void DeckReader::procedure(const Card& card, bool is_creep) {
  if (!step_open_) return mistake(card.place, "it belongs between *STEP and *END STEP");
  Step& step = deck_.steps.back();
  if (step.has_procedure) return mistake(card.place, "the step has a procedure already");
  step.has_procedure = true;
  step.is_creep = is_creep;
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

void DeckReader::no_analysis(const Card& card) {
  deck_.left_out.push_back({card.place, card.name, "the step is computed as a *STATIC one"});
  procedure(card, false);
}

void DeckReader::visco(const Card& card) {
  procedure(card, true);
}

void DeckReader::heat_transfer(const Card& card) {
  conducting_procedure(card, false);
}

void DeckReader::temperature_displacement(const Card& card) {
  conducting_procedure(card, true);
}

void DeckReader::conducting_procedure(const Card& card, bool deforms) {
  procedure(card, false);
  if (!step_open_) return;
  Step& step = deck_.steps.back();
  step.conducts = true;
  step.is_steady = card.has("STEADYSTATE");
  step.deforms = deforms;
  step.is_creep =
      deforms && std::ranges::any_of(deck_.materials, [](const auto& one) { return one.second.creep.has_value(); });
  if (card.has("TIMERESET") && deck_.steps.size() > 1)
    deck_.impossible.push_back({card.place, card.name, "TIME RESET: a total time that is set again is not known"});
}

}  // namespace creepcontact::deck
