#include "observer_list.hpp"

#include <algorithm>

namespace creepcontact::run {

void ObserverList::add(std::unique_ptr<Observer> observer) {
  all_.push_back(observer.get());
  own_.push_back(std::move(observer));
}

Reaction ObserverList::ask(Reaction (Observer::*question)(StepView&), StepView& view) const {
  const auto lap = watch_.lap(Part::observe);
  Reaction strongest = Reaction::advance;
  const bool was_tentative = is_tentative();
  for (Observer* observer : all_) {
    view.is_tentative = is_tentative();
    strongest = std::max(strongest, (observer->*question)(view));
    if (strongest == Reaction::go_back) return strongest;
  }
  if (was_tentative && !is_tentative())
    for (Observer* observer : all_) observer->keep();
  return strongest;
}

void ObserverList::tell(void (Observer::*news)(StepView&), StepView& view, Part part) const {
  const auto lap = watch_.lap(part);
  view.is_tentative = is_tentative();
  for (Observer* observer : all_) (observer->*news)(view);
}

bool ObserverList::is_tentative() const {
  return std::ranges::any_of(all_, &Observer::may_go_back);
}

bool ObserverList::is_at_restart_point() const {
  return std::ranges::all_of(all_, &Observer::at_restart_point);
}

void ObserverList::change(RunState& state) const {
  for (Observer* observer : all_) observer->change(state);
}

void ObserverList::undo() const {
  for (Observer* observer : all_) observer->undo();
}

void ObserverList::save(creep::Memory& memory) const {
  for (const Observer* observer : all_) observer->save(memory);
}

void ObserverList::restore(const creep::Memory& memory) const {
  for (Observer* observer : all_) observer->restore(memory);
}

bool ObserverList::is_writing() const {
  return std::ranges::any_of(all_, &Observer::is_writing);
}

void ObserverList::wait() const {
  for (Observer* observer : all_) observer->wait();
}

void ObserverList::sync() const {
  for (Observer* observer : all_) observer->sync();
}

void ObserverList::end(End how) const {
  for (Observer* observer : all_) observer->end(how);
}

void ObserverList::finish(Summary& summary) const {
  for (const Observer* observer : all_) observer->finish(summary);
}

}  // namespace creepcontact::run
