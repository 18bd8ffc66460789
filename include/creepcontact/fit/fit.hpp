#pragma once
/// Parameters of a creep law from measured data, by nonlinear least squares.

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/fit/law_choice.hpp"
#include "creepcontact/fit/test_data.hpp"

namespace creepcontact::fit {

/// One parameter that was fitted.
struct FittedParameter {
  std::string key, unit;
  double value = 0;
  double low = 0, high = 0;    ///< 95 % confidence interval; both the value if it is at a bound
  bool at_bound = false;       ///< the data draw it to the end of its range, where it is held
  bool is_logarithmic = true;  ///< its logarithm is normally distributed, else it itself ...
  double deviation = 0;        ///< ... with this standard deviation; 0 at a bound
};

/// How batches of the steel (melts) differ: each has its own value of one constant, exp(difference) times the mean.
struct BatchScatter {
  struct Batch {
    std::string name;
    int n_tests = 0;
    double difference = 0, deviation = 0;  ///< of the logarithm, and how well the readings determine it
  };
  std::string key;  ///< of the constant
  std::vector<Batch> batches = {};
  /// Standard deviation of the differences from batch to batch, without what the readings leave open of each.
  double deviation = 0;
};

/// Residuals of one kind of test.
struct KindResiduals {
  int n = 0;
  double deviation = 0;  ///< root of the mean square of the logarithms
};

struct FitResult {
  std::vector<FittedParameter> parameters;
  Eigen::MatrixXd correlation;  ///< of the parameters, logarithms of those >= 0; NaN: at a bound
  double deviation = 0;         ///< standard deviation of the residuals, logarithms of ratios
  int n_readings = 0, degrees_of_freedom = 0;
  std::array<KindResiduals, n_test_kinds> kinds;
  DataRange range;
  std::optional<BatchScatter> batches;  ///< if the data tell them apart; `parameters` are then those of the mean batch
  int n_starts = 0, n_agreeing = 0;     ///< searches for the minimum, and how many ended in it
  std::shared_ptr<const material::CreepLaw> law;
  std::vector<std::vector<double>> residuals;  ///< per test and reading: log(measured/predicted)
  std::vector<std::string> warnings;           ///< with numbers: what is badly determined or does not fit
};

/// Residuals are logarithms, so that readings count by their relative error, whatever their size (Test::floor). Several
/// searches start at points of a Latin hypercube (M. D. McKay et al., Technometrics 21, 1979); the same data give the
/// same result. Intervals are those of Student's t distribution with the covariance s^2 (J^T J)^-1 of the linearised
/// problem (G. A. F. Seber, C. J. Wild, Nonlinear Regression, 1989, section 5.1), in the logarithm of parameters >= 0.
/// With TestData::batches the law's rate or strain has a factor for each (on its first constant with a unit of stress
/// or time), so that readings tell of the constants and batches of their scatter (one-way analysis of variance with
/// random effects: S. R. Searle, G. Casella, C. E. McCulloch, Variance Components, 1992, chapter 3).
/// @param young_modulus  of T; needed for relaxation tests
/// @throws ConfigError if there are not more readings than parameters, the law cannot describe the data, or the data
/// cannot tell parameters apart; SolverError if no search ends
/// Cost: seconds.
FitResult fit_law(const TestData& data, const LawChoice& choice, const std::optional<Function>& young_modulus);

}  // namespace creepcontact::fit
