#pragma once
/// summary.json: the outcome and the cost of a run.

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "creepcontact/base/memory.hpp"
#include "creepcontact/base/run_counters.hpp"
#include "creepcontact/base/stopwatch.hpp"
#include "creepcontact/base/units.hpp"

namespace creepcontact::io {

/// What a column of history.csv contains.
struct SummaryProbe {
  std::string quantity = {};
  std::string label = {};  ///< for axes: "contact pressure"
  Dimension dimension = Dimension::none;
  std::string integrated_over = {};  ///< "surface" or "body" if the values are sums over it; else empty
  /// Unit of the values as they are in history.csv, "" if they have none or it is not known; nullopt: a file without
  /// it.
  std::optional<std::string> unit = {};
  std::string expression = {};  ///< of other probes; then it has no quantity

  /// The values at the first and the last output time, and the extremes of the run: of its output times and of the ends
  /// of its steps. Those that are not finite are left out of min and max.
  struct Course {
    double start = 0, end = 0;
    double min = 0, max = 0, t_min = 0, t_max = 0;  ///< smallest and largest value, and their first times
    bool operator==(const Course&) const = default;
    static constexpr auto members =
        std::tuple{Member{"start", &Course::start}, Member{"end", &Course::end},     Member{"min", &Course::min},
                   Member{"max", &Course::max},     Member{"t_min", &Course::t_min}, Member{"t_max", &Course::t_max}};
  };
  std::optional<Course> course = {};  ///< nullopt before the first output
  bool operator==(const SummaryProbe&) const = default;
};

/// Content of summary.json; members have the names used in the file.
struct Summary : RunCounters {
  enum class Status { completed, ruptured, failed, interrupted };
  /// A quantity at the first output time, at its largest (of the output times and the ends of all steps), and at the
  /// last output time.
  struct Course {
    double start = 0, largest = 0, end = 0;
    double t_largest = 0;  ///< first time of the largest value
    /// end / largest; 0 if there was nothing
    double remaining() const { return largest > 0 ? end / largest : 0; }
    static constexpr auto members = std::tuple{Member{"start", &Course::start}, Member{"largest", &Course::largest},
                                               Member{"end", &Course::end}, Member{"t_largest", &Course::t_largest}};
  };
  struct Body {
    std::int64_t dofs = 0, elements = 0, integration_points = 0;
    Course von_mises;  ///< largest of the body
    /// Largest von Mises stress / yield strength at its temperature; nullopt: the material has no yield strength.
    std::optional<Course> yield_share = {};
  };
  struct Largest {
    double value = 0;
    std::array<double, 3> position{};
  };
  /// A body that has yielded, by its plasticity.
  struct Yielded {
    Largest strain;     ///< accumulated plastic strain
    double volume = 0;  ///< share of the body
  };
  struct Rupture {
    double time = 0;
    std::string body;
    Largest damage;
  };
  struct Contact {
    Course normal_force;
    std::optional<double> interference;       ///< found for a preload
    std::optional<double> dissipated_energy;  ///< by friction, up to the end
    std::optional<double> largest_slip;       ///< accumulated at the end, the largest over the surface
    /// Time from which on it carries nothing, having carried something; not if the cycles of the loads close it again.
    std::optional<double> opened;
    std::int64_t openings = 0;  ///< how often it has lost its force
  };
  /// Cycles of the loads, if the run has them.
  struct Cycles {
    std::int64_t completed = 0;  ///< since t = 0
    std::int64_t computed = 0;   ///< of them and of those that were rejected
    std::int64_t jumps = 0, rejected_jumps = 0, longest_jump = 0;
    /// Number of the cycle with which the run ended because it repeats, to within time.stop_when_steady.
    std::optional<std::int64_t> steady;
    double steady_within = 0;
    /// What the last cycle has changed, relative: the larger one of both criteria of time.stop_when_steady; omitted
    /// without it, and after cycles that need not repeat.
    std::optional<double> last_change;
    std::map<std::string, double> to_limit;  ///< cycles until the life of a body is used up, as far as it has life data
    /// True if that number of cycles lies behind.
    bool has_reached(double limit) const { return limit <= static_cast<double>(completed); }
  };
  struct WallSeconds {
    double total = 0;
    PartSeconds parts{};  ///< their sum is the total
  };
  struct Accuracy {
    double tolerance = 0;  ///< relative accuracy asked for the stress
    /// Estimated errors of the steps, in units of what the tolerance allows per step; omitted if the method estimates
    /// none.
    double mean_step_error = 0, largest_step_error = 0;
    /// Largest force at a free node that nothing balances, relative to the largest nodal force, at the end.
    std::optional<double> equilibrium_residual;
  };

  /// A criterion of the configuration, at the accepted step where it is closest to its limit, or farthest beyond.
  struct Criterion {
    std::optional<bool> met;  ///< nullopt: the run has not come to the times that count
    bool is_minimum = false;  ///< what is found must not be below what is allowed; else not above
    double found = 0, allowed = 0;
    double utilisation = 0;  ///< found/allowed of a maximum, allowed/found of a minimum: above 1 it is not met
    double time = 0;
    std::string body = {};                               ///< empty: no place belongs to it
    std::optional<std::array<double, 3>> position = {};  ///< in the body
    std::string demand = {};                             ///< in words: "seal, at least 12 MPa until t = 1e5 h"
    std::string unit = {};
  };

