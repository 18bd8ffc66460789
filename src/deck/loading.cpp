#include "loading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "card_parameters.hpp"
#include "element_faces.hpp"
#include "static_steps.hpp"

namespace creepcontact::deck {
namespace {

const char* const of_users = "values from subroutines of users are not known";

/// A load or support of one node, face or group of elements, with what acts on it at present.
struct Entry {
  Course course;
  double rest = 0;    // value before anything was given
  double target = 0;  // value without amplitude, at the end of the present step
  const Amplitude* amplitude = nullptr;
  bool is_new = false;      // given in the present step
  bool begins = false;      // given before the steps with a value, which the first step brings
  bool is_dropped = false;  // by OP=NEW
  // Supports: times between which they act. Free at present: the last one has an end, or there is none.
  std::vector<Window> windows = {};
};

enum class Condition {
  support,
  force,
  mass_force,  // of gravity or rotation on a mass at a node: added to the force there
  body_load,
  pressure,
  temperature,
  // of heat; a film and radiation have two values each
  given_temperature,
  film_coefficient,
  fluid,
  emissivity,
  ambient,
  flux,
  source,
  point_flow,
};

bool is_of_heat(Condition kind) {
  return kind >= Condition::given_temperature;
}
/// Conditions that hold from their step on, and may be released.
bool is_held(Condition kind) {
  return kind == Condition::support || kind == Condition::given_temperature;
}
/// Loads that one step gives twice at one place add up; others are replaced, as are those of earlier steps.
bool adds_up(Condition kind) {
  static const std::set<Condition> all{Condition::force,     Condition::mass_force, Condition::pressure,
                                       Condition::body_load, Condition::flux,       Condition::source,
                                       Condition::point_flow};
  return all.contains(kind);
}

/// Where a card of heat has its place, its values and what releases them.
struct FaceFlow {
  char letter = 0;  ///< of the label of a face: F1
  Condition factor{}, beyond{};
  const char* own_amplitude = "";  ///< of the factor
};

struct Key {
  Condition kind{};
  std::int64_t of = 0;
  int part = 0;
  auto operator<=>(const Key&) const = default;  // NOLINT(modernize-use-nullptr): it sees a 0 in the default
};

class Joiner {
 public:
  Joiner(const Deck& deck, const std::set<std::int64_t>& lockable, std::vector<Note>& impossible,
         std::vector<Note>& left_out)
      : deck_(deck), resolver_(deck), lockable_(lockable), impossible_(impossible), left_out_(left_out) {
    time_runs_ = std::ranges::any_of(deck.steps, &Step::takes_time);
    if (time_runs_) static_time_ = time_of_static_step(deck);
  }

  Loading join() {
    read_masses();
    for (const RawCard& raw : deck_.cards) {
      if (raw.card.name == "BOUNDARY") boundary(raw);
      if (raw.card.name == "INITIAL CONDITIONS") initial(raw);
    }
    for (const auto& [copy, original] : deck_.copies)
      if (const auto found = loading_.initial_temperatures.find(original); found != loading_.initial_temperatures.end())
        loading_.initial_temperatures[copy] = found->second;
    simplify_initial_temperatures();
    // Values of supports before the steps are reached in the first one, as in CalculiX.
    for (auto& [key, entry] : entries_) {
      entry.begins = entry.target != entry.rest;
      entry.is_new = false;
    }
    double time = 0, total = 0;
    for (const Step& step : deck_.steps) {
      if (step.nonlinear_geometry && !warned_of_geometry_) {
        left_out_.push_back({step.place, "STEP", "NLGEOM: displacements are taken as small"});
        warned_of_geometry_ = true;
      }
      frees_bolts_ = nullptr;
      held_bolts_.clear();
      for (const RawCard& raw : step.cards) {
        if (raw.card.name == "BOUNDARY") boundary(raw);
        if (raw.card.name == "CLOAD") concentrated(raw);
        if (raw.card.name == "DLOAD") distributed(raw);
        if (raw.card.name == "DSLOAD") on_surfaces(raw);
        if (raw.card.name == "TEMPERATURE") temperature(raw);
        heat(raw);
      }
      if (frees_bolts_ != nullptr && held_bolts_.size() < loading_.locked.size())
        impossible(*frees_bolts_, frees_bolts_->places.size(),
                   "OP=NEW frees a bolt whose length was held; FIXED holds it again");
      const double duration = duration_of(step);
      if (static_time_ > 0 && !step.takes_time()) note_static_time(step);
      if (step.conducts) check_steady_states(step);
      for (auto& [key, entry] : entries_) entry.is_new = std::exchange(entry.begins, false) || entry.is_new;
      for (auto& [key, entry] : entries_)
        if (is_of_heat(key.kind) && step.is_steady)
          reach_at_once(entry, step, time, duration, total);
        else
          advance(entry, step, time, duration, total);
      time += duration;
      total += step.period;
      loading_.step_ends.push_back(time);
      if (step.takes_time()) crept_until_ = time;
    }
    tell_idle_masses();
    loading_.end = time;
    if (deck_.conducts()) loading_.heat.time_of_states = static_time_;
    for (auto& [key, entry] : entries_) store(key, entry);
    std::erase_if(loading_.bodies, [](const Loading::Body& body) { return body.course.is_zero(); });
    return std::move(loading_);
  }

