#include "interactions.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "gasket_tables.hpp"

namespace creepcontact::deck {
namespace {

class InteractionReader {
 public:
  explicit InteractionReader(Draft& draft) : draft_(draft) {}

  Interactions read() {
    for (const RawCard& raw : draft_.deck.cards) read_interaction(raw, 0);
    for (std::size_t s = 0; s < draft_.deck.steps.size(); ++s) {
      own_ = nullptr;
      for (const RawCard& raw : draft_.deck.steps[s].cards)
        read_interaction(raw, s == 0 ? 0 : draft_.loading.step_ends[s - 1]);
    }
    return std::move(interactions_);
  }

 private:
  void read_interaction(const RawCard& raw, double time) {
    if (raw.card.name == "SURFACE INTERACTION") {
      const auto [made, is_new] = interactions_.try_emplace(upper_case(raw.card.value("NAME")));
      if (!is_new) draft_.refuse(raw, fmt::format("'{}' exists already", raw.card.value("NAME")));
      own_ = &made->second;
      own_->name = raw.card.value("NAME");
    }
    if (raw.card.name == "CHANGE FRICTION") {
      const auto found = interactions_.find(upper_case(raw.card.value("INTERACTION")));
      own_ = found == interactions_.end() ? nullptr : &found->second;
      if (own_ == nullptr)
        draft_.refuse(raw, fmt::format("there is no *SURFACE INTERACTION '{}'", raw.card.value("INTERACTION")));
    }
    const bool is_friction = raw.card.name == "FRICTION", is_of_heat = raw.card.name == "GAP CONDUCTANCE";
    if (!is_friction && !is_of_heat && raw.card.name != "SURFACE BEHAVIOR") return;
    if (own_ == nullptr)
      return draft_.refuse(raw, is_friction
                                    ? "it belongs below *SURFACE INTERACTION, or in a step below *CHANGE FRICTION"
                                    : "it belongs below *SURFACE INTERACTION");
    if (is_friction) return friction(raw, time);
    if (is_of_heat) return conductance(raw);
    const std::string kind = upper_case(raw.card.value("PRESSURE-OVERCLOSURE"));
    own_->tied = kind == "TIED";
    if (kind == "TABULAR") return curve(raw);
    if (kind != "HARD" && kind != "TIED")
      draft_.left_out.push_back({raw.card.place, raw.card.name,
                                 fmt::format("{}: contact is hard here, without penetration",
                                             kind.empty() ? "pressure over overclosure" : kind)});
  }

  /// Rows of the conductance, the pressure and the temperature, over one of the two.
  void conductance(const RawCard& raw) {
    if (!draft_.deck.conducts()) {
      draft_.left_out.push_back({raw.card.place, raw.card.name, "it does not act, for no step computes temperatures"});
      return;
    }
    std::vector<std::array<double, 3>> rows;
    for (const std::vector<std::string>& line : raw.data) {
      std::array<double, 3> row{};
      for (std::size_t i = 0; i < std::min<std::size_t>(line.size(), 3); ++i) {
        const auto given = line[i].empty() ? 0.0 : number(line[i]);
        if (!given) return draft_.refuse(raw, fmt::format("'{}' is not a number", line[i]));
        row[i] = *given;
      }
      if (line.size() > 3)
        return draft_.refuse(raw, "expected rows of the conductance, the contact pressure and the temperature");
      rows.push_back(row);
    }
    if (rows.empty()) return draft_.refuse(raw, "expected rows of the conductance, the pressure and the temperature");
    const auto varies = [&](std::size_t column) {
      return std::ranges::any_of(rows, [&](const auto& row) { return row[column] != rows.front()[column]; });
    };
    if (varies(1) && varies(2))
      return draft_.refuse(raw,
                           "a conductance that depends on the pressure and on the temperature; write it as an "
                           "expression of p and T, after an import with the rows of one temperature");
    if (varies(1) && !draft_.deck.deforms())
      return draft_.refuse(raw, "it depends on the contact pressure, and no step computes displacements");
    const std::size_t of = varies(1) ? 1 : 2;
    draft_.couples = draft_.couples || of == 1;
    std::vector<double> at, values;
    for (const auto& row : rows) {
      at.push_back(rounded(row[of]));
      values.push_back(rounded(row[0]));
    }
    if (!is_increasing(at))
      return draft_.refuse(raw,
                           fmt::format("the {} must increase from line to line", of == 1 ? "pressure" : "temperature"));
    own_->conductance = at.size() == 1 ? Function(values.front())
                                       : Function::table(of == 1 ? "p" : "T", std::move(at), std::move(values));
    if (of == 1 && !raw.card.has("PRESSURE"))
      draft_.left_out.push_back(
          {raw.card.place, raw.card.name,
           "the second column is the contact pressure, as in CalculiX; without PRESSURE it is the clearance in Abaqus: "
           "then write 'gap' for 'p' in the conductance"});
  }

  /// Rows of pressure and overclosure: a gasket that has no thickness of its own.
  void curve(const RawCard& raw) {
    config::GasketCurve curve;
    std::string temperature;
    for (const std::vector<std::string>& line : raw.data) {
      const auto pressure = line.empty() ? std::nullopt : number(line[0]);
      const auto overclosure = line.size() < 2 ? std::nullopt : number(line[1]);
      if (!pressure || !overclosure) return draft_.refuse(raw, "expected rows of a pressure and an overclosure");
      if (line.size() > 2 && !line[2].empty() && std::exchange(temperature, line[2]) != line[2] &&
          !curve.closure.empty())
        return draft_.refuse(raw,
                             "a curve that depends on the temperature; give one [gaskets.<name>] by hand, whose "
                             "'loading' takes several");
      curve.pressure.push_back(pressure.value_or(0));
      curve.closure.push_back(rounded(overclosure.value_or(0)));
    }
    if (curve.pressure.size() < 2 || curve.pressure.front() != 0 || !is_increasing(curve.pressure) ||
        !is_increasing(curve.closure))
      return draft_.refuse(raw, "expected at least two rows that increase, the first one with the pressure 0");
    own_->gasket = name_of_gasket(draft_, own_->name);
    config::Gasket made;
    made.name = own_->gasket;
    made.thickness = 1;
    made.loading = {std::move(curve)};
    draft_.config.gaskets.push_back(std::move(made));
    const std::string key = "gaskets." + own_->gasket;
    draft_.comment(key, raw.card.place.text() + ": *SURFACE BEHAVIOR");
    draft_.comment(key + ".thickness", "does not matter here: the curve is one of closures");
  }

  /// Rows of a coefficient and what it depends on; in CalculiX the stiffness of sticking, which is infinite here.
  void friction(const RawCard& raw, double time) {
    std::optional<double> coefficient;
    for (std::size_t line = 0; line < raw.data.size(); ++line) {
      const auto given = raw.data[line].empty() ? std::nullopt : number(raw.data[line][0]);
      if (!given)
        return draft_.refuse(raw, fmt::format("'{}' is not a number", raw.data[line].empty() ? "" : raw.data[line][0]));
      if (coefficient && *coefficient != *given)
        return draft_.refuse(raw,
                             "coefficients that depend on the slip, the pressure or the temperature are not known");
      coefficient = given;
    }
    if (time > 0) own_->friction.add(time, own_->friction.last());  // a jump
    own_->friction.add(time, coefficient.value_or(0));
  }

  Draft& draft_;
  Interactions interactions_;
  Interaction* own_ = nullptr;  // to which *FRICTION belongs
};

}  // namespace

Interactions read_interactions(Draft& draft) {
  return InteractionReader(draft).read();
}

}  // namespace creepcontact::deck
