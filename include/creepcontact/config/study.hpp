#pragma once
/// A study: many runs of one configuration, compared with each other or with a reference. Its keys and their defaults.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/config/location.hpp"
#include "creepcontact/config/random.hpp"
#include "creepcontact/config/vocabulary.hpp"
#include "creepcontact/settings/enum_names.hpp"

namespace creepcontact::config {

/// A value in a study, written as in TOML: what follows '=' in an override.
struct StudyValue {
  std::string toml;
  std::string label;  ///< for display: strings without quotation marks
  Location location;
};

/// One key of the base configuration set to a value.
struct Setting {
  std::string key;
  Location key_location;
  StudyValue value;
  /// "key=value", as --set takes it.
  std::string override_text() const { return key + '=' + value.toml; }
};

/// A key that takes several values.
struct Axis {
  Reference key;
  std::string zip;  ///< axes with the same name vary together; empty: independent
  std::vector<StudyValue> values;
  Location location;
};

/// Runs with common settings: the product of the axes; a single run if there are none.
struct Product {
  std::string label;  ///< for display; may be empty
  std::vector<Setting> settings;
  std::vector<Axis> axes;
  Location location;
};

/// What the runs are compared with: another run, a file, or closed-form expressions. At most one of the three is given.
struct StudyReference {
  std::vector<Setting> settings;
  std::filesystem::path csv;                    ///< file with the columns of history.csv
  std::map<std::string, Function> expressions;  ///< per probe, of t
  Location location;
  bool is_run() const { return csv.empty() && expressions.empty(); }
};

enum class ErrorNorm { max, final };
constexpr auto names_of(ErrorNorm) {
  return std::to_array<settings::EnumName<ErrorNorm>>({{"max", ErrorNorm::max}, {"final", ErrorNorm::final}});
}

/// [compare]
struct Compare {
  std::vector<Reference>
      quantities;  ///< probes to give for each run, and to compare with the reference if there is one
  ErrorNorm norm = ErrorNorm::max;
};

/// Columns of study.csv that measure the cost of a run.
const std::vector<std::string>& study_counts();

/// Figures of results along an axis.
struct StudyPlot {
  std::vector<Reference> over;    ///< keys of axes; empty: see axis_of_curves()
  std::vector<std::string> show;  ///< of study_counts(), in addition to the errors
  bool histories = true;          ///< of the compared probes, of all runs in one picture
};

/// What is kept of each run.
enum class Keep { runs, shard };
constexpr auto names_of(Keep) {
  return std::to_array<settings::EnumName<Keep>>({{"runs", Keep::runs}, {"shard", Keep::shard}});
}

/// A study that has been read and checked.
struct Study {
  std::filesystem::path file;  ///< as given by the user
  std::string title;
  std::filesystem::path base;  ///< the base configuration, resolved against the directory of the study
  Location base_location;
  std::vector<Setting> settings;  ///< of all runs and the reference; their own settings come after
  std::vector<Axis> axes;         ///< of the first product
  std::vector<Product> runs;      ///< further products
  std::optional<StudyReference> reference;
  Compare compare;
  StudyPlot plot;
  std::optional<Random> random;
  Keep keep = Keep::runs;
  /// The study without names, [plot], keep, random.quantiles, comments and layout: studies with equal texts have
  /// equal runs.
  std::string normalized;
  /// `normalized` without random.samples, unless other samples are drawn if there are more of them.
  std::string without_size;
};

/// One run of a study.
struct PlannedRun {
  std::string name;                  ///< "run_001", in the order of the study
  std::vector<Setting> settings;     ///< its own, without those of all runs and of its sample
  std::size_t product = 0;           ///< index into products()
  std::vector<int> point;            ///< index of the value on each axis of its product
  std::size_t sample = 0;            ///< number of its sample, from 0
  std::size_t combination = 0;       ///< of a product and a point; each has all samples
  std::vector<double> sampled = {};  ///< values of the random keys
};

/// @throws ConfigError with one line per error found, as config::read
Study read_study(const std::filesystem::path& file);
/// Like read_study(), from text. @param file  name for messages; relative paths are relative to its directory
Study parse_study(const std::string& text, const std::filesystem::path& file);

/// The product of the axes of the study, if it has axes, then those of [[runs]]; if it has neither, one of the base.
std::vector<Product> products(const Study& study);

/// The axis along which the results of a product are plotted: the first of [plot] over that the product has; else
/// time.step or time.tolerance; else the last axis with several values. Only axes with numbers as values count.
/// @returns index into its axes; nullopt if there is none
std::optional<std::size_t> axis_of_curves(const Study& study, const Product& product);

/// Values of an axis as numbers, NaN for others such as "stable"; empty if none is a number.
std::vector<double> numbers(const Axis& axis);

/// True if the two axes vary together: zipped, or the same axis.
bool run_together(const Axis& a, const Axis& b);

/// Number of runs of a product, as double since it may exceed what can be planned.
double n_runs(const Product& product);

/// All runs, product by product; the last axis of each varies fastest, and before it the samples.
std::vector<PlannedRun> plan(const Study& study);

/// The run with which the others are compared, if the reference is a run.
std::optional<PlannedRun> reference_run(const Study& study);

/// The settings of a run alone, with those of its sample.
std::vector<Setting> settings_of(const Study& study, const PlannedRun& run);
/// The overrides that turn the base configuration into a run.
std::vector<std::string> overrides(const Study& study, const PlannedRun& run);

/// The overrides that turn the base configuration into a run. @param own  settings of the run
std::vector<std::string> overrides(const Study& study, const std::vector<Setting>& own);

/// Reads the base configuration with the settings of every run, and of the reference if it is a run; of more than a
/// thousand runs those that have every value of every axis. Random keys are read at the ends of their distributions; a
/// sample that is wrong nevertheless is a run that fails.
/// @throws ConfigError with one line per error: those of settings with their location in the study, and unknown
/// quantities (not probes of the configuration)
void check_runs(const Study& study, const std::vector<PlannedRun>& runs, const Vocabulary& vocabulary);

/// The probes that a study is about: those of [compare], or, of a study with random keys without it, all of the base.
std::vector<Reference> compared_probes(const Study& study, const Vocabulary& vocabulary);

}  // namespace creepcontact::config