 private:
  double duration_of(const Step& step) const {
    if (step.is_steady && !step.deforms) return static_time_;
    return time_runs_ && !step.takes_time() ? static_time_ : step.period;
  }

  void note_static_time(const Step& step) {
    if (std::exchange(noted_static_time_, true)) return;
    if (std::ranges::any_of(deck_.steps, &Step::is_transient)) {
      left_out_.push_back({step.place, "STEP",
                           fmt::format("temperatures go on changing, so each *STATIC step and each steady state takes "
                                       "{:g} of time in the run, in which they do not change noticeably",
                                       static_time_)});
      return;
    }
    left_out_.push_back(
        {step.place, "STATIC",
         fmt::format("what yields or slides, or holds a bolt, depends on the order of the loads, so each *STATIC step "
                     "takes {:g} of time in the run, in which creep is negligible",
                     static_time_)});
  }
  /// The run has one steady state, at its begin: with the loads of the first step that computes one.
  void check_steady_states(const Step& step) {
    const auto refuse = [&](const char* why) { impossible_.push_back({step.place, "STEP", why}); };
    const bool is_first = !std::exchange(has_conducted_, true);
    if (!step.is_steady) {
      warms_up_ = true;
      return;
    }
    if (warms_up_) return refuse("a steady state after a transient; a transient step that is long enough reaches it");
    if (is_first) {
      if (!loading_.step_ends.empty())
        refuse("a steady state after *STATIC or *VISCO steps, in which the temperature would be another one");
      return;
    }
    if (std::ranges::any_of(entries_, [](const auto& one) {
          const Entry& entry = one.second;
          return is_of_heat(one.first.kind) &&
                 (entry.is_new || entry.is_dropped || (entry.amplitude != nullptr && entry.amplitude->total_time));
        }))
      refuse(
          "a steady state after another one, with other films, flows or temperatures; make a deck for each steady "
          "state, or a transient step between them");
  }

  void impossible(const RawCard& raw, std::size_t line, const std::string& why) {
    impossible_.push_back({line < raw.places.size() ? raw.places[line] : raw.card.place, raw.card.name, why});
  }
  std::string field(const RawCard& raw, std::size_t line, std::size_t i) {
    return i < raw.data[line].size() ? raw.data[line][i] : "";
  }
  double value(const RawCard& raw, std::size_t line, std::size_t i) {
    const std::string text = field(raw, line, i);
    if (text.empty()) return 0;
    const std::optional<double> found = number(text);
    if (!found) impossible(raw, line, fmt::format("'{}' is not a number", text));
    return found.value_or(0);
  }
  const Amplitude* amplitude(const RawCard& raw, const char* parameter = "AMPLITUDE") {
    const std::string name = raw.card.value(parameter);
    if (name.empty()) return nullptr;
    const auto found = deck_.amplitudes.find(upper_case(name));
    if (found == deck_.amplitudes.end() || found->second.points.empty()) {
      impossible(raw, raw.places.size(), fmt::format("there is no amplitude '{}'", name));
      return nullptr;
    }
    return &found->second;
  }
  bool replaces(const RawCard& raw) { return upper_case(raw.card.value("OP")) == "NEW"; }
  /// OP=NEW takes back what earlier steps gave, at the first card of its kind in a step.
  void drop(Condition kind) {
    for (auto& [key, entry] : entries_)
      if (key.kind == kind && !entry.is_new) entry.is_dropped = true;
  }
  void give(const RawCard& raw, std::size_t line, const Key& key, double target, const Amplitude* amplitude) {
    const auto [found, is_first] = entries_.try_emplace(key);
    Entry& entry = found->second;
    if (entry.is_new && adds_up(key.kind)) {
      if (entry.amplitude != amplitude)
        return impossible(raw, line, "two loads of one step at one place with different amplitudes; join these to one");
      target += entry.target;
    }
    if (is_first && (key.kind == Condition::temperature || key.kind == Condition::given_temperature))
      entry.rest = initial_temperature(key.of);
    if (is_first) entry.course.add(0, entry.rest);
    if (is_first && !loading_.step_ends.empty()) entry.course.add(loading_.step_ends.back(), entry.rest);
    if (is_held(key.kind) && (is_first || entry.windows.back().until)) {
      entry.windows.emplace_back();
      if (!loading_.step_ends.empty()) entry.windows.back().from = loading_.step_ends.back();
    }
    entry.target = target;
    entry.amplitude = amplitude;
    entry.is_new = true;
    entry.is_dropped = false;
  }

