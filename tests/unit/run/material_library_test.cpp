// The data of the material library as the program has them: values printed in the sources, and other units.
#include "creepcontact/config/material_library.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "creepcontact/base/error.hpp"
#include "creepcontact/config/reader.hpp"
#include "creepcontact/config/writer.hpp"
#include "creepcontact/material/bar.hpp"
#include "creepcontact/material/registry.hpp"
#include "creepcontact/model/materials.hpp"
#include "creepcontact/run/material_view.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "support/says.hpp"

namespace creepcontact::run {
namespace {

using config::LibraryCheck;
using config::LibraryMaterial;
using config::LibraryVariant;

constexpr const char* library_units = "mm, N, MPa, h, degC";

const std::vector<LibraryMaterial>& library() {
  static const std::vector<LibraryMaterial> all = config::material_library(vocabulary().materials);
  return all;
}

constexpr const char* model_of_steel = R"(
mesh.file = "none.msh"
bodies.bar = { region = "bar", material = "steel" }
time = { end = 1, cycle = 1 }
temperature.value = 500
materials.steel = { young_modulus = 1, poisson_ratio = 0.3, reference_temperature = 0 }
)";

/// Why the program cannot have this variant; empty: it can.
std::string unknown_law(const LibraryVariant& variant) {
  for (const std::string& law : variant.laws)
    if (material::find_creep_law(law) == nullptr) return law;
  return "";
}

/// Uniaxial behaviour of a variant.
class Bar {
 public:
  Bar(const LibraryMaterial& steel, const LibraryVariant& variant, const std::string& units = library_units)
      : data_(config::library_material(steel, variant.name, units, vocabulary())), made_(model::make_material(data_)) {
    if (data_.rupture) rupture_ = model::rupture_data(*data_.rupture);
    std::erase_if(made_.creep, [](const auto& law) { return !law->strains(); });
  }

  const config::Material& data() const { return data_; }
  const material::Material& made() const { return made_; }

  double strain(double stress, double T, double time) const { return state(stress, T, time).creep_strain; }
  double relaxed(double stress, double T, double time, double young_modulus) const {
    return state(stress, T, time, young_modulus).stress;
  }
  double first_rate(double stress, double T) const {
    return material::initial_rate(made_.creep, {.stress = stress, .temperature = T});
  }
  double rate_at(double stress, double T, double time) const {
    constexpr double part = 1e-3;
    return (strain(stress, T, time * (1 + part)) - strain(stress, T, time * (1 - part))) / (2 * part * time);
  }

  /// Rates of all laws of strain and internal variables, at a state where none of these is 0.
  std::vector<double> rates(double stress, double T, double time) const {
    std::vector<double> all;
    for (const auto& law : made_.creep) {
      const Course at(*law, T);
      std::vector<double> state(at.size(), 1e-3);
      for (const double rate : at.rates(state, stress, time)) all.push_back(rate);
    }
    return all;
  }

  double rupture_time(double stress, double T) const {
    if (rupture_) return 1 / rupture_->rate(stress, T).value;
    return 1 / initial(material::remaining_life, stress, T);
  }
  double rupture_strength(double time, double T) const {
    double low = 1e-3, high = 1e6;
    for (int i = 0; i < 100; ++i) {
      const double middle = std::sqrt(low * high);
      (rupture_time(middle, T) > time ? low : high) = middle;
    }
    return low;
  }
  double cycles(double strain_range, double T) const {
    return (*data_.fatigue.value().cycles_to_failure)({.T = T, .eps = strain_range});
  }

  /// A variable of the only law after a stress that grows in a ramp; the strain of an empty name.
  double after_ramp(const std::string& variable, double stress, double ramp, double T, double time) const {
    const Course course(*made_.creep.at(0), T);
    const std::vector<double> state = course.after(stress, ramp, time);
    return variable.empty() ? state[0] : course.variable(variable, state, stress, time);
  }

 private:
  /// A law at constant temperature; the state is the creep strain along the bar, then the internal variables. Only for
  /// laws whose internal variables are scalars.
  class Course {
   public:
    Course(const material::CreepLaw& law, double T) : law_(law), temperature_(T) {
      for (const Function& parameter : law.parameters()) parameters_.push_back(parameter({.T = T}));
    }
    std::size_t size() const { return 1 + static_cast<std::size_t>(law_.n_internal()); }

