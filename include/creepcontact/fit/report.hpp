#pragma once
/// What a fit found, for people and for configurations.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/fit/fit.hpp"

namespace creepcontact::fit {

/// Tables of parameters, correlation, residuals and the range of the data, as plain text. Warnings are not among them.
std::string report(const TestData& data, const LawChoice& choice, const FitResult& result);

/// What to say of a fit whose residuals have a root mean square above 100 %, with a remedy if there is one; empty: the
/// law describes the data.
std::string why_useless(const LawChoice& choice, const FitResult& result);

/// The elastic constants of the block, if they are known.
struct BlockOptions {
  std::string material = "fitted";  ///< a bare key of TOML
  std::optional<Function> young_modulus = {};
  double poisson_ratio = 0.3;
};

/// [materials.<name>] with the law and the range of the data; without Young's modulus its heading is a comment, so that
/// the block can follow a table that has one.
std::string material_block(const TestData& data, const LawChoice& choice, const FitResult& result,
                           const BlockOptions& options);

/// How well the constants are known, as TOML: keys, values, standard deviations and correlations of those that are not
/// at a bound, in the units of the block. A study takes it as `fit` of [[random.keys]]; empty: none is known.
std::string scatter_block(const TestData& data, const LawChoice& choice, const FitResult& result);

/// First line of a block; a file that begins with it may be overwritten.
inline constexpr const char* block_heading = "# Fitted by creepcontact fit";

/// Draws measured and fitted values over time, and the residuals, each as SVG and PNG.
/// @param young_modulus  as for fit_law() @returns the SVG files @throws as plot::draw()
std::vector<std::filesystem::path> draw_fit(const TestData& data, const FitResult& result,
                                            const std::optional<Function>& young_modulus,
                                            const std::filesystem::path& directory);

}  // namespace creepcontact::fit