  void boundary(const RawCard& raw) {
    if (replaces(raw)) {
      drop(Condition::support);
      drop(Condition::given_temperature);
      if (!loading_.step_ends.empty()) frees_bolts_ = &raw;
    }
    const Amplitude* factors = amplitude(raw);
    for (std::size_t line = 0; line < raw.data.size(); ++line) {
      const Numbers nodes = resolver_.nodes(field(raw, line, 0));
      if (nodes.empty()) impossible(raw, line, fmt::format("there is no node or set '{}'", field(raw, line, 0)));
      static const std::map<std::string, std::vector<int>> named{{"ENCASTRE", {1, 2, 3, 4, 5, 6}},
                                                                 {"PINNED", {1, 2, 3}},
                                                                 {"XSYMM", {1, 5, 6}},
                                                                 {"YSYMM", {2, 4, 6}},
                                                                 {"ZSYMM", {3, 4, 5}},
                                                                 {"XASYMM", {2, 3, 4}},
                                                                 {"YASYMM", {1, 3, 5}},
                                                                 {"ZASYMM", {1, 2, 6}}};
      std::vector<int> directions;
      if (const auto found = named.find(upper_case(field(raw, line, 1))); found != named.end()) {
        directions = found->second;
      } else {
        const auto first = whole_number(field(raw, line, 1));
        const auto last = field(raw, line, 2).empty() ? first : whole_number(field(raw, line, 2));
        if (first && is_temperature(*first) && first == last) {
          given_temperature(raw, line, nodes, factors);
          continue;
        }
        if (!first || !last || *first < 1 || *last < *first) {
          impossible(raw, line, fmt::format("'{}' is not a degree of freedom", field(raw, line, 1)));
          continue;
        }
        if (*last > 6)
          impossible(raw, line,
                     fmt::format("degree of freedom {} is not known; 1 to 6 and, for temperatures, 11 are", *last));
        for (auto k = *first; k <= std::min<std::int64_t>(*last, 6); ++k) directions.push_back(static_cast<int>(k));
      }
      if (raw.card.has("FIXED")) {
        for (const std::int64_t node : nodes) hold(raw, line, node, directions);
        continue;
      }
      for (const std::int64_t node : nodes)
        for (const int direction : directions)
          give(raw, line, {Condition::support, node, direction}, value(raw, line, 3), factors);
    }
  }

  /// Degree of freedom 11, in CalculiX also 0.
  static bool is_temperature(std::int64_t freedom) { return freedom == 11 || freedom == 0; }

  void given_temperature(const RawCard& raw, std::size_t line, const Numbers& nodes, const Amplitude* factors) {
    if (!conducts(raw)) return;
    if (raw.card.has("FIXED")) return impossible(raw, line, "FIXED: temperatures that stay as they are are not known");
    for (const std::int64_t node : nodes)
      give(raw, line, {Condition::given_temperature, node, 0}, value(raw, line, 3), factors);
  }

  /// Whether heat counts; else a line says that it does not.
  bool conducts(const RawCard& raw) {
    if (deck_.conducts()) return true;
    left_out_.push_back({raw.card.place, raw.card.name, "it does not act, for no step computes temperatures"});
    return false;
  }

  void heat(const RawCard& raw) {
    static const std::map<std::string, FaceFlow> flows{
        {"FILM", {'F', Condition::film_coefficient, Condition::fluid, "FILMAMPLITUDE"}},
        {"SFILM", {'F', Condition::film_coefficient, Condition::fluid, "FILMAMPLITUDE"}},
        {"RADIATE", {'R', Condition::emissivity, Condition::ambient, "RADIATIONAMPLITUDE"}},
        {"SRADIATE", {'R', Condition::emissivity, Condition::ambient, "RADIATIONAMPLITUDE"}},
        {"DFLUX", {'S', Condition::flux, Condition::flux, ""}},
        {"DSFLUX", {'S', Condition::flux, Condition::flux, ""}}};
    if (raw.card.name == "CFLUX" && conducts(raw)) point_flow(raw);
    const auto found = flows.find(raw.card.name);
    if (found == flows.end() || !conducts(raw)) return;
    const FaceFlow& flow = found->second;
    if (replaces(raw)) {
      drop(flow.factor);
      if (flow.factor == Condition::flux) drop(Condition::source);
    }
    const Amplitude* factors = amplitude(raw);
    const Amplitude* own = amplitude(raw, flow.own_amplitude);
    const bool is_on_surface = raw.card.name.front() == 'S' || raw.card.name == "DSFLUX";
    for (std::size_t line = 0; line < raw.data.size(); ++line) {
      const std::string label = upper_case(field(raw, line, 1));
      if (raw.card.name == "DFLUX" && label == "BF") {
        source(raw, line, factors);
        continue;
      }
      for (const ElementFace& face :
           is_on_surface ? on_surface(raw, line, label, flow.letter) : on_elements(raw, line, label, flow.letter)) {
        if (flow.factor == Condition::flux) {
          give(raw, line, {Condition::flux, face.element, face.face}, value(raw, line, 2), factors);
          continue;
        }
        give(raw, line, {flow.beyond, face.element, face.face}, value(raw, line, 2), factors);
        give(raw, line, {flow.factor, face.element, face.face}, value(raw, line, 3), own);
      }
    }
  }

