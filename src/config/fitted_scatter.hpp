#pragma once
/// FILE_scatter.toml, in which `creepcontact fit` leaves how well the constants of a law are known.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "diagnostics.hpp"

namespace creepcontact::config {

struct FittedConstant {
  std::string key;
  double value = 0;
  bool is_logarithmic = true;  ///< its logarithm is normal, else it itself
  double deviation = 0;        ///< standard deviation, of the logarithm if that is normal
};

struct FittedScatter {
  std::vector<FittedConstant> constants;
  std::vector<std::vector<double>> correlation;
};

/// @returns nullopt after a mistake. @param place  that names the file
std::optional<FittedScatter> read_fitted_scatter(const std::filesystem::path& file, const Location& place,
                                                 Diagnostics& errors);

}  // namespace creepcontact::config
