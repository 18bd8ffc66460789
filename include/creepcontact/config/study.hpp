#pragma once
/// A study: many runs of one configuration, compared with a reference. Keys and their defaults.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/config/location.hpp"
#include "creepcontact/config/vocabulary.hpp"

namespace creepcontact::config {

/// A value of a study, as TOML writes it: what follows the '=' of an override.
struct StudyValue {
  std::string toml;
  std::string label;  ///< for people: strings without quotation marks
  Location location;
};

struct Setting {
  std::string key;
  Location key_location;
  StudyValue value;
  /// "key=value", as `--set` takes it
  std::string override_text() const { return key + '=' + value.toml; }
};

struct Axis {
  Reference key;
  std::string zip;  ///< axes of the same name run together; empty: one of the product
  std::vector<StudyValue> values;
  Location location;
};

/// Runs with common settings: the product of the axes, or a single run without axes.
struct Product {
  std::string label;  ///< for people; may be empty
  std::vector<Setting> settings;
  std::vector<Axis> axes;
  Location location;
};

/// What the runs are compared with: another run, a file or closed forms; at most one of the three is given.
struct StudyReference {
  std::vector<Setting> settings;
  std::filesystem::path csv;                    ///< with the columns of history.csv
  std::map<std::string, Function> expressions;  ///< of t, by probe
  Location location;
  bool is_run() const { return csv.empty() && expressions.empty(); }
};

enum class ErrorNorm { max, final };

struct Compare {
  std::vector<Reference> quantities;  ///< probes of the configuration
  ErrorNorm norm = ErrorNorm::max;
};

/// Columns of study.csv that tell what a run cost.
const std::vector<std::string>& study_counts();

/// Pictures of results along an axis.
struct StudyPlot {
  std::vector<Reference> over;    ///< keys of axes; empty: see axis_of_curves()
  std::vector<std::string> show;  ///< of study_counts(), beside the errors
};

struct Study {
  std::filesystem::path file;  ///< as given by the user
  std::string title;
  std::filesystem::path base;  ///< already relative to the working directory
  Location base_location;
  std::vector<Setting> settings;  ///< of all runs and the reference, before their own
  std::vector<Axis> axes;         ///< of the first product
  std::vector<Product> runs;      ///< beside it
  std::optional<StudyReference> reference;
  Compare compare;
  StudyPlot plot;
  std::string
      normalized;  ///< the document without names, [plot], comments and layout: of equal ones the runs are equal
};

/// One run of a study.
struct PlannedRun {
  std::string name;               ///< "run_001", in the order of the study
  std::vector<Setting> settings;  ///< its own, those of all runs not among them
  std::size_t product = 0;        ///< index into products()
  std::vector<int> point;         ///< index of the value on each of its axes
};

/// @throws ConfigError holding every mistake in the document, as config::read
Study read_study(const std::filesystem::path& file);
/// As read_study(), from text. @param file  stands in messages; relative paths are taken relative to its directory
Study parse_study(const std::string& text, const std::filesystem::path& file);

/// The product of the study's axes, if it has any, then those of [[runs]].
std::vector<Product> products(const Study& study);

/// The axis along which a product's results are drawn: the first of [plot] over that it has, or time.step,
/// time.tolerance, or else its last one with several values; only axes whose values are numbers.
/// @returns index into its axes; nullopt if it has none
std::optional<std::size_t> axis_of_curves(const Study& study, const Product& product);

/// Values of an axis as numbers, NaN for others ("stable"); empty if none is one.
std::vector<double> numbers(const Axis& axis);

/// Whether the two take their values together: zipped, or one and the same.
bool run_together(const Axis& a, const Axis& b);

/// A study that plans more is refused.
inline constexpr int most_runs = 10000;
/// How many runs it plans, which may be more than there is memory for.
double n_runs(const Study& study);

/// All runs, product by product, the last axis of each changing fastest.
std::vector<PlannedRun> plan(const Study& study);

/// The overrides of the base configuration that make a run of it.
std::vector<std::string> overrides(const Study& study, const std::vector<Setting>& own);

/// Reads the base configuration with the settings of every run, and of the reference if it is one.
/// @throws ConfigError holding every mistake, those of a setting at its place in the study, and every quantity that is
///         no probe of the configuration
void check_runs(const Study& study, const std::vector<PlannedRun>& runs, const Vocabulary& vocabulary);

}  // namespace creepcontact::config