  void point_flow(const RawCard& raw) {
    if (replaces(raw)) drop(Condition::point_flow);
    const Amplitude* factors = amplitude(raw);
    for (std::size_t line = 0; line < raw.data.size(); ++line) {
      const Numbers nodes = resolver_.nodes(field(raw, line, 0));
      if (nodes.empty()) impossible(raw, line, fmt::format("there is no node or set '{}'", field(raw, line, 0)));
      const auto freedom = field(raw, line, 1).empty() ? 11 : whole_number(field(raw, line, 1));
      if (!freedom || !is_temperature(*freedom))
        impossible(raw, line, fmt::format("'{}' is not the degree of freedom of heat: 11", field(raw, line, 1)));
      for (const std::int64_t node : nodes)
        give(raw, line, {Condition::point_flow, node, 0}, value(raw, line, 2), factors);
    }
  }

  void source(const RawCard& raw, std::size_t line, const Amplitude* factors) {
    const Numbers elements = elements_of(raw, line);
    auto& all = loading_.heat.sources;
    auto found = std::ranges::find_if(all, [&](const HeatLoading::Source& one) { return one.elements == elements; });
    if (found == all.end()) found = all.insert(found, {elements, {}});
    give(raw, line, {Condition::source, found - all.begin(), 0}, value(raw, line, 2), factors);
  }

  Numbers elements_of(const RawCard& raw, std::size_t line) {
    Numbers elements = field(raw, line, 0).empty() ? all_elements() : resolver_.elements(field(raw, line, 0));
    if (elements.empty()) impossible(raw, line, fmt::format("there is no element or set '{}'", field(raw, line, 0)));
    return elements;
  }

  /// Faces "F3" of elements.
  std::vector<ElementFace> on_elements(const RawCard& raw, std::size_t line, const std::string& label, char letter) {
    const auto number = label.size() == 2 && label[0] == letter ? whole_number(label.substr(1)) : std::nullopt;
    if (!number || *number < 1 || *number > 6) {
      impossible(raw, line, why_unknown(label, letter));
      return {};
    }
    std::vector<ElementFace> faces;
    for (const std::int64_t element : elements_of(raw, line)) {
      faces.push_back({element, static_cast<int>(*number)});
      if (face(element_cell(deck_, element), faces.back().face) != nullptr) continue;
      impossible(raw, line, fmt::format("element {} has no face {}", element, label));
      return {};
    }
    return faces;
  }

  static std::string why_unknown(const std::string& label, char letter) {
    if (label.ends_with("CR")) return "radiation between surfaces (CR) is not known, only to surroundings";
    if (label.ends_with("FC")) return "the temperature of a fluid that flows (FC) is not known; give it as a number";
    if (label.find("NU") != std::string::npos) return of_users;
    return fmt::format("'{}' is not known; faces {}1 to {}6 are{}", label, letter, letter,
                       letter == 'S' ? ", and BF" : "");
  }

  std::vector<ElementFace> on_surface(const RawCard& raw, std::size_t line, const std::string& label, char letter) {
    const auto surface = deck_.surfaces.find(upper_case(field(raw, line, 0)));
    if (surface == deck_.surfaces.end()) {
      impossible(raw, line, fmt::format("there is no surface '{}'", field(raw, line, 0)));
      return {};
    }
    if (label != std::string(1, letter)) {
      impossible(raw, line, fmt::format("'{}' is not known; {} is", label, letter));
      return {};
    }
    return faces_of(deck_, surface->second, impossible_);
  }

  /// FIXED: the displacement reached at the end of the step before.
  void hold(const RawCard& raw, std::size_t line, std::int64_t node, const std::vector<int>& directions) {
    const double time = loading_.step_ends.empty() ? 0.0 : loading_.step_ends.back();
    const auto by_length = entries_.find({Condition::support, node, 1});
    if (lockable_.contains(node) && by_length == entries_.end()) {
      const auto force = entries_.find({Condition::force, node, 1});
      const double reached = force != entries_.end() ? force->second.course.last() : 0.0;
      held_bolts_.insert(node);
      const auto known = loading_.locked.find(node);
      if (known != loading_.locked.end()) return;
      loading_.locked[node] = {begin_of_lock(raw, line, node, time), reached};
      if (force != entries_.end() && std::ranges::any_of(force->second.course.points(), [&](const auto& point) {
            return point.second != 0 && point.first < crept_until_;
          }))
        impossible(raw, line,
                   "the bolt is held after a step that takes time, in which its force acts; hold it from the first "
                   "*VISCO step after its tightening on");
      return;
    }
    if (time == 0)
      return impossible(raw, line, "FIXED after *STATIC steps that take no time, before the first *VISCO step");
    for (const int direction : directions) {
      const Key key{Condition::support, node, direction};
      const auto known = entries_.find(key);
      const bool is_held = known != entries_.end() && !known->second.is_dropped && !known->second.windows.back().until;
      const double reached = is_held ? known->second.course.last() : 0.0;
      if (known != entries_.end() && !is_held && !known->second.windows.back().until)
        known->second.windows.back().until = time;  // dropped in this step
      give(raw, line, key, reached, nullptr);
      if (is_held) continue;
      Entry& entry = entries_.at(key);
      entry.windows.back() = {time, std::nullopt, true};
      entry.course.add(time, entry.course.last());
      entry.course.add(time, 0);
    }
  }

