#include "creepcontact/results/criteria.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "criterion_measures.hpp"

namespace creepcontact::results {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::size_t n_kept = Finding::n_numbers + 1;  // and the time

/// Limits of sums and times that are met but for rounding.
constexpr double rounding = 1e-9;

std::string times_of(const config::Criterion& criterion) {
  if (criterion.at) return fmt::format(" at t = {:.6g}", *criterion.at);
  std::string text;
  if (criterion.from) text += fmt::format(" from t = {:.6g}", *criterion.from);
  if (criterion.until) text += fmt::format(" until t = {:.6g}", *criterion.until);
  return text;
}

std::string number_with(double value, const std::string& unit) {
  return fmt::format("{:.5g}", value) + (unit.empty() ? "" : " " + unit);
}

}  // namespace

double utilisation(double found, double allowed, bool is_minimum) {
  if (is_minimum) return utilisation(-found, -allowed, false);
  if (allowed > 0) return found <= 0 ? 0 : found / allowed;
  if (allowed == 0) return found <= 0 ? 0 : infinite;
  return found < 0 ? allowed / found : infinite;
}

void Finding::append_to(std::vector<double>& numbers) const {
  numbers.insert(numbers.end(),
                 {found, allowed, utilisation, static_cast<double>(body), position.x(), position.y(), position.z()});
}

Finding Finding::from(std::span<const double, n_numbers> numbers) {
  return {numbers[0], numbers[1], numbers[2], static_cast<int>(numbers[3]), {numbers[4], numbers[5], numbers[6]}};
}

CriteriaWatch::CriteriaWatch(const config::Config& config, const model::Model& model,
                             std::span<const std::unique_ptr<Probe>> probes)
    : criteria_(config.criteria), worst_(n_kept * config.criteria.size(), none) {
  for (const mechanics::Body& body : model.bodies()) bodies_.push_back(body.name());
  for (std::size_t i = 0; i < criteria_.size(); ++i) {
    const config::Criterion& criterion = criteria_[i];
    measures_.push_back(make_measure(criterion, config, model, probes));
    units_.push_back(unit_of_criterion(criterion, config));
    demands_.push_back(demand_of(criterion, units_.back()) + times_of(criterion));
    for (const std::optional<double>& time : {criterion.from, criterion.until, criterion.at})
      if (time) edges_.push_back({*time, i});
    for (const std::optional<config::CriterionLimit>* limit : {&criterion.min, &criterion.max})
      if (*limit)
        for (const double time : (*limit)->value.breakpoints(config.time.end))
          if (!criterion.at && counts(i, time)) edges_.push_back({time, i});
  }
}

CriteriaWatch::~CriteriaWatch() = default;

bool CriteriaWatch::counts(std::size_t criterion, double time) const {
  const config::Criterion& of = criteria_[criterion];
  const auto before = [](double a, double b) { return a < b - rounding * std::abs(b); };
  if (of.at) return !before(time, *of.at) && !before(*of.at, time);
  return !(of.from && before(time, *of.from)) && !(of.until && before(*of.until, time));
}

std::vector<double> CriteriaWatch::findings(Snapshot& snapshot) const {
  std::vector<double> numbers;
  for (std::size_t i = 0; i < criteria_.size(); ++i) {
    std::vector<double> own;
    if (counts(i, snapshot.time())) own = findings_of(i, snapshot);
    own.resize(Finding::n_numbers, none);
    numbers.insert(numbers.end(), own.begin(), own.end());
  }
  return numbers;
}

std::vector<double> CriteriaWatch::findings_of(std::size_t criterion, Snapshot& snapshot) const {
  std::vector<double> numbers;
  const std::optional<Finding> found = measures_[criterion]->in(snapshot);
  if (found) found->append_to(numbers);
  numbers.resize(Finding::n_numbers, none);
  return numbers;
}

void CriteriaWatch::judge(double time, std::span<const double> findings) {
  for (std::size_t i = 0; i < criteria_.size(); ++i) {
    const auto found = findings.subspan(Finding::n_numbers * i, Finding::n_numbers);
    const std::span<double> kept = std::span(worst_).subspan(n_kept * i, n_kept);
    constexpr std::size_t of_utilisation = 2;
    if (std::isnan(found[of_utilisation]) || kept[of_utilisation] >= found[of_utilisation]) continue;
    std::ranges::copy(found, kept.begin());
    kept.back() = time;
  }
}

std::vector<std::size_t> CriteriaWatch::due(double time) const {
  std::vector<std::size_t> result;
  for (std::size_t e = 0; e < edges_.size(); ++e)
    if (!edges_[e].is_passed && is_due(e, time)) result.push_back(e);
  return result;
}

void CriteriaWatch::fill(io::Summary& summary) const {
  for (std::size_t i = 0; i < criteria_.size(); ++i) {
    io::Summary::Criterion& made = summary.criteria[criteria_[i].name];
    made = {};
    made.is_minimum = is_minimum(criteria_[i]);
    made.demand = demands_[i];
    made.unit = units_[i];
    const std::span<const double> kept = std::span(worst_).subspan(n_kept * i, n_kept);
    if (std::isnan(kept[2])) continue;
    const Finding found = Finding::from(kept.first<Finding::n_numbers>());
    made.met = found.utilisation <= 1 + rounding;
    made.found = found.found;
    made.allowed = found.allowed;
    made.utilisation = found.utilisation;
    made.time = kept.back();
    if (found.body < 0) continue;
    made.body = bodies_[static_cast<std::size_t>(found.body)];
    made.position = {found.position.x(), found.position.y(), found.position.z()};
  }
}

void CriteriaWatch::save(creep::Memory& memory) const {
  std::vector<double> passed;
  for (const Edge& edge : edges_) passed.push_back(edge.is_passed ? 1 : 0);
  memory.save("criteria.worst", worst_);
  memory.save("criteria.passed", passed);
}

void CriteriaWatch::restore(const creep::Memory& memory) {
  std::vector<double> worst, passed;
  memory.restore("criteria.worst", worst);
  memory.restore("criteria.passed", passed);
  if (worst.size() != worst_.size() || passed.size() != edges_.size()) return;
  worst_ = std::move(worst);
  for (std::size_t e = 0; e < edges_.size(); ++e) edges_[e].is_passed = passed[e] != 0;
}

std::string criterion_line(const std::string& name, const io::Summary::Criterion& criterion) {
  std::string text = fmt::format("criterion '{}': ", name);
  if (!criterion.met) return text + fmt::format("not judged: {}", criterion.demand);
  text += fmt::format("{}: {} found, {} {}", *criterion.met ? "met" : "NOT met",
                      number_with(criterion.found, criterion.unit), criterion.is_minimum ? "at least" : "at most",
                      number_with(criterion.allowed, criterion.unit));
  if (std::isfinite(criterion.utilisation)) text += fmt::format(" ({:.0f} %)", 100 * criterion.utilisation);
  text += fmt::format(" at t = {:.6g}", criterion.time);
  if (const auto& x = criterion.position)
    text += fmt::format(", in '{}' at ({:.6g}, {:.6g}, {:.6g})", criterion.body, (*x)[0], (*x)[1], (*x)[2]);
  return text;
}

}  // namespace creepcontact::results
