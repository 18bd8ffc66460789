#include "creepcontact/fit/test_data.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "data_columns.hpp"
#include "data_rows.hpp"

namespace creepcontact::fit {
namespace {

constexpr double same_stress = 0.01;      // relative
constexpr double same_temperature = 2;    // degrees
constexpr double floor_of_strain = 1e-3;  // of the largest strain of a test
constexpr double no_time = std::numeric_limits<double>::quiet_NaN();

bool near_stress(double a, double b) {
  return std::abs(a - b) <= same_stress * std::max(a, b);
}
bool near_temperature(double a, double b) {
  return std::abs(a - b) <= same_temperature;
}

/// Tests put together from rows.
class TestCollector {
 public:
  TestCollector(TestData& data, const ReadOptions& options, RowMistakes& mistakes)
      : data_(data), options_(options), mistakes_(mistakes) {}

  void add(const DataRow& row) {
    if (row.rupture) add_rupture(row, *row.rupture);
    if (!row.kind) return;
    switch (*row.kind) {
      case TestKind::creep:
        return add_creep(row);
      case TestKind::relaxation:
        return add_relaxation(row);
      case TestKind::rupture:
        return add_rupture(row, *row.time);
      case TestKind::rate:
        add(started(row, TestKind::rate)).readings.push_back({row.time.value_or(no_time), *row.rate, row.line});
    }
  }

  void finish() {
    for (Test& test : data_.tests) {
      for (const Reading& reading : test.readings)
        if (test.kind == TestKind::creep) test.floor = std::max(test.floor, floor_of_strain * reading.value);
      std::erase_if(test.readings, [&](const Reading& reading) {
        const bool timed = test.kind == TestKind::creep || test.kind == TestKind::relaxation;
        if (timed && reading.time == 0) return true;
        if (reading.value > 0) return false;
        not_positive_.push_back(reading.line);
        return true;
      });
    }
    std::erase_if(data_.tests, [](const Test& test) { return test.readings.empty(); });
    keep_used_batches();
    if (!not_positive_.empty())
      data_.notes.push_back(
          fmt::format("{} readings that are zero or negative after the start are left out, in lines {}",
                      not_positive_.size(), fmt::join(not_positive_, ", ")));
  }

 private:
  std::string label(const DataRow& row) const {
    if (!row.test.empty()) return row.test;
    return data_.load(row.stress, row.temperature) + (row.batch.empty() ? "" : ", " + row.batch);
  }

  Test started(const DataRow& row, TestKind kind) {
    Test test{.name = label(row), .kind = kind, .stress = row.stress, .temperature = row.temperature};
    test.is_named = !row.test.empty();
    if (!row.batch.empty()) test.batch = batch_number(row.batch);
    test.same_specimen = test.is_named && specimens_.contains(row.test);
    if (row.test.empty() && (kind == TestKind::creep || kind == TestKind::relaxation))
      if (const int same = like_named_[index(kind)][test.name]; same > 0) test.name += fmt::format(" ({})", same + 1);
    return test;
  }

  /// Batches that have tests, if these are several.
  void keep_used_batches() {
    const std::vector<std::string> all = std::exchange(data_.batches, {});
    for (Test& test : data_.tests)
      if (!all.empty()) test.batch = batch_number(all[test.batch]);
    if (data_.batches.size() == 1) data_.batches.clear();
  }

  std::size_t batch_number(const std::string& name) {
    const auto found = std::ranges::find(data_.batches, name);
    if (found == data_.batches.end()) data_.batches.push_back(name);
    return static_cast<std::size_t>(std::ranges::find(data_.batches, name) - data_.batches.begin());
  }

  static std::size_t index(TestKind kind) { return static_cast<std::size_t>(kind); }

  /// Adds a test to the data, and to what finds it among many.
  Test& add(Test test) {
    if (!test.same_specimen) specimens_.insert(test.name);
    const std::size_t kind = index(test.kind);
    last_named_[kind][test.name] = data_.tests.size();
    ++like_named_[kind][test.name];
    for (std::size_t at = test.name.find(" ("); at != std::string::npos; at = test.name.find(" (", at + 1))
      ++like_named_[kind][test.name.substr(0, at)];
    return data_.tests.emplace_back(std::move(test));
  }