  /// The bolt is tight from the begin of the *STATIC steps on that tighten it: later loads find it so.
  double begin_of_tension(std::int64_t node) const {
    double begin = crept_until_;
    if (const auto force = entries_.find({Condition::force, node, 1}); force != entries_.end())
      for (const auto& [time, value] : force->second.course.points())
        if (value == 0) begin = std::max(begin, time);
    return begin;
  }

  /// Loads that come while the force of the bolt acts do not change it: the lock begins after them.
  double begin_of_lock(const RawCard& raw, std::size_t line, std::int64_t node, double time) {
    constexpr double just_before = 1e-9;  // of the time: the end of the step shows the bolt tight
    const double begin = begin_of_tension(node);
    const bool others_come = std::ranges::any_of(entries_, [&](const auto& one) {
      const auto& [key, entry] = one;
      const bool is_bolt = key.kind == Condition::force && lockable_.contains(key.of);
      return !is_of_heat(key.kind) && !is_bolt && entry.course.at(begin) != entry.course.last();
    });
    if (begin >= time || !others_come) return begin;
    if (std::ranges::any_of(loading_.step_ends, [&](double end) { return end > begin && end < time; })) {
      if (!time_runs_)
        impossible(raw, line,
                   "other loads come between the tightening of the bolt and the step that holds it; hold it from the "
                   "step after its tightening on");
      left_out_.push_back({raw.card.place, raw.card.name,
                           fmt::format("until t = {:g}, while other loads come, the bolt is loose in the run", time)});
    }
    return time * (1 - just_before);
  }

  void concentrated(const RawCard& raw) {
    if (replaces(raw)) drop(Condition::force);
    const Amplitude* factors = amplitude(raw);
    for (std::size_t line = 0; line < raw.data.size(); ++line) {
      const Numbers nodes = resolver_.nodes(field(raw, line, 0));
      const auto direction = whole_number(field(raw, line, 1));
      if (nodes.empty()) impossible(raw, line, fmt::format("there is no node or set '{}'", field(raw, line, 0)));
      if (!direction || *direction < 1 || *direction > 6) {
        impossible(raw, line, fmt::format("'{}' is not a direction of a force", field(raw, line, 1)));
        continue;
      }
      for (const std::int64_t node : nodes)
        give(raw, line, {Condition::force, node, static_cast<int>(*direction)}, value(raw, line, 2), factors);
    }
  }

  void distributed(const RawCard& raw) {
    if (replaces(raw)) {
      drop(Condition::pressure);
      drop(Condition::body_load);
      drop(Condition::mass_force);
    }
    const Amplitude* factors = amplitude(raw);
    for (std::size_t line = 0; line < raw.data.size(); ++line) {
      Numbers elements = field(raw, line, 0).empty() ? all_elements() : resolver_.elements(field(raw, line, 0));
      const std::string label = upper_case(field(raw, line, 1));
      const bool acts_on_masses = label == "CENTRIF" || label == "GRAV";
      const bool has_masses = acts_on_masses && load_masses(raw, line, label == "GRAV", factors);
      if (elements.empty() && has_masses) continue;
      if (elements.empty()) {
        impossible(raw, line, fmt::format("there is no element or set '{}'", field(raw, line, 0)));
        continue;
      }
      const auto face = label.size() == 2 && label[0] == 'P' ? whole_number(label.substr(1)) : std::nullopt;
      if (face && *face >= 1 && *face <= 6) {
        for (const std::int64_t element : elements)
          give(raw, line, {Condition::pressure, element, static_cast<int>(*face)}, value(raw, line, 2), factors);
      } else if (acts_on_masses) {
        BodyLoad load{label == "GRAV" ? BodyLoad::Kind::gravity : BodyLoad::Kind::centrifugal, {}};
        for (std::size_t i = 3; i < (label == "GRAV" ? 6U : 9U); ++i) load.geometry.push_back(value(raw, line, i));
        auto found = std::ranges::find_if(
            loading_.bodies, [&](const Loading::Body& one) { return one.load == load && one.elements == elements; });
        if (found == loading_.bodies.end()) found = loading_.bodies.insert(found, {load, elements, {}});
        give(raw, line, {Condition::body_load, found - loading_.bodies.begin(), 0}, value(raw, line, 2), factors);
      } else {
        impossible(raw, line, fmt::format("loads of type {} are not known", label));
      }
    }
  }

