#include "shard_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>
#include <sstream>

#include "creepcontact/base/checksum.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/one_line.hpp"
#include "creepcontact/io/checkpoint/array_file.hpp"

namespace creepcontact::study {
namespace {

std::string joined(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += name + '\n';
  return text;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// A value per run and name, run by run, in the order of the names; what a run does not have is infinite and negative.
constexpr double absent = -std::numeric_limits<double>::infinity();

template <class Values, class Number>
void append_by_name(const std::set<std::string>& names, const Values& values, const Number& number,
                    std::vector<double>& all) {
  for (const std::string& name : names) {
    const auto found = values.find(name);
    all.push_back(found == values.end() ? absent : number(found->second));
  }
}

/// Reads one entry after the other, and notices where a file ends too early.
template <class T>
class Sequence {
 public:
  explicit Sequence(const std::vector<T>& all) : all_(all) {}
  T next() {
    if (position_ >= all_.size()) throw ConfigError("it is shorter than its content");
    return all_[position_++];
  }

 private:
  const std::vector<T>& all_;
  std::size_t position_ = 0;
};

ShardRuns runs_in(const io::NamedArrays& arrays) {
  const std::vector<std::string> probes = lines_of(arrays.texts.at("columns")),
                                 criteria = lines_of(arrays.texts.at("criteria")),
                                 events = lines_of(arrays.texts.at("events")),
                                 extremes = lines_of(arrays.texts.at("probes")),
                                 statuses = lines_of(arrays.texts.at("status")),
                                 messages = lines_of(arrays.texts.at("message"));
  const std::vector<std::int64_t>& indices = arrays.integers.at("run");
  if (statuses.size() != indices.size() || messages.size() != indices.size())
    throw ConfigError("it is shorter than its content");
  Sequence<std::int64_t> records(arrays.integers.at("record")), rows(arrays.integers.at("rows")),
      counters(arrays.integers.at("counters"));
  Sequence<double> history(arrays.numbers.at("history")), costs(arrays.numbers.at("seconds_and_end")),
      criterion(arrays.numbers.at("criteria")), event(arrays.numbers.at("events")),
      extreme(arrays.numbers.at("extremes"));
  ShardRuns runs;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    KeptRun& run = runs[static_cast<std::size_t>(indices[i])];
    run.record = std::bit_cast<std::uint64_t>(records.next());
    StudyRow& row = run.outcome.row;
    row.status = statuses[i];
    row.message = messages[i];
    for (const RunCounters::Field& field : RunCounters::fields) row.*field.value = counters.next();
    row.counted = row.succeeded();
    row.wall_seconds = costs.next();
    row.end_time = costs.next();
    const auto take_named = [](const std::vector<std::string>& names, Sequence<double>& values,
                               std::map<std::string, double>& into) {
      for (const std::string& name : names)
        if (const double value = values.next(); value != absent) into[name] = value;
    };
    take_named(criteria, criterion, row.criteria);
    take_named(events, event, row.events);
    for (const std::string& name : extremes) {
      const double min = extreme.next(), max = extreme.next();
      if (min == absent) continue;
      ProbeCourse& course = run.outcome.extremes[name];
      course.min = min;
      course.max = max;
    }
    run.outcome.history.names = probes;
    const auto n = static_cast<std::size_t>(rows.next());
    for (std::size_t column = 0; column < probes.size(); ++column) {
      std::vector<double>& values = run.outcome.history.columns.emplace_back();
      for (std::size_t t = 0; t < n; ++t) values.push_back(history.next());
    }
  }
  return runs;
}

}  // namespace

std::uint64_t record_checksum(const std::string& record) {
  Checksum checksum;
  checksum.add(record.data(), record.size());
  return checksum.value();
}

void write_shard_file(const std::filesystem::path& file, const ShardRuns& runs) {
  std::set<std::string> columns, criteria, events, probes;
  for (const auto& [index, run] : runs) {
    columns.insert(run.outcome.history.names.begin(), run.outcome.history.names.end());
    for (const auto& [name, value] : run.outcome.row.criteria) criteria.insert(name);
    for (const auto& [name, value] : run.outcome.row.events) events.insert(name);
    for (const auto& [name, value] : run.outcome.extremes) probes.insert(name);
  }
  io::NamedArrays arrays;
  arrays.texts = {{"columns", joined(columns)},
                  {"criteria", joined(criteria)},
                  {"events", joined(events)},
                  {"probes", joined(probes)},
                  {"status", ""},
                  {"message", ""}};
  // Empty lists are written too.
  for (const char* const name : {"history", "seconds_and_end", "criteria", "events", "extremes"}) arrays.numbers[name];
  for (const char* const name : {"run", "record", "rows", "counters"}) arrays.integers[name];
  const auto itself = [](double value) { return value; };
  for (const auto& [index, run] : runs) {
    const StudyRow& row = run.outcome.row;
    arrays.integers["run"].push_back(static_cast<std::int64_t>(index));
    arrays.integers["record"].push_back(std::bit_cast<std::int64_t>(run.record));
    arrays.integers["rows"].push_back(static_cast<std::int64_t>(run.outcome.history.rows()));
    for (const RunCounters::Field& field : RunCounters::fields) arrays.integers["counters"].push_back(row.*field.value);
    arrays.texts["status"] += row.status + '\n';
    arrays.texts["message"] += one_line(row.message) + '\n';
    arrays.numbers["seconds_and_end"].push_back(row.wall_seconds);
    arrays.numbers["seconds_and_end"].push_back(row.end_time);
    append_by_name(criteria, row.criteria, itself, arrays.numbers["criteria"]);
    append_by_name(events, row.events, itself, arrays.numbers["events"]);
    for (const std::string& name : probes)
      for (double ProbeCourse::*const part : {&ProbeCourse::min, &ProbeCourse::max})
        append_by_name(
            {name}, run.outcome.extremes, [&](const ProbeCourse& course) { return course.*part; },
            arrays.numbers["extremes"]);
    const std::size_t rows = run.outcome.history.rows();
    for (const std::string& name : columns) {
      const std::vector<double>* const column = run.outcome.history.column(name);
      for (std::size_t t = 0; t < rows; ++t)
        arrays.numbers["history"].push_back(column != nullptr ? (*column)[t] : ProbeCourse::unknown);
    }
  }
  io::write_array_file(file, arrays);
}

ShardRuns read_shard_file(const std::filesystem::path& file) {
  try {
    return runs_in(io::read_array_file(file));
  } catch (const std::out_of_range&) {
    throw ConfigError(fmt::format("'{}' does not hold the runs of a shard", file.string()));
  }
}

}  // namespace creepcontact::study
