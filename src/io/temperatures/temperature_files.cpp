#include "temperature_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"

namespace creepcontact::io {
namespace {

namespace fs = std::filesystem;

std::optional<double> time_in(const std::string& text) {
  double time = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), time);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(time)) return std::nullopt;
  return time;
}

std::vector<TimedFile> files_of_pattern(const fs::path& pattern) {
  const std::string form = pattern.filename().string();
  const std::size_t star = form.find('*');
  if (pattern.parent_path().string().find('*') != std::string::npos || form.find('*', star + 1) != std::string::npos)
    throw ModelError(fmt::format("'{}': only the name of the file may have a '*', and only one: it represents the time",
                                 pattern.string()));
  const std::string before = form.substr(0, star), after = form.substr(star + 1);
  const fs::path directory = pattern.has_parent_path() ? pattern.parent_path() : ".";
  std::vector<TimedFile> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory, error)) {
    const std::string name = entry.path().filename().string();
    if (name.size() <= before.size() + after.size() || !name.starts_with(before) || !name.ends_with(after)) continue;
    const std::string number = name.substr(before.size(), name.size() - before.size() - after.size());
    const auto time = time_in(number);
    if (!time)
      throw ModelError(
          fmt::format("'{}': the file '{}' has this form, but '{}' is not a number; its number is the time",
                      pattern.string(), name, number));
    files.push_back({pattern.parent_path() / name, time});
  }
  if (error) throw ModelError(fmt::format("cannot read the directory '{}': {}", directory.string(), error.message()));
  if (files.empty()) throw ModelError(fmt::format("no file is of the form '{}'", pattern.string()));
  std::ranges::sort(files, {}, &TimedFile::time);
  for (std::size_t i = 1; i < files.size(); ++i)
    if (files[i].time == files[i - 1].time)
      throw ModelError(
          fmt::format("'{}' and '{}' are of the same time", files[i - 1].path.string(), files[i].path.string()));
  return files;
}

void require_same_points(const PointTemperatures& first, const fs::path& first_file, const PointTemperatures& other,
                         const fs::path& file) {
  if (first.points == other.points && first.coordinates == other.coordinates) return;
  const auto less = [](const Vector3& a, const Vector3& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  const auto lacks = [&](const PointTemperatures& in, const fs::path& in_file, const PointTemperatures& of,
                         const fs::path& of_file) {
    for (const Vector3& x : of.points)
      if (!std::binary_search(in.points.begin(), in.points.end(), x, less))
        throw ModelError(
            fmt::format("'{}': the point ({:.6g}, {:.6g}, {:.6g}) of '{}' is missing; the same positions must appear "
                        "at every time",
                        in_file.string(), x[0], x[1], x[2], of_file.string()));
  };
  lacks(other, file, first, first_file);
  lacks(first, first_file, other, file);
  throw ModelError(fmt::format("'{}' and '{}' have other columns", first_file.string(), file.string()));
}

}  // namespace

std::vector<TimedFile> timed_files(const TemperatureSource& source) {
  if (source.files.size() == 1 && source.files[0].string().find('*') != std::string::npos &&
      !path_exists(source.files[0]))
    return files_of_pattern(source.files[0]);
  std::vector<TimedFile> files;
  for (std::size_t i = 0; i < source.files.size(); ++i)
    files.push_back({source.files[i], source.times.empty() ? std::nullopt : std::optional(source.times[i])});
  return files;
}

PointTemperatures joined(const std::vector<TimedFile>& files, std::vector<PointTemperatures> read) {
  for (std::size_t i = 0; i < files.size(); ++i) {
    PointTemperatures& one = read[i];
    if (files[i].time) {
      if (one.times.size() > 1)
        throw ModelError(fmt::format("'{}' has {} times of its own; give it alone, or without 'times'",
                                     files[i].path.string(), one.times.size()));
      one.times[0] = *files[i].time;
    } else if (files.size() > 1 && !one.has_times) {
      throw ModelError(
          fmt::format("'{}' does not say its time; give the times of all files by 'times'", files[i].path.string()));
    }
    require_same_points(read[0], files[0].path, one, files[i].path);
  }
  std::vector<std::size_t> order(read.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return read[i].times[0]; });
  PointTemperatures result;
  result.points = std::move(read[0].points);
  result.coordinates = read[0].coordinates;
  result.has_times = files.size() > 1 || read[0].has_times;
  for (const std::size_t i : order)
    for (std::size_t t = 0; t < read[i].times.size(); ++t) {
      if (!result.times.empty() && !(read[i].times[t] > result.times.back()))
        throw ModelError(fmt::format("'{}' has temperatures at t = {:.6g}, which other files have already passed",
                                     files[i].path.string(), read[i].times[t]));
      result.times.push_back(read[i].times[t]);
      result.values.push_back(std::move(read[i].values[t]));
    }
  return result;
}

}  // namespace creepcontact::io