    std::vector<double> rates(const std::vector<double>& state, double stress, double time) const {
      const Tensor6 tension = stress * Tensor6::Unit(0);
      const Tensor6 strain = state[0] * (1.5 * Tensor6::Unit(0) - 0.5 * tensor::identity());
      std::vector<double> result(size());
      Tensor6 rate = Tensor6::Zero();
      law_.rate(point(tension, strain, state, time), {tensor::writable(rate), std::span(result).subspan(1)});
      result[0] = rate[0];
      return result;
    }

    double variable(const std::string& name, const std::vector<double>& state, double stress, double time) const {
      const Tensor6 tension = stress * Tensor6::Unit(0);
      const Tensor6 strain = state[0] * (1.5 * Tensor6::Unit(0) - 0.5 * tensor::identity());
      double value = NAN;
      for (const material::StateVariable* one : material::state_variables())
        if (one->name == name) law_.evaluate(*one, point(tension, strain, state, time), {&value, 1});
      return value;
    }

    /// Heun's method with steps of relative error 1e-9.
    std::vector<double> after(double stress, double ramp, double end) const {
      std::vector<double> state(size());
      const auto at = [&](double time) { return ramp > 0 ? stress * std::min(time / ramp, 1.0) : stress; };
      double time = 0, step = 1e-6 * end;
      while (time < end) {
        const double target = ramp > time ? std::min(ramp, end) : end;
        const double h = std::min(step, target - time);
        const std::vector<double> first = rates(state, at(time), time);
        std::vector<double> trial = state;
        for (std::size_t i = 0; i < trial.size(); ++i) trial[i] += h * first[i];
        const std::vector<double> second = rates(trial, at(time + h), time + h);
        double error = 0;
        for (std::size_t i = 0; i < trial.size(); ++i) {
          const double change = 0.5 * h * (second[i] - first[i]);
          trial[i] += change;
          error = std::max(error, std::abs(change) / (1e-9 + 1e-6 * std::abs(trial[i])));
        }
        if (error <= 1) {
          state = trial;
          time = h == target - time ? target : time + h;
        }
        step = h * std::clamp(0.9 / std::sqrt(error + 1e-12), 0.2, 3.0);
      }
      return state;
    }

   private:
    material::PointState point(const Tensor6& stress, const Tensor6& strain, const std::vector<double>& state,
                               double time) const {
      return {.stress = tensor::view(stress),
              .creep_strain = tensor::view(strain),
              .internal = std::span(state).subspan(1),
              .parameters = parameters_,
              .time = time,
              .temperature = temperature_};
    }
    const material::CreepLaw& law_;
    double temperature_;
    std::vector<double> parameters_;
  };

  material::BarState state(double stress, double T, double time,
                           double young_modulus = std::numeric_limits<double>::infinity()) const {
    const std::vector<double> times{1e-4 * time, time};  // from the first one follows how early the steps begin
    const material::BarHistory history = material::bar_history(
        made_.creep, {.stress = stress, .temperature = T, .young_modulus = young_modulus}, times, 1e-9);
    EXPECT_FALSE(history.failed);
    return history.states.size() < times.size() ? history.last : history.states.back();
  }

  double initial(const material::StateVariable& variable, double stress, double T) const {
    double value = NAN;
    for (const auto& law : made_.creep) {
      const Course course(*law, T);
      const double found = course.variable(variable.name, std::vector<double>(course.size()), stress, 0);
      if (std::isfinite(found)) value = found;
    }
    return value;
  }

