#include "expression_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "creepcontact/base/named_expression.hpp"

namespace creepcontact::config {
namespace {

class Expressions {
 public:
  Expressions(const std::vector<Probe>& probes, Diagnostics& errors)
      : probes_(probes), errors_(errors), uses_(probes.size()), visit_(probes.size(), Visit::none) {
    for (const Probe& probe : probes) names_.push_back(probe.name == "t" ? "" : probe.name);  // t is the time
    names_.emplace_back("t");
  }

  void check_events(const std::vector<Event>& events) {
    for (const Event& event : events)
      if (event.when.given()) used(event.when, "condition");
  }

  void check_criteria(const std::vector<Criterion>& criteria) {
    for (const Criterion& criterion : criteria)
      if (criterion.expression.given()) used(criterion.expression, "expression");
  }

  void check_probes() {
    for (std::size_t i = 0; i < probes_.size(); ++i)
      if (probes_[i].expression.given()) uses_[i] = used(probes_[i].expression, "expression");
    for (std::size_t i = 0; i < probes_.size(); ++i) visit(i);
  }

 private:
  enum class Visit { none, open, done };

  /// Numbers of the probes that a text names.
  std::vector<std::size_t> used(const Reference& text, const std::string& kind) {
    try {
      std::vector<std::size_t> found = NamedExpression(text.name, names_).used();
      std::erase(found, probes_.size());  // t
      return found;
    } catch (const UnknownName& error) {
      report_name(text, kind, error.name);
    } catch (const std::invalid_argument& error) {
      errors_.add(text.location, fmt::format("{} {}", kind, error.what()),
                  "names of probes, t, numbers, + - * / ^, functions, comparisons, && and ||");
    }
    return {};
  }

  void report_name(const Reference& text, const std::string& kind, const std::string& name) {
    // The parser takes a name as far as it can: "fit-force" is fit - force.
    const auto odd = std::ranges::find_if(probes_, [&](const Probe& probe) {
      return !NamedExpression::can_be_variable(probe.name) && text.name.find(probe.name) != std::string::npos;
    });
    if (odd != probes_.end()) {
      errors_.add(text.location, fmt::format("{} '{}': the name '{}' cannot be used in it", kind, text.name, odd->name),
                  "names of letters, digits and underscores that are not functions; rename this probe");
      return;
    }
    std::vector<std::string> usable;
    for (const std::string& one : names_)
      if (NamedExpression::can_be_variable(one)) usable.push_back(one);
    errors_.add_unknown(text.location, fmt::format("{} '{}': no probe '{}'", kind, text.name, name), name, usable);
  }

  void visit(std::size_t probe) {
    if (visit_[probe] == Visit::done) return;
    if (visit_[probe] == Visit::open) {
      const auto begin = std::ranges::find(path_, probe);
      std::string circle;
      for (auto it = begin; it != path_.end(); ++it) circle += fmt::format("'{}' -> ", probes_[*it].name);
      errors_.add(probes_[probe].expression.location,
                  fmt::format("probes that depend on themselves: {}'{}'", circle, probes_[probe].name),
                  "expressions of probes that do not lead back to the same probe");
      return;
    }
    visit_[probe] = Visit::open;
    path_.push_back(probe);
    for (const std::size_t other : uses_[probe]) visit(other);
    path_.pop_back();
    visit_[probe] = Visit::done;
  }

  const std::vector<Probe>& probes_;
  Diagnostics& errors_;
  std::vector<std::string> names_;              // of the probes, then t
  std::vector<std::vector<std::size_t>> uses_;  // by probe: those that its expression names
  std::vector<Visit> visit_;
  std::vector<std::size_t> path_;
};

}  // namespace

void check_expressions(const Config& config, Diagnostics& errors) {
  Expressions expressions(config.probes, errors);
  expressions.check_probes();
  expressions.check_events(config.events);
  expressions.check_criteria(config.criteria);
}

}  // namespace creepcontact::config
