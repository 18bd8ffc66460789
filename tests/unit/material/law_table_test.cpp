// Constants of a law and the rows of its table.
#include "../../../src/material/law_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../../../src/material/arrhenius.hpp"
#include "unit/material/with_defaults.hpp"

namespace creepcontact::material {
namespace {

enum TwoConstants { speed, exponent, n_constants };

template <auto... constants>
concept HasTable = requires(Row<constants>... rows) {
  law_table(rows...);
};
template <class Info>
concept NeedsNoDimension = requires {
  Info{.key = "A", .description = "a constant"};
};

static_assert(HasTable<speed, exponent>);
static_assert(!HasTable<exponent, speed>, "an order that is not that of the enumeration");
static_assert(!HasTable<speed>, "a constant without a row");
static_assert(!HasTable<speed, speed>, "a constant with two rows");
static_assert(!NeedsNoDimension<ParameterInfo>, "a constant without a dimension");

TEST(LawTable, RefusesValuesOfAnotherNumber) {
  const LawInfo* norton = find_creep_law("norton");
  EXPECT_THROW(norton->make({{1e-13}, {5.0}}), std::out_of_range);
}

TEST(LawTable, ValuesByKeyNeedNoOrder) {
  const LawInfo* norton = find_creep_law("norton");
  const auto law = norton->make_by_key({{"n", {5.0}}, {"A", {1e-13}}});
  ASSERT_EQ(law->n_parameters(), 2);
  EXPECT_EQ(law->parameters()[0]({}), 1e-13);
  EXPECT_EQ(law->parameters()[1]({}), 5.0);
  const auto key_at_fault = [&](const std::map<std::string, std::vector<Function>>& given) -> std::string {
    try {
      norton->make_by_key(given);
    } catch (const ParameterError& error) {
      return error.key();
    }
    return "";
  };
  EXPECT_EQ(key_at_fault({{"A", {1e-13}}}), "n");
  EXPECT_EQ(key_at_fault({{"A", {1e-13}}, {"n", {5.0}}, {"m", {0.5}}}), "m");
}

TEST(LawTable, EnergiesFollowFromTheRows) {
  const LawInfo& law = *find_creep_law("kachanov_rabotnov");
  std::vector<std::string> energies, activated;
  for (std::size_t i = 0; i < law.parameters.size(); ++i) {
    if (law.is_activation_energy(i)) energies.push_back(law.parameters[i].key);
    if (law.parameters[i].energy)
      activated.push_back(law.parameters[i].key + " by " + law.parameters[*law.parameters[i].energy].key);
  }
  EXPECT_EQ(energies, (std::vector<std::string>{"damage_activation_energy", "activation_energy"}));
  EXPECT_EQ(activated, (std::vector<std::string>{"A by activation_energy", "B by damage_activation_energy"}));
}

TEST(LawTable, ADimensionMayDependOnAnotherConstant) {
  const LawInfo& law = *find_creep_law("chaboche");
  const UnitChange change{.stress = 2.0, .time = 9.0};
  const auto resistance = [&](double sinh_rate) {
    return factor(law.parameters[0].dimension, change, [&](std::size_t place) {
      return law.parameters[place].key == "n" ? 2.0 : law.parameters[place].key == "sinh_rate" ? sinh_rate : NAN;
    });
  };
  EXPECT_DOUBLE_EQ(resistance(0.0), 2.0 * 3.0);
  EXPECT_DOUBLE_EQ(resistance(1e-5), 2.0);
}

// In every law an activation energy changes what its rows say, and nothing else.
TEST(LawTable, OnlyActivatedConstantsDependOnTheEnergy) {
  for (const LawInfo& law : creep_laws()) {
    ParameterValues values;
    for (const ParameterInfo& row : law.parameters) values.push_back(row.fallback.value_or(std::vector<Function>{0.5}));
    for (std::size_t energy = 0; energy < law.parameters.size(); ++energy) {
      if (!law.is_activation_energy(energy)) continue;
      ParameterValues with = values;
      with[energy] = {1e5};
      const ParameterValues result = activated(with, law.parameters);
      const double factor = activation_factor({{1e5}, {8.314462618}, {-273.15}}, 0)({.T = 500.0});
      for (std::size_t i = 0; i < result.size(); ++i) {
        const ParameterInfo& row = law.parameters[i];
        const bool acts = row.energy == energy;
        const double expected = !acts                                ? 1
                                : row.activation == Activation::rate ? factor
                                : row.activation == Activation::time ? 1 / factor
                                                                     : 1;
        for (std::size_t k = 0; k < result[i].size(); ++k) {
          const double before = with[i][k]({.T = 500.0, .q = 1.0});
          EXPECT_NEAR(result[i][k]({.T = 500.0, .q = 1.0}), expected * before, 1e-14 * std::abs(expected * before))
              << law.name << ' ' << row.key;
        }
      }
    }
  }
}

}  // namespace
}  // namespace creepcontact::material