  config::Material data_;
  material::Material made_;
  std::shared_ptr<const material::RuptureData> rupture_;
};

/// The value that the program has for a check; nullopt: no law shows this quantity.
std::optional<double> recomputed(const Bar& bar, const LibraryCheck& check) {
  const double T = check.T;
  const auto given = [](const std::optional<double>& value) { return value.value_or(NAN); };
  const double stress = given(check.stress), time = given(check.time);
  if (check.branch != 0) return std::nullopt;
  if (check.quantity == "rate") return bar.first_rate(stress, T);
  if (check.quantity == "rupture_time") return bar.rupture_time(stress, T);
  if (check.quantity == "rupture_strength") return bar.rupture_strength(time, T);
  if (check.quantity == "cycles_to_failure") return bar.cycles(given(check.strain_range), T);
  if (check.quantity == "rate_at_time") return bar.rate_at(stress, T, time);
  if (check.quantity == "minimum_rate") return bar.rate_at(stress, T, 1e7);
  if (check.quantity == "strain" && !check.ramp) return bar.strain(stress, T, time);
  if (check.quantity == "strain") return bar.after_ramp("", stress, *check.ramp, T, time);
  if (check.quantity == "damage_time") return 1 / bar.after_ramp("damage", stress, 0, T, 1);
  const double found = bar.after_ramp(check.quantity, stress, check.ramp.value_or(0), T, time);
  return std::isfinite(found) ? std::optional(found) : std::nullopt;
}

class MaterialLibrary : public testing::TestWithParam<std::string> {
 protected:
  const LibraryMaterial& steel() const { return *std::ranges::find(library(), GetParam(), &LibraryMaterial::key); }

  /// Calls with each variant whose laws the program has, and names the others.
  template <class Call>
  void for_each_variant(const Call& call) const {
    for (const LibraryVariant& variant : steel().variants) {
      SCOPED_TRACE(steel().key + '/' + variant.name);
      if (const std::string law = unknown_law(variant); !law.empty())
        std::cout << fmt::format("left out: {}/{}, whose law {} the program does not have\n", steel().key, variant.name,
                                 law);
      else
        call(variant);
    }
  }
};

TEST_P(MaterialLibrary, ChecksOfEveryVariantAreRecomputed) {
  for_each_variant([&](const LibraryVariant& variant) {
    const Bar bar(steel(), variant);
    for (const LibraryCheck& check : variant.checks) {
      const std::string name = fmt::format("{} at {} degC, {} MPa, {} h", check.quantity, check.T,
                                           check.stress.value_or(0), check.time.value_or(0));
      const std::optional<double> found = recomputed(bar, check);
      if (!found) {
        std::cout << fmt::format("left out: {} of {}/{}, which no law shows\n", name, steel().key, variant.name);
        continue;
      }
      const double ratio = *found / check.value;
      if (check.factor > 1)
        EXPECT_TRUE(ratio < check.factor && ratio > 1 / check.factor) << name << ": " << *found;
      else
        EXPECT_NEAR(ratio, 1, check.tolerance) << name << ": " << *found;
    }
  });
}

TEST_P(MaterialLibrary, DataAreTheSameInOtherUnits) {
  struct Other {
    const char* units;
    double stress, time, degree, zero;  // of mm, N, MPa, h, degC in these
  };
  const double psi = 1e6 / 6894.757293168361;
  for_each_variant([&](const LibraryVariant& variant) {
    const Bar bar(steel(), variant);
    const LibraryCheck& check = variant.checks.front();
    const double T = check.T, stress = check.stress.value_or(100), time = 1000;
    for (const Other& other : {Other{"m, Pa, s, K", 1e6, 3600, 1, 273.15}, Other{"m-N-Pa-min", 1e6, 60, 1, 0},
                               Other{"inch, psi, min, degF", psi, 60, 1.8, 32}}) {
      SCOPED_TRACE(other.units);
      const Bar there(steel(), variant, other.units);
      const double other_T = other.degree * T + other.zero;
      const auto same = [](double found, double expected, double tolerance) {
        EXPECT_TRUE(std::isfinite(expected));
        EXPECT_NEAR(found, expected, tolerance * std::abs(expected));
      };
      const auto& made = bar.made();
      if (steel().has("young_modulus"))
        same(there.made().young_modulus({.T = other_T}), other.stress * made.young_modulus({.T = T}), 1e-9);
      same(there.made().poisson_ratio({.T = other_T}), made.poisson_ratio({.T = T}), 1e-9);
      const auto thermal = [](const material::Material& of, double at) {
        return of.thermal_expansion.strains(at, of.reference_temperature)[0];
      };
      if (steel().has("thermal_expansion")) same(thermal(there.made(), other_T), thermal(made, T), 1e-9);
      if (variant.rupture)
        same(there.rupture_time(other.stress * stress, other_T), other.time * bar.rupture_time(stress, T), 1e-7);
      if (variant.fatigue) same(there.cycles(0.01, other_T), bar.cycles(0.01, T), 1e-9);
      if (variant.laws.empty()) continue;
      const std::vector<double> expected = bar.rates(stress, T, time),
                                found = there.rates(other.stress * stress, other_T, other.time * time);
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t i = 0; i < found.size(); ++i) same(other.time * found[i], expected[i], 1e-7);
      // A held bar.
      same(there.relaxed(other.stress * stress, other_T, other.time * time, other.stress * 1.6e5),
           other.stress * bar.relaxed(stress, T, time, 1.6e5), 1e-5);
      const auto range = [](const Bar& of) { return of.data().creep.front().temperature_range; };
      ASSERT_EQ(range(bar).has_value(), range(there).has_value());
      if (range(bar)) same(range(there)->low, other.degree * range(bar)->low + other.zero, 1e-9);
    }
  });
}

