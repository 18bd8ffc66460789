#pragma once
/// Which files hold the temperatures of which times.

#include <filesystem>
#include <optional>
#include <vector>

#include "creepcontact/io/temperatures/temperature_reader.hpp"

namespace creepcontact::io {

struct TimedFile {
  std::filesystem::path path;
  std::optional<double> time = {};  ///< nullopt: as the file says
};

/// The files of a source, those of a pattern in the order of their times.
/// @throws ModelError if no file is of the form of the pattern, or there is no number where its '*' is
std::vector<TimedFile> timed_files(const TemperatureSource& source);

/// Puts what was read from each file together. @throws ModelError if they have other points, or times that do not fit
PointTemperatures joined(const std::vector<TimedFile>& files, std::vector<PointTemperatures> read);

}  // namespace creepcontact::io