  /// Forces on the masses of a set, or on all. @returns whether there are some
  bool load_masses(const RawCard& raw, std::size_t line, bool is_gravity, const Amplitude* factors) {
    const std::string target = field(raw, line, 0);
    const auto set = deck_.element_sets.find(upper_case(target));
    std::set<std::int64_t> wanted;
    if (set != deck_.element_sets.end()) wanted.insert(set->second.members.begin(), set->second.members.end());
    if (const auto own = whole_number(target)) wanted.insert(*own);
    bool has_some = false;
    for (const MassElement& mass : deck_.masses) {
      if (!target.empty() && !wanted.contains(mass.number)) continue;
      const auto found = mass_of_.find(mass.number);
      const std::uint32_t* const at = deck_.node_of_number.find_or_null(mass.node);
      if (found == mass_of_.end() || at == nullptr) continue;  // reported
      has_some = masses_act_ = true;
      const Vector3 first(value(raw, line, 3), value(raw, line, 4), value(raw, line, 5));
      Vector3 acceleration = first;
      if (!is_gravity) {
        const Vector3 axis(value(raw, line, 6), value(raw, line, 7), value(raw, line, 8));
        const Vector3 arm = deck_.positions[*at] - first;
        acceleration =
            axis.isZero(0) ? Vector3(Vector3::Zero()) : Vector3(arm - axis * (axis.dot(arm) / axis.squaredNorm()));
      }
      for (int k = 0; k < 3; ++k)
        if (acceleration[k] != 0)
          give(raw, line, {Condition::mass_force, mass.node, k + 1},
               value(raw, line, 2) * found->second * acceleration[k], factors);
    }
    return has_some;
  }

  void read_masses() {
    for (const RawCard& raw : deck_.cards) {
      if (raw.card.name != "MASS") continue;
      const auto set = deck_.element_sets.find(upper_case(raw.card.value("ELSET")));
      if (set == deck_.element_sets.end()) {
        impossible(raw, raw.places.size(), fmt::format("there is no set of elements '{}'", raw.card.value("ELSET")));
        continue;
      }
      const double mass = raw.data.empty() ? 0 : value(raw, 0, 0);
      for (const std::int64_t member : set->second.members) mass_of_[member] = mass;
    }
    for (const MassElement& mass : deck_.masses) {
      const auto refuse = [&](const std::string& why) { impossible_.push_back({mass.place, "ELEMENT", why}); };
      if (!mass_of_.contains(mass.number)) refuse(fmt::format("no *MASS gives the mass of element {}", mass.number));
      if (!deck_.node_of_number.contains(mass.node))
        refuse(fmt::format("element {}: there is no node {}", mass.number, mass.node));
    }
  }

  void tell_idle_masses() {
    if (!deck_.masses.empty() && !masses_act_)
      left_out_.push_back({deck_.masses.front().place, "MASS",
                           "masses do not act in static and creep steps without gravity (GRAV) or rotation (CENTRIF)"});
  }

  Numbers all_elements() const {
    Numbers all;
    for (const ElementBlock& block : deck_.elements) all.insert(all.end(), block.numbers.begin(), block.numbers.end());
    std::ranges::sort(all);
    return all;
  }

  void on_surfaces(const RawCard& raw) {
    if (replaces(raw)) drop(Condition::pressure);
    const Amplitude* factors = amplitude(raw);
    for (std::size_t line = 0; line < raw.data.size(); ++line) {
      const auto surface = deck_.surfaces.find(upper_case(field(raw, line, 0)));
      if (surface == deck_.surfaces.end()) {
        impossible(raw, line, fmt::format("there is no surface '{}'", field(raw, line, 0)));
        continue;
      }
      if (upper_case(field(raw, line, 1)) != "P") {
        impossible(raw, line, fmt::format("loads of type {} on surfaces are not known; P is", field(raw, line, 1)));
        continue;
      }
      for (const ElementFace& face : faces_of(deck_, surface->second, impossible_))
        give(raw, line, {Condition::pressure, face.element, face.face}, value(raw, line, 2), factors);
    }
  }