TEST_P(MaterialLibrary, MaterialsAreWrittenAsPlainTables) {
  for_each_variant([&](const LibraryVariant& variant) {
    const config::Material material = config::library_material(steel(), variant.name, "m, Pa, s, K", vocabulary());
    EXPECT_TRUE(material.use.empty());
    ASSERT_FALSE(material.sources.empty());
    EXPECT_TRUE(test::says(material.sources.back(), {steel().key + '/' + variant.name, "status: "}));
    config::Config config = config::parse(model_of_steel, "none.toml", vocabulary());
    config.materials = {material};
    const std::string text = config::to_toml(config, vocabulary());
    EXPECT_EQ(config::to_toml(config::parse(text, config.file, vocabulary()), vocabulary()), text);
  });
}

TEST(MaterialView, ShowsAllVariantsOfASteel) {
  const MaterialView view = material_view("P91", {.temperature = 600, .variant = ""});
  EXPECT_TRUE(test::says(view.text, {"Grade 91", "600 °C", "swindeman_1999", "en_10216_2", "one copy"}));
  ASSERT_EQ(view.figures.size(), 2u);
  const plot::Figure& over_time = view.figures[0].figure;
  ASSERT_EQ(over_time.panels.size(), 5u);
  // The first stress gives 1 % after 1000 h, but for the rounding to two digits.
  const plot::Series& first = over_time.panels[0].series[0];
  const auto after = std::ranges::find_if(first.x, [](double t) { return t > 999; });
  const double strain = first.y.at(after - first.x.begin());
  EXPECT_TRUE(strain > 0.005 && strain < 0.02) << strain;
  for (const plot::Series& series : over_time.panels[3].series)
    EXPECT_TRUE(std::ranges::is_sorted(series.y, std::greater()));
  for (const plot::Series& series : over_time.panels[4].series)
    EXPECT_TRUE(std::ranges::is_sorted(series.y, std::greater()));
  EXPECT_EQ(view.text.find(" 0.001 "), std::string::npos) << "a strength where a polynomial has no meaning";
  const MaterialView one = material_view("grade_91", {.temperature = {}, .variant = "en_10216_2"});
  ASSERT_EQ(one.figures.size(), 1u);
  EXPECT_EQ(one.figures[0].figure.panels.size(), 1u);
}

TEST(MaterialView, NamesWhatThereIs) {
  EXPECT_TRUE(
      test::says(test::message_of<ConfigError>([] { material_view("grade_19", {}); }), {"grade_19", "'grade_91'"}));
  EXPECT_TRUE(test::says(
      test::message_of<ConfigError>([] { material_view("grade_91", {.temperature = {}, .variant = "wrc"}); }),
      {"--law", "'wrc'", "wrc_541"}));
}

INSTANTIATE_TEST_SUITE_P(Steels, MaterialLibrary, testing::ValuesIn([] {
                           std::vector<std::string> keys;
                           for (const LibraryMaterial& steel : library()) keys.push_back(steel.key);
                           return keys;
                         }()),
                         [](const auto& of) { return "of_" + of.param; });

}  // namespace
}  // namespace creepcontact::run