  /// Heat at the end, per time of its data.
  struct Heat {
    std::vector<std::pair<std::string, double>> flows;     ///< into the bodies, by what supplies it
    std::vector<std::pair<std::string, double>> contacts;  ///< across contacts, from the slave to the master
    double stored = 0;                                     ///< in the bodies
    double rest = 0;                                       ///< what flows in less what is stored, zero but for errors
    struct Gain {
      double value = 0, time = 0;
    };
    /// How strongly contact and heat act on each other, the largest of all output times: the part of a change of
    /// temperatures that comes back through pressure and conductance; above 1 the joint is unstable. Only if
    /// conductances depend on contact.
    std::optional<Gain> loop_gain = {};
    struct SuddenLoss {
      std::string contact;
      double time = 0, since = 0;  ///< without pressure; the last time with half of what was lost
      double force = 0;            ///< that was lost
    };
    /// Contacts that lost their pressure at the speed of heat.
    std::vector<SuddenLoss> sudden_losses = {};
    /// The largest single flow.
    double largest() const;
  };

  /// Derivatives with respect to a number of the configuration.
  struct Sensitivity {
    std::string key;
    double value = 0, change = 0;               ///< the number, and a typical change of it
    std::map<std::string, double> probes = {};  ///< of each at the last output
    std::map<std::string, double> events = {};  ///< of the times of those that happened
  };

  /// True if the values of the end are those of the last output, and the run went on from there or should have.
  bool ended_early() const { return status == Status::failed || status == Status::interrupted; }

  Status status = Status::completed;
  std::string message;  ///< omitted if empty
  std::string title, units, version;
  std::map<std::string, std::string> libraries;  ///< files of those that decide the speed: "blas", "lapack"
  std::string integrator;
  std::string method;  ///< integrator at work at the end, if `integrator` chose it; omitted if empty
  double time_reached = 0;
  /// Estimated error of plastic flow, of the stress relative to the yield stress; nullopt: no material yields.
  std::optional<double> plastic_error;
  /// Estimated error of the largest closures of gaskets, relative to them; nullopt: none unloads by a curve of its own.
  std::optional<double> gasket_error;
  std::optional<double> last_output;  ///< time of the last output, whose values are those of the end
  std::map<std::string, Body> bodies;
  /// Largest values per body, if its material has them.
  std::map<std::string, Yielded> plastic_strain;
  std::map<std::string, Largest> damage, life_fraction, fatigue_fraction, creep_fatigue;
  std::map<std::string, Largest> remaining_life;            ///< the smallest of each body that would rupture
  std::map<std::string, std::vector<std::string>> sources;  ///< of the data, by material; omitted if empty
  std::optional<Rupture> rupture;
  std::optional<Cycles> cycles;
  std::map<std::string, Contact> contacts;  ///< unilateral contacts, by name
  std::optional<Heat> heat;
  std::optional<double> friction_kappa;  ///< largest of start and end; above 1 several states may be possible
  WallSeconds wall_seconds;
  double peak_memory_mb = 0;
  Accuracy accuracy;
  std::vector<std::string> warnings;           ///< all that the run warned of, each once; omitted if empty
  std::map<std::string, SummaryProbe> probes;  ///< by name; omitted if empty
  /// Time of each event by its name, nullopt if it has not happened; omitted if empty.
  std::map<std::string, std::optional<double>> events;
  std::map<std::string, Criterion> criteria;  ///< by name; omitted if empty
  std::vector<Sensitivity> sensitivities;     ///< omitted if empty
};

/// What a contact did beyond carrying a force, as the rest of a sentence that begins with its name: "is open from t = 3
/// on", "opens in every cycle". Empty: nothing. @param time  how a time is written
std::string opening_text(const Summary& summary, const Summary::Contact& contact,
                         const std::function<std::string(double)>& time);

/// What write_summary() writes: JSON.
std::string summary_text(const Summary& summary);
/// Replaces the file atomically. Cost: small; may be called at every output time.
/// @throws Error if the disk cannot take it
void write_summary(const std::filesystem::path& path, const Summary& summary);

/// Reads what write_summary() writes. A value that was not finite is read as 0; entries that other versions do not have
/// keep their defaults.
/// @returns nullopt if the file does not exist or is not a summary
std::optional<Summary> read_summary(const std::filesystem::path& path);
/// Like read_summary(), from text.
std::optional<Summary> parse_summary(std::string_view text);

/// Names and units of a run; empty if the file does not have them.
struct SummaryHeading {
  std::string title, units, status;
  std::map<std::string, SummaryProbe> probes;  ///< by name
  std::map<std::string, double> events = {};   ///< those that happened: time by name
};

/// @throws ConfigError if the file cannot be read or is not a JSON object
SummaryHeading read_summary_heading(const std::filesystem::path& path);
/// Like read_summary_heading(), from text. @param name  name of the file, for messages
SummaryHeading parse_summary_heading(std::string_view text, const std::string& name);

}  // namespace creepcontact::io