  void initial(const RawCard& raw) {
    const std::string type = letters_of(raw.card.value("TYPE"));
    if (type == "STRESS") return;  // of bodies, which are made later
    if (type != "TEMPERATURE") {
      static const std::set<std::string> of_motions{"VELOCITY",      "ROTATINGVELOCITY", "ACCELERATION",
                                                    "DISPLACEMENT",  "FLUIDVELOCITY",    "PRESSURE",
                                                    "TOTALPRESSURE", "MASSFLOW"};
      const bool acts_in_statics = !of_motions.contains(type);
      const bool is_strained = type.find("STRESS") != std::string::npos || type.find("STRAIN") != std::string::npos;
      (acts_in_statics ? impossible_ : left_out_)
          .push_back({raw.card.place, raw.card.name,
                      acts_in_statics
                          ? fmt::format("TYPE={}: {}", raw.card.value("TYPE"),
                                        is_strained ? "strains at the start are not known; stresses (TYPE=STRESS) are"
                                                    : "only temperatures and stresses at the start are known")
                          : fmt::format("TYPE={} does not act in static and creep steps", raw.card.value("TYPE"))});
      return;
    }
    for (std::size_t line = 0; line < raw.data.size(); ++line) {
      const Numbers nodes = resolver_.nodes(field(raw, line, 0));
      if (nodes.empty()) impossible(raw, line, fmt::format("there is no node or set '{}'", field(raw, line, 0)));
      if (raw.data[line].size() > 2) impossible(raw, line, "temperatures at several points of a shell are not known");
      for (const std::int64_t node : nodes) loading_.initial_temperatures[node] = value(raw, line, 1);
    }
  }

  double initial_temperature(std::int64_t node) const {
    const auto found = loading_.initial_temperatures.find(node);
    return found == loading_.initial_temperatures.end() ? loading_.initial_temperature : found->second;
  }

  /// One temperature of all nodes, if it is one.
  void simplify_initial_temperatures() {
    auto& own = loading_.initial_temperatures;
    if (own.empty()) return;
    const double first = own.begin()->second;
    const bool same = std::ranges::all_of(own, [&](const auto& one) { return one.second == first; }) &&
                      std::ranges::all_of(deck_.elements, [&](const ElementBlock& block) {
                        return std::ranges::all_of(block.nodes, [&](std::int64_t node) { return own.contains(node); });
                      });
    if (!same) return;
    loading_.initial_temperature = first;
    own.clear();
  }

  void temperature(const RawCard& raw) {
    if (deck_.conducts())
      return impossible(raw, raw.places.size(), "temperatures that are given next to computed ones");
    if (replaces(raw)) drop(Condition::temperature);
    const Amplitude* factors = amplitude(raw);
    for (std::size_t line = 0; line < raw.data.size(); ++line) {
      const Numbers nodes = resolver_.nodes(field(raw, line, 0));
      if (nodes.empty()) impossible(raw, line, fmt::format("there is no node or set '{}'", field(raw, line, 0)));
      for (const std::int64_t node : nodes)
        give(raw, line, {Condition::temperature, node, 0}, value(raw, line, 1), factors);
    }
  }

  /// Returns the value after a jump, which is two points at one time.
  static double factor(const Amplitude& amplitude, double time) {
    const auto& points = amplitude.points;
    if (time < points.front().first) return points.front().second;
    for (std::size_t i = 1; i < points.size(); ++i)
      if (time < points[i].first) {
        const double part = (time - points[i - 1].first) / (points[i].first - points[i - 1].first);
        return points[i - 1].second + part * (points[i].second - points[i - 1].second);
      }
    return points.back().second;
  }

  static double factor_before(const Amplitude& amplitude, double time) {
    const auto first = std::ranges::find_if(amplitude.points, [&](const auto& point) { return point.first == time; });
    return first != amplitude.points.end() ? first->second : factor(amplitude, time);
  }

  /// @param total  of the deck at the begin of the step
  void advance(Entry& entry, const Step& step, double time, double duration, double total) {
    const double old = entry.course.last(), end = time + duration;
    if (entry.is_dropped) {
      if (!entry.windows.empty() && !entry.windows.back().until) entry.windows.back().until = time;
      entry.amplitude = nullptr;
      entry.target = entry.rest;
      entry.is_new = true;
    }
    if (entry.amplitude != nullptr && (entry.is_new || entry.amplitude->total_time)) {
      const Amplitude& amplitude = *entry.amplitude;
      const double begin = amplitude.total_time ? total : 0;
      std::set<double> times{0, step.period};
      for (const auto& [point, unused] : amplitude.points)
        if (point > begin && point < begin + step.period) times.insert(point - begin);
      for (const double within : times) {
        const double at = time + within / step.period * duration;
        if (within > 0) entry.course.add(at, entry.target * factor_before(amplitude, begin + within));
        entry.course.add(at, entry.target * factor(amplitude, begin + within));
      }
    } else if (!entry.is_new) {
      entry.course.add(time, old);
      entry.course.add(end, old);
    } else if (step.ramps == "STEP" || (step.takes_time() && !step.is_steady && step.ramps != "RAMP")) {
      entry.course.add(time, old);
      entry.course.add(time, entry.target);
      entry.course.add(end, entry.target);
    } else {
      entry.course.add(time, old);
      entry.course.add(end, entry.target);
    }
    entry.is_new = false;
  }

