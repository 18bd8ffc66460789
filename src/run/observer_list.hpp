#pragma once
/// The observers of a run, asked and told in the order of their list.

#include <memory>
#include <vector>

#include "creepcontact/base/stopwatch.hpp"
#include "creepcontact/run/observer.hpp"

namespace creepcontact::run {

class ObserverList {
 public:
  /// @param watch  of the run; must outlive the list
  explicit ObserverList(Stopwatch& watch) : watch_(watch) {}
  void add(std::unique_ptr<Observer> observer);
  /// @param observer  must outlive the list
  void add(Observer& observer) { all_.push_back(&observer); }

  /// @returns the strongest reaction; nobody is asked after the first `go_back`
  Reaction ask(Reaction (Observer::*question)(StepView&), StepView& view) const;
  /// @param part  that the time belongs to
  void tell(void (Observer::*news)(StepView&), StepView& view, Part part = Part::observe) const;
  const std::vector<Observer*>& all() const { return all_; }

  /// True while the run may go back behind the present state.
  bool is_tentative() const;
  bool is_at_restart_point() const;
  void change(RunState& state) const;
  void undo() const;
  void save(creep::Memory& memory) const;
  void restore(const creep::Memory& memory) const;
  bool is_writing() const;
  void wait() const;
  void sync() const;
  void end(End how) const;
  void finish(Summary& summary) const;

 private:
  Stopwatch& watch_;
  std::vector<std::unique_ptr<Observer>> own_;
  std::vector<Observer*> all_;
};

}  // namespace creepcontact::run
