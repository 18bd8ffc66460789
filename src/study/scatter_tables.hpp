#pragma once
/// The tables of a study with random keys: CSV files, and a section of study.md.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "scatter.hpp"

namespace creepcontact::study {

/// samples.csv: the random keys of every run.
std::string samples_csv(const config::Study& study, const std::vector<config::PlannedRun>& runs);

/// Names and texts of quantiles.csv, probabilities.csv, correlation.csv, sobol_indices.csv (unless keys are correlated)
/// and convergence.csv. With axes, their keys are the first columns.
std::vector<std::pair<std::string, std::string>> scatter_tables(const std::vector<config::PlannedRun>& runs,
                                                                const Scatter& scatter);

/// A section with the heading "Scatter": the tables in words, and small ones.
std::string scatter_markdown(const config::Study& study, const Scatter& scatter);

/// Shares of the variance mean something if the polynomials predict the result at least so well.
inline constexpr double min_quality = 0.5;

}  // namespace creepcontact::study