  /// A steady state has the values of the end of its step throughout.
  void reach_at_once(Entry& entry, const Step& step, double time, double duration, double total) {
    Entry reached = entry;
    advance(reached, step, time, duration, total);
    const double value = reached.course.last();
    reached.course = entry.course;
    reached.course.add(time, entry.course.last());
    reached.course.add(time, value);
    reached.course.add(time + duration, value);
    entry = std::move(reached);
  }

  void store(const Key& key, Entry& entry) {
    const ElementFace face{key.of, key.part};
    switch (key.kind) {
      case Condition::given_temperature:
        store_temperature(key.of, entry);
        break;
      case Condition::film_coefficient:
        if (!entry.course.is_zero()) loading_.heat.films[face].factor = entry.course;
        break;
      case Condition::emissivity:
        if (!entry.course.is_zero()) loading_.heat.radiation[face].factor = entry.course;
        break;
      case Condition::fluid:  // after the coefficients
        if (const auto film = loading_.heat.films.find(face); film != loading_.heat.films.end())
          film->second.beyond = entry.course;
        break;
      case Condition::ambient:
        if (const auto found = loading_.heat.radiation.find(face); found != loading_.heat.radiation.end())
          found->second.beyond = entry.course;
        break;
      case Condition::flux:
        if (!entry.course.is_zero()) loading_.heat.fluxes[face] = entry.course;
        break;
      case Condition::source:
        loading_.heat.sources[static_cast<std::size_t>(key.of)].course = entry.course;
        break;
      case Condition::point_flow:
        if (!entry.course.is_zero()) loading_.heat.point_flows[key.of] = entry.course;
        break;
      case Condition::support:
        if (entry.windows.size() != 1 || entry.windows.front() != Window{}) {
          std::erase_if(entry.windows,
                        [](const Window& window) { return window.until && *window.until <= window.from.value_or(0); });
          if (entry.windows.empty()) return;
          loading_.windows[{key.of, key.part}] = entry.windows;
        }
        loading_.supports[key.of][key.part] = entry.course;
        break;
      case Condition::force:
        if (!entry.course.is_zero()) loading_.forces[key.of][key.part] = entry.course;
        break;
      case Condition::mass_force:  // after the forces
        if (!entry.course.is_zero()) {
          const auto [found, is_new] = loading_.forces[key.of].try_emplace(key.part, entry.course);
          if (!is_new) found->second = found->second.plus(entry.course);
        }
        break;
      case Condition::temperature:
        loading_.temperatures[key.of] = entry.course;
        if (!loading_.initial_temperatures.empty()) {
          Course difference;
          difference.add(0, -initial_temperature(key.of));
          loading_.temperatures[key.of] = entry.course.plus(difference);
        }
        break;
      case Condition::pressure:
        if (!entry.course.is_zero()) loading_.pressures[{key.of, key.part}] = entry.course;
        break;
      case Condition::body_load:
        loading_.bodies[static_cast<std::size_t>(key.of)].course = entry.course;
    }
  }

  /// A node that is given a temperature keeps it to the end, for [heat] knows no other.
  void store_temperature(std::int64_t node, Entry& entry) {
    std::erase_if(entry.windows,
                  [](const Window& window) { return window.until && *window.until <= window.from.value_or(0); });
    if (entry.windows.empty()) return;
    const Window& window = entry.windows.front();
    // Before a transient every node has the temperature of the start, given or not; a steady state would be another
    // one.
    const double first = std::ranges::any_of(deck_.steps, &Step::is_steady)
                             ? 0.0
                             : static_cast<double>(deck_.steps.size()) * loading_.heat.time_of_states;
    if (entry.windows.size() > 1 || window.from.value_or(0) > first || window.until) {
      impossible_.push_back({deck_.steps.back().place, "BOUNDARY",
                             fmt::format("node {} has a given temperature in some steps only; a *FILM with a large "
                                         "coefficient, whose FILM AMPLITUDE ends it, does nearly the same",
                                         node)});
      return;
    }
    loading_.heat.temperatures[node] = entry.course;
  }

  const Deck& deck_;
  Resolver resolver_;
  const std::set<std::int64_t>& lockable_;
  std::vector<Note>&impossible_, &left_out_;
  std::map<Key, Entry> entries_;
  Loading loading_;
  bool time_runs_ = false, warned_of_geometry_ = false, noted_static_time_ = false;
  std::map<std::int64_t, double> mass_of_;  // by the number of its element
  bool masses_act_ = false;
  bool has_conducted_ = false, warms_up_ = false;  // in the steps so far
  double static_time_ = 0;                         // that a *STATIC step takes next to *VISCO steps
  double crept_until_ = 0;                         // end of the last step that takes time
  const RawCard* frees_bolts_ = nullptr;           // OP=NEW in the present step
  std::set<std::int64_t> held_bolts_;              // in the present step
};

}  // namespace

Loading join_steps(const Deck& deck, const std::set<std::int64_t>& lockable, std::vector<Note>& impossible,
                   std::vector<Note>& left_out) {
  return Joiner(deck, lockable, impossible, left_out).join();
}

}  // namespace creepcontact::deck
