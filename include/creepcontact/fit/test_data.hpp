#pragma once
/// Measured data that a creep law is fitted to: creep curves, relaxation tests, times to rupture, creep rates.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/io/tables/thousands.hpp"

namespace creepcontact::fit {

enum class TestKind {
  creep,       ///< creep strain at several times, under constant stress
  relaxation,  ///< stress at several times, at constant length
  rupture,     ///< time to rupture under constant stress
  rate         ///< creep rate under constant stress, secondary or at a time
};
inline constexpr int n_test_kinds = 4;
/// "creep", ... as in the column `kind`.
const std::string& name_of(TestKind kind);
/// What a reading is: "strain", "stress", "time to rupture", "creep rate".
const std::string& value_of(TestKind kind);

struct Reading {
  /// After the start of the test; of a rupture: no meaning; of a rate: NaN for the secondary rate.
  double time = 0;
  double value = 0;  ///< as the kind of the test says, > 0
  int line = 0;      ///< in the file
};

/// Readings of one kind from one specimen.
struct Test {
  std::string name;  ///< from the column `test`, or its stress and temperature
  TestKind kind = TestKind::creep;
  double stress = 0;       ///< constant; of a relaxation test: at time 0
  double temperature = 0;  ///< 0 if the data have none
  /// Added to the value of a creep reading before logarithms are taken: a thousandth of the largest strain. Readings
  /// far below it count by their absolute error.
  double floor = 0;
  std::vector<Reading> readings = {};  ///< times increase
  std::size_t batch = 0;               ///< number in TestData::batches, if there are any
  bool young_modulus_used = false;     ///< the elastic strain was subtracted, or the stress relaxes
  bool is_named = false;               ///< by the column `test`
  bool same_specimen = false;          ///< as another test, such as the rupture after a creep curve
};

/// Units as in the header of the file; empty: none given.
struct TestUnits {
  std::string time, stress, temperature;
};

/// Range of the data; {0, 0} where they have none.
struct DataRange {
  Interval stress, temperature, time;
};

struct TestData {
  std::string file;
  TestUnits units;
  bool has_temperature = false;
  std::vector<Test> tests = {};
  /// Batches of the steel (melts) by name, from the column `batch`; empty: not known, or all of one batch.
  std::vector<std::string> batches = {};
  std::vector<std::string> notes = {};  ///< what was left out or assumed
  int n_readings() const;
  int n_specimens() const;
  /// "100 MPa, 600 degC"
  std::string load(double stress, double temperature) const;
  std::vector<double> stresses() const;      ///< distinct, increasing; those within 1 % count as one
  std::vector<double> temperatures() const;  ///< distinct, increasing; those within 2 degrees count as one
  DataRange range() const;
};

struct ReadOptions {
  /// Function of T, in the unit of the stress: the column `strain` is the total strain then.
  std::optional<Function> young_modulus = {};
  std::optional<double> temperature = {};         ///< tests within 2 degrees of it alone
  io::Thousands thousands = io::Thousands::none;  ///< what separates them in numbers
};

/// Format: docs/fit.md. @throws ConfigError with a line for each bad row: file, line, column, what was found and what
/// is allowed; rows with the same mistake share one line. Also for columns that are missing, for units that cannot be
/// what they should be, and for a Young's modulus with an elastic strain above 10 %
TestData read_test_data(const std::filesystem::path& path, const ReadOptions& options);
/// Reads test data from text. @param name  of the file, for messages
TestData parse_test_data(std::string_view text, const std::string& name, const ReadOptions& options);

}  // namespace creepcontact::fit
