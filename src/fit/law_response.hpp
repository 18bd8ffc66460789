#pragma once
/// What a law predicts for the readings of a set of data.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/fit/test_data.hpp"
#include "creepcontact/material/creep_law.hpp"

namespace creepcontact::fit {

/// Simulates the tests.
class LawResponse {
 public:
  /// @param data  must outlive the object @param young_modulus  of T; needed for relaxation tests
  LawResponse(const TestData& data, std::optional<Function> young_modulus);

  int n_readings() const { return n_readings_; }
  /// Logarithms of measured to predicted values, of all readings in turn; those of creep strains with the floor of
  /// their test added to both.
  /// @param laws  one, or one for each batch of the data @returns nullopt if a law gives no finite values
  std::optional<std::vector<double>> residuals(std::span<const std::shared_ptr<const material::CreepLaw>> laws) const;
  /// Predicted values of one test; empty if the law gives none. Beyond rupture the strain goes on as a steep power of
  /// time, so that a law that ruptures too early is drawn to a later time.
  std::vector<double> predicted(const std::shared_ptr<const material::CreepLaw>& law, const Test& test) const;
  /// The creep strain or stress at any times, increasing, up to rupture; for figures.
  std::vector<double> curve(const std::shared_ptr<const material::CreepLaw>& law, const Test& test,
                            const std::vector<double>& times) const;
  /// Why the law cannot describe readings of some test, whatever its parameters; empty: it can.
  std::string why_impossible(const std::shared_ptr<const material::CreepLaw>& law) const;

 private:
  const TestData& data_;
  std::optional<Function> young_modulus_;
  int n_readings_;
};

}  // namespace creepcontact::fit