  /// The test that a row goes on with; nullptr: a new one begins.
  Test* continued(const DataRow& row, TestKind kind) {
    if (!row.test.empty()) {
      const auto found = last_named_[index(kind)].find(row.test);
      return found == last_named_[index(kind)].end() ? nullptr : &data_.tests[found->second];
    }
    for (auto test = data_.tests.rbegin(); test != data_.tests.rend(); ++test) {
      if (test->kind != kind || (!row.batch.empty() && data_.batches[test->batch] != row.batch)) continue;
      const bool same_load = kind == TestKind::relaxation ? test->readings.empty() || &*test == &data_.tests.back()
                                                          : near_stress(test->stress, row.stress);
      if (!same_load || !near_temperature(test->temperature, row.temperature)) continue;
      if (*row.time >= test->readings.back().time && test->readings.back().time > test->readings.front().time)
        return &*test;
      if (*row.time > test->readings.back().time) return &*test;
      if (*row.time <= test->readings.front().time) return nullptr;
      return &*test;  // the time goes back, but not to its start: a mistake
    }
    return nullptr;
  }

  double elastic_strain(const DataRow& row) const {
    return row.stress / (*options_.young_modulus)({.T = row.temperature});
  }

  bool require_order(const DataRow& row, const Test& test) {
    const Reading& before = test.readings.back();
    if (*row.time >= before.time) return true;
    mistakes_.add(row.line,
                  fmt::format("time {:g} after {:g} in line {}, in the test '{}'; allowed: times that increase "
                              "(tests at one stress and temperature need names in a column 'test')",
                              *row.time, before.time, before.line, test.name));
    return false;
  }

  void add_creep(const DataRow& row) {
    double strain = *row.strain;
    if (row.strain_is_total) {
      if (!options_.young_modulus)
        return mistakes_.add(row.line, "has a total strain: give --young-modulus, or the creep strain");
      strain -= elastic_strain(row);
      if (strain < 0 && *row.time > 0)
        return mistakes_.add(
            row.line,
            fmt::format("the total strain {:g} is below the elastic strain {:g} of the stress {:g}: the column "
                        "has the creep strain (name it creep_strain), or Young's modulus is too small",
                        *row.strain, elastic_strain(row), row.stress));
    }
    Test* test = continued(row, TestKind::creep);
    if (test == nullptr) {
      test = &add(started(row, TestKind::creep));
    } else {
      if (!near_stress(test->stress, row.stress) || !near_temperature(test->temperature, row.temperature))
        return mistakes_.add(
            row.line,
            fmt::format(
                "test '{}' goes from stress {:g}, temperature {:g} to {:g}, {:g}; allowed: one stress (within 1 "
                "%) and temperature (within 2 degrees) per test, or kind = relaxation",
                test->name, test->stress, test->temperature, row.stress, row.temperature));
      if (!require_order(row, *test)) return;
    }
    test->young_modulus_used = test->young_modulus_used || row.strain_is_total;
    test->readings.push_back({*row.time, strain, row.line});
  }

  void add_relaxation(const DataRow& row) {
    if (!options_.young_modulus)
      return mistakes_.add(row.line, "a relaxation test needs Young's modulus: give --young-modulus");
    Test* test = continued(row, TestKind::relaxation);
    if (test == nullptr) {
      const double modulus = (*options_.young_modulus)({.T = row.temperature});
      Test next = started(row, TestKind::relaxation);
      if (*row.time > 0) {
        if (!row.strain)
          return mistakes_.add(
              row.line,
              "is the first of a relaxation test: it needs the time 0 with the stress at the start, or "
              "the total strain that is held");
        next.stress = modulus * *row.strain;
      }
      next.young_modulus_used = true;
      test = &add(std::move(next));
    } else if (!require_order(row, *test)) {
      return;
    }
    test->readings.push_back({*row.time, row.stress, row.line});
  }

