#include "frd_temperatures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>

#include "../tables/csv_text.hpp"
#include "creepcontact/base/error.hpp"
#include "point_merging.hpp"

namespace creepcontact::io {
namespace {

/// Lines have fields of fixed width, without blanks between them.
class FrdReader {
 public:
  FrdReader(std::string_view text, std::string name) : lines_(text), name_(std::move(name)) {}

  PointTemperatures read() {
    while (next()) {
      const std::string_view key = trimmed(line_.substr(0, std::min<std::size_t>(line_.size(), 6)));
      if (key.starts_with("2C"))
        read_nodes();
      else if (key.starts_with("100C"))
        read_results();
    }
    return temperatures();
  }

 private:
  using Step = std::vector<std::pair<std::size_t, double>>;  // number of the node in coordinates_, temperature

  [[noreturn]] void fail(const std::string& what) const {
    throw ModelError(fmt::format("'{}', line {}: {}", name_, number_, what));
  }

  bool next() {
    ++number_;
    if (!lines_.next(line_)) return false;
    if (line_.ends_with('\r')) line_.remove_suffix(1);
    return true;
  }

  static std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(' ');
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(' ') - begin + 1);
  }

  template <class Number>
  Number field(std::size_t begin, std::size_t width, const char* what) const {
    const std::string_view cell = begin < line_.size() ? trimmed(line_.substr(begin, width)) : std::string_view();
    Number value{};
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc() || end != cell.data() + cell.size() || cell.empty())
      fail(fmt::format("'{}' in the columns {} to {} is not a {}", cell, begin + 1, begin + width, what));
    if (!std::isfinite(static_cast<double>(value))) fail(fmt::format("the {} is not finite", what));
    return value;
  }

  /// @param column  of the mark of the format in the head of a block @returns the width of node numbers
  std::size_t node_width(std::size_t column) const {
    const int format = column < line_.size() ? line_[column] - '0' : 0;
    if (format == 2 || format == 3)
      fail("the file is binary; let CalculiX write ascii (*NODE FILE without OUTPUT = ..., no binary option)");
    if (format != 0 && format != 1) fail(fmt::format("format '{}' of a block is unknown", line_[column]));
    return format == 0 ? 5 : 10;
  }

  bool is(std::string_view mark) const { return line_.starts_with(mark); }

  void read_nodes() {
    const std::size_t width = node_width(73);
    while (next()) {
      if (is(" -3")) return;
      if (!is(" -1")) fail("no node (' -1') and no end of the nodes (' -3')");
      const auto node = field<std::int64_t>(3, width, "node number");
      Vector3 x;
      for (std::size_t i = 0; i < 3; ++i) x[static_cast<int>(i)] = field<double>(3 + width + 12 * i, 12, "coordinate");
      if (!nodes_.try_emplace(node, coordinates_.size()).second) fail(fmt::format("node {} is there twice", node));
      coordinates_.push_back(x);
    }
    fail("the file ends within the nodes");
  }

  void read_results() {
    const auto time = field<double>(12, 12, "time");
    const std::size_t width = node_width(74);
    Step* step = nullptr;
    while (next()) {
      if (is(" -3")) return;
      if (is(" -4")) {
        std::string_view name = trimmed(line_.substr(3, std::min<std::size_t>(line_.size(), 13) - 3));
        name = name.substr(0, name.find(' '));
        results_.emplace(name);
        if (name != "NDTEMP") continue;
        step = &steps_[time];
        step->clear();
      } else if (is(" -1") && step != nullptr) {
        const auto node = field<std::int64_t>(3, width, "node number");
        const auto known = nodes_.find(node);
        if (known == nodes_.end()) fail(fmt::format("node {} has a temperature, but no coordinates", node));
        step->emplace_back(known->second, field<double>(3 + width, 12, "temperature"));
      }
    }
    fail("the file ends within results");
  }

  PointTemperatures temperatures() const {
    if (steps_.empty() || steps_.begin()->second.empty())
      throw ModelError(fmt::format("'{}' contains no temperatures (NDTEMP){}; request them by NT in *NODE FILE", name_,
                                   results_.empty() ? "" : fmt::format(", but {}", fmt::join(results_, ", "))));
    PointTemperatures result;
    result.has_times = true;
    const Step& first = steps_.begin()->second;
    for (const auto& [node, temperature] : first) result.points.push_back(coordinates_[node]);
    for (const auto& [time, step] : steps_) {
      const bool same =
          step.size() == first.size() && std::equal(step.begin(), step.end(), first.begin(),
                                                    [](const auto& a, const auto& b) { return a.first == b.first; });
      if (!same)
        throw ModelError(fmt::format("'{}': the nodes with temperatures at t = {:.6g} and at t = {:.6g} differ", name_,
                                     steps_.begin()->first, time));
      result.times.push_back(time);
      std::vector<double>& values = result.values.emplace_back();
      for (const auto& [node, temperature] : step) values.push_back(temperature);
    }
    return result;
  }

  CsvLines lines_;
  std::string name_;
  std::string_view line_;
  std::size_t number_ = 0;
  std::unordered_map<std::int64_t, std::size_t> nodes_;
  std::vector<Vector3> coordinates_;
  std::map<double, Step> steps_;
  std::set<std::string> results_;  // names, for the message
};

}  // namespace

PointTemperatures parse_frd(std::string_view text, const std::string& name) {
  return merged(FrdReader(text, name).read(), name);
}

}  // namespace creepcontact::io
