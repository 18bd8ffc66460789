#pragma once
/// summary.json: how a run went and what it cost.

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace creepcontact::io {

/// What a column of history.csv shows.
struct SummaryProbe {
  std::string quantity;
  std::string integrated_over;  ///< "surface" or "body" if its values are sums, empty else
  bool operator==(const SummaryProbe&) const = default;
};

/// The members carry the names they have in the file.
struct Summary {
  enum class Status { completed, ruptured, failed, interrupted };
  struct Body {
    std::int64_t dofs = 0, elements = 0, integration_points = 0;
  };
  struct Largest {
    double value = 0;
    std::array<double, 3> place{};
  };
  struct Rupture {
    double time = 0;
    std::string body;
    Largest damage;
  };
  struct Contact {
    double largest_force = 0, final_force = 0;  ///< normal force, at output times
  };
  struct WallSeconds {
    double total = 0, factorize = 0, solve = 0, material = 0, contact = 0, output = 0;
  };

  Status status = Status::completed;
  std::string message;  ///< written only if not empty
  std::string title, units, version;
  std::string integrator;
  std::string method;  ///< at work at the end: another name than `integrator` if that one chooses; written if not empty
  double time_reached = 0;
  std::int64_t steps = 0, rejected_steps = 0, convergence_failures = 0;
  std::int64_t rhs_evaluations = 0, jacobian_products = 0;
  std::int64_t elastic_solves = 0;  ///< one = one forward and backward pass through the factor of every body
  std::int64_t contact_solves = 0, schwarz_iterations = 0;
  std::int64_t factorizations = 0;
  std::map<std::string, Body> bodies;
  std::map<std::string, Largest> damage, life_fraction;  ///< by body, where its material knows them
  std::optional<Rupture> rupture;
  std::map<std::string, Contact> contacts;  ///< unilateral ones, by name
  WallSeconds wall_seconds;
  double peak_memory_mb = 0;
  std::map<std::string, SummaryProbe> probes;  ///< by name; written if there are any
};

/// Replaces the file as a whole. Cost: small; may be called at every output time.
/// @throws Error if the disk does not take it
void write_summary(const std::filesystem::path& path, const Summary& summary);

/// How a run went: status, message, version, time reached, steps (rejected and failed ones too), elastic solves,
/// Schwarz iterations and the total wall time; nothing else is read.
/// @returns nullopt if the file is not there or is no summary
std::optional<Summary> read_summary(const std::filesystem::path& path);
/// As read_summary(), from the text of the file.
std::optional<Summary> parse_summary(std::string_view text);

/// What names and units a run had. What the file does not tell is empty.
struct SummaryHeading {
  std::string title, units, status;
  std::map<std::string, SummaryProbe> probes;  ///< by name
};

/// @throws ConfigError if the file cannot be read or is no JSON object
SummaryHeading read_summary_heading(const std::filesystem::path& path);
/// As read_summary_heading(), from the text of the file. @param name  of the file, for messages
SummaryHeading parse_summary_heading(std::string_view text, const std::string& name);

}  // namespace creepcontact::io
