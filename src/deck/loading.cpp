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

/// A load or support of one node, face or group of elements, with what acts on it at present.
struct Entry {
  Course course;
  double rest = 0;    // value before anything was given
  double target = 0;  // value without amplitude, at the end of the present step
  const Amplitude* amplitude = nullptr;
  bool is_new = false;      // given in the present step
  bool is_dropped = false;  // by OP=NEW
  // Supports: times between which they act. Free at present: the last one has an end, or there is none.
  std::vector<Window> windows = {};
};

enum class Condition { support, force, body_load, pressure, temperature };

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
    creeps_ = std::ranges::any_of(deck.steps, [](const Step& step) { return step.is_creep; });
    if (creeps_) static_time_ = time_of_static_step(deck);
  }

  Loading join() {
    for (const RawCard& raw : deck_.cards) {
      if (raw.card.name == "BOUNDARY") boundary(raw);
      if (raw.card.name == "INITIAL CONDITIONS") initial(raw);
    }
    simplify_initial_temperatures();
    for (auto& [key, entry] : entries_) entry.is_new = false;
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
      }
      if (frees_bolts_ != nullptr && held_bolts_.size() < loading_.locked.size())
        impossible(*frees_bolts_, frees_bolts_->places.size(),
                   "OP=NEW frees a bolt whose length was held; FIXED holds it again");
      const double duration = creeps_ && !step.is_creep ? static_time_ : step.period;
      if (static_time_ > 0 && !step.is_creep) note_static_time(step);
      for (auto& [key, entry] : entries_) advance(entry, step, time, duration, total);
      time += duration;
      total += step.period;
      loading_.step_ends.push_back(time);
      if (step.is_creep) crept_until_ = time;
    }
    loading_.end = time;
    for (auto& [key, entry] : entries_) store(key, entry);
    std::erase_if(loading_.bodies, [](const Loading::Body& body) { return body.course.is_zero(); });
    return std::move(loading_);
  }

 private:
  void note_static_time(const Step& step) {
    if (std::exchange(noted_static_time_, true)) return;
    left_out_.push_back({step.place, "STATIC",
                         fmt::format("what yields or slides depends on the order of the loads, so each *STATIC step "
                                     "takes {:g} of time in the run, in which creep is negligible",
                                     static_time_)});
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
  const Amplitude* amplitude(const RawCard& raw) {
    const std::string name = raw.card.value("AMPLITUDE");
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
    // Loads that one step gives twice add up; supports and temperatures are replaced, as are those of earlier steps.
    if (entry.is_new &&
        (key.kind == Condition::force || key.kind == Condition::pressure || key.kind == Condition::body_load)) {
      if (entry.amplitude != amplitude)
        return impossible(raw, line, "two loads of one step at one place with different amplitudes; join these to one");
      target += entry.target;
    }
    if (is_first && key.kind == Condition::temperature) entry.rest = initial_temperature(key.of);
    if (is_first) entry.course.add(0, entry.rest);
    if (is_first && !loading_.step_ends.empty()) entry.course.add(loading_.step_ends.back(), entry.rest);
    if (key.kind == Condition::support && (is_first || entry.windows.back().until)) {
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
        if (!first || !last || *first < 1 || *last < *first) {
          impossible(raw, line, fmt::format("'{}' is not a degree of freedom", field(raw, line, 1)));
          continue;
        }
        if (*last > 6) impossible(raw, line, fmt::format("degree of freedom {} is not known", *last));
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

  /// FIXED: the displacement reached at the end of the step before.
  void hold(const RawCard& raw, std::size_t line, std::int64_t node, const std::vector<int>& directions) {
    const double time = loading_.step_ends.empty() ? 0.0 : loading_.step_ends.back();
    const auto by_length = entries_.find({Condition::support, node, 1});
    if (lockable_.contains(node) && by_length == entries_.end()) {
      const auto force = entries_.find({Condition::force, node, 1});
      const double reached = force != entries_.end() ? force->second.course.last() : 0.0;
      loading_.locked.try_emplace(node, Loading::Lock{static_time_ > 0 ? begin_of_tension(node) : time, reached});
      held_bolts_.insert(node);
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

  /// The bolt is tight from the begin of the *STATIC step on that tightens it: later loads find it so.
  double begin_of_tension(std::int64_t node) const {
    double begin = crept_until_;
    if (const auto force = entries_.find({Condition::force, node, 1}); force != entries_.end())
      for (const auto& [time, value] : force->second.course.points())
        if (value == 0) begin = std::max(begin, time);
    return begin;
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
    }
    const Amplitude* factors = amplitude(raw);
    for (std::size_t line = 0; line < raw.data.size(); ++line) {
      const Numbers elements = field(raw, line, 0).empty() ? all_elements() : resolver_.elements(field(raw, line, 0));
      if (elements.empty()) {
        impossible(raw, line, fmt::format("there is no element or set '{}'", field(raw, line, 0)));
        continue;
      }
      const std::string label = upper_case(field(raw, line, 1));
      const auto face = label.size() == 2 && label[0] == 'P' ? whole_number(label.substr(1)) : std::nullopt;
      if (face && *face >= 1 && *face <= 6) {
        for (const std::int64_t element : elements)
          give(raw, line, {Condition::pressure, element, static_cast<int>(*face)}, value(raw, line, 2), factors);
      } else if (label == "CENTRIF" || label == "GRAV") {
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
    if (const std::string type = letters_of(raw.card.value("TYPE")); type != "TEMPERATURE") {
      static const std::set<std::string> of_motions{"VELOCITY",      "ROTATINGVELOCITY", "ACCELERATION",
                                                    "DISPLACEMENT",  "FLUIDVELOCITY",    "PRESSURE",
                                                    "TOTALPRESSURE", "MASSFLOW"};
      const bool acts_in_statics = !of_motions.contains(type);
      const bool is_strained = type.find("STRESS") != std::string::npos || type.find("STRAIN") != std::string::npos;
      (acts_in_statics ? impossible_ : left_out_)
          .push_back({raw.card.place, raw.card.name,
                      acts_in_statics
                          ? fmt::format("TYPE={}: {}", raw.card.value("TYPE"),
                                        is_strained ? "a body with stresses or strains at the start is not known"
                                                    : "only temperatures at the start are known")
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
    } else if (step.ramps == "STEP" || (step.is_creep && step.ramps != "RAMP")) {
      entry.course.add(time, old);
      entry.course.add(time, entry.target);
      entry.course.add(end, entry.target);
    } else {
      entry.course.add(time, old);
      entry.course.add(end, entry.target);
    }
    entry.is_new = false;
  }

  void store(const Key& key, Entry& entry) {
    switch (key.kind) {
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

  const Deck& deck_;
  Resolver resolver_;
  const std::set<std::int64_t>& lockable_;
  std::vector<Note>&impossible_, &left_out_;
  std::map<Key, Entry> entries_;
  Loading loading_;
  bool creeps_ = false, warned_of_geometry_ = false, noted_static_time_ = false;
  double static_time_ = 0;                // that a *STATIC step takes next to *VISCO steps
  double crept_until_ = 0;                // end of the last *VISCO step
  const RawCard* frees_bolts_ = nullptr;  // OP=NEW in the present step
  std::set<std::int64_t> held_bolts_;     // in the present step
};

}  // namespace

Loading join_steps(const Deck& deck, const std::set<std::int64_t>& lockable, std::vector<Note>& impossible,
                   std::vector<Note>& left_out) {
  return Joiner(deck, lockable, impossible, left_out).join();
}

}  // namespace creepcontact::deck