  /// A time in the rows of a creep test is one rupture, however often it is repeated.
  void add_rupture(const DataRow& row, double time) {
    const bool in_column = row.rupture && row.kind;
    Test test = started(row, TestKind::rupture);
    if (!ruptures_.emplace(test.name, time).second && in_column) return;
    test.same_specimen |= in_column;
    test.readings.push_back({0, time, row.line});
    add(std::move(test));
  }

  TestData& data_;
  const ReadOptions& options_;
  RowMistakes& mistakes_;
  std::vector<int> not_positive_;
  std::unordered_set<std::string> specimens_;  // names of tests that are not of another's specimen
  std::array<std::unordered_map<std::string, std::size_t>, n_test_kinds> last_named_;  // the last test of a name
  std::array<std::unordered_map<std::string, int>, n_test_kinds> like_named_;          // tests "name" and "name (...)"
  std::set<std::pair<std::string, double>> ruptures_;
};

/// A strain at time 0 that creep cannot have.
void warn_of_loading_strain(TestData& data, const std::vector<DataRow>& rows) {
  double largest = 0, at_start = 0;
  int line = 0;
  for (const DataRow& row : rows) {
    if (row.kind != TestKind::creep || row.strain_is_total) continue;
    largest = std::max(largest, *row.strain);
    if (*row.time == 0 && *row.strain > at_start) {
      at_start = *row.strain;
      line = row.line;
    }
  }
  if (at_start > 0.01 * largest)
    data.notes.push_back(
        fmt::format("the strain at time 0 is {:.3g} (line {}), up to {:.3g} later: creep strain begins at zero. If the "
                    "column has the total strain, give --young-modulus",
                    at_start, line, largest));
}

/// Creep does not recover at constant stress.
void warn_of_falling_strain(TestData& data) {
  constexpr double much = 0.1;  // of the largest strain
  for (const Test& test : data.tests) {
    if (test.kind != TestKind::creep) continue;
    const auto largest = std::ranges::max_element(test.readings, {}, &Reading::value);
    const Reading& last = test.readings.back();
    if (last.value < (1 - much) * largest->value)
      data.notes.push_back(fmt::format(
          "test '{}': the strain falls from {:.3g} (line {}) to {:.3g} (line {}), but creep strain does not "
          "fall at constant stress",
          test.name, largest->value, largest->line, last.value, last.line));
  }
}

/// A modulus in another unit than the stresses.
void check_young_modulus(TestData& data, const ReadOptions& options) {
  constexpr double smallest_elastic = 1e-6;                          // below any that could be measured
  constexpr double large_elastic = 0.02, impossible_elastic = 0.10;  // above those of metals; of small strains
  const Test* most = nullptr;
  double stress = 0;
  for (const Test& test : data.tests) {
    if (!test.young_modulus_used) continue;
    double own = test.stress;
    if (test.kind == TestKind::relaxation)
      for (const Reading& reading : test.readings) own = std::max(own, reading.value);
    if (own <= stress) continue;
    most = &test;
    stress = own;
  }
  if (most == nullptr) return;
  const double modulus = (*options.young_modulus)({.T = most->temperature});
  if (stress > large_elastic * modulus) {
    const std::string message = fmt::format(
        "test '{}': the elastic strain at the start is {:.3g} % (stress {:g}, Young's modulus {:g}): is "
        "--young-modulus in {}?",
        most->name, 100 * stress / modulus, stress, modulus,
        data.units.stress.empty() ? "the unit of the stresses" : data.units.stress);
    if (stress > impossible_elastic * modulus) throw ConfigError(fmt::format("{}: {}", data.file, message));
    data.notes.push_back(message);
  }
  if (stress < smallest_elastic * modulus)
    data.notes.push_back(
        fmt::format("with Young's modulus {:g} the elastic strain at the stress {:g} is {:.2g}: is the modulus in the "
                    "unit of the stresses?",
                    modulus, stress, stress / modulus));
}

/// Stresses in another unit than the heading has.
void warn_of_small_stress(TestData& data) {
  constexpr double smallest = 1e5;  // Pa
  const double largest = data.range().stress.high;
  if (data.units.stress == "Pa" && largest < smallest)
    data.notes.push_back(
        fmt::format("the stresses are {:g} Pa and less, too small for creep tests: are they in MPa?", largest));
}

std::vector<double> distinct(std::vector<double> values, double relative, double absolute) {
  std::ranges::sort(values);
  std::vector<double> result;
  for (const double value : values)
    if (result.empty() || value - result.back() > relative * value + absolute) result.push_back(value);
  return result;
}

}  // namespace

int TestData::n_readings() const {
  int n = 0;
  for (const Test& test : tests) n += static_cast<int>(test.readings.size());
  return n;
}

int TestData::n_specimens() const {
  return static_cast<int>(std::ranges::count(tests, false, &Test::same_specimen));
}

std::string TestData::load(double stress, double temperature) const {
  const auto with = [](double value, const std::string& unit) {
    return unit.empty() ? fmt::format("{:.5g}", value) : fmt::format("{:.5g} {}", value, unit);
  };
  const std::string text = with(stress, units.stress);
  return has_temperature ? text + ", " + with(temperature, units.temperature) : text;
}

std::vector<double> TestData::stresses() const {
  std::vector<double> all;
  for (const Test& test : tests) {
    all.push_back(test.stress);
    if (test.kind == TestKind::relaxation)
      for (const Reading& reading : test.readings) all.push_back(reading.value);
  }
  return distinct(std::move(all), same_stress, 0);
}

std::vector<double> TestData::temperatures() const {
  if (!has_temperature) return {};
  std::vector<double> all;
  for (const Test& test : tests) all.push_back(test.temperature);
  return distinct(std::move(all), 0, same_temperature);
}

DataRange TestData::range() const {
  std::vector<double> times, stress = stresses(), temperature = temperatures();
  for (const Test& test : tests)
    for (const Reading& reading : test.readings) {
      const double time = test.kind == TestKind::rupture ? reading.value : reading.time;
      if (time > 0) times.push_back(time);
    }
  const auto ends = [](const std::vector<double>& values) -> Interval {
    if (values.empty()) return {};
    const auto [low, high] = std::ranges::minmax(values);
    return {low, high};
  };
  return {ends(stress), ends(temperature), ends(times)};
}

TestData parse_test_data(std::string_view text, const std::string& name, const ReadOptions& options) {
  const io::CsvCells table = io::parse_csv_cells(text, name);
  const DataColumns columns(name, table.names);
  TestData data{
      .file = name, .units = columns.units(), .has_temperature = columns[ColumnRole::temperature].has_value()};
  if (!columns.unused().empty())
    data.notes.push_back(fmt::format("columns that are not used: {}", fmt::join(columns.unused(), ", ")));
  RowMistakes mistakes(name);
  std::vector<DataRow> rows = read_rows(table, columns, options.young_modulus.has_value(), options.thousands, mistakes);
  if (options.temperature) {
    if (!data.has_temperature) throw ConfigError(fmt::format("{}: --temperature: no column 'temperature'", name));
    std::erase_if(rows, [&](const DataRow& row) { return !near_temperature(row.temperature, *options.temperature); });
  }
  TestCollector tests(data, options, mistakes);
  for (const DataRow& row : rows) tests.add(row);
  mistakes.throw_if_any();
  warn_of_loading_strain(data, rows);
  tests.finish();
  warn_of_falling_strain(data);
  check_young_modulus(data, options);
  warn_of_small_stress(data);
  if (data.tests.empty())
    throw ConfigError(options.temperature ? fmt::format("{}: no test at temperature {:g}", name, *options.temperature)
                                          : fmt::format("{}: no readings after time 0", name));
  return data;
}

TestData read_test_data(const std::filesystem::path& path, const ReadOptions& options) {
  auto [text, failure] = read_file(path);
  if (!failure.empty()) throw ConfigError(fmt::format("{}: cannot be read: {}", path.string(), failure));
  return parse_test_data(text, path.string(), options);
}

}  // namespace creepcontact::fit
