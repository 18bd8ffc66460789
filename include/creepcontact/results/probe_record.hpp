#pragma once
/// The course of all probes over a run.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "creepcontact/config/config.hpp"
#include "creepcontact/creep/equilibrium_solver.hpp"
#include "creepcontact/io/tables/summary.hpp"

namespace creepcontact::results {

class ProbeRecord {
 public:
  explicit ProbeRecord(std::size_t n_probes) : courses_(n_probes) {}

  /// An output time; they come in increasing order. @param values  one per probe
  void output(double time, std::span<const double> values);

  /// A state between two output times, which counts for the extremes. The values may have the error of a time step:
  /// they count where they go beyond those known by more than the tolerance.
  /// @param tolerance  relative to the largest magnitude so far @param values  one per probe, or none
  void observe(double time, std::span<const double> values, double tolerance);

  /// The unit of the values of a probe as a word; empty if it has none or it is not known.
  static std::string unit_of(const config::Probe& probe, const std::string& units);

  /// What the probes of the configuration are, and their courses so far.
  void fill(const config::Config& config, io::Summary& summary) const;
  void save(creep::Memory& memory) const;
  /// Does nothing if the memory has another number of probes.
  void restore(const creep::Memory& memory);

 private:
  std::vector<std::optional<io::SummaryProbe::Course>> courses_;
};

}  // namespace creepcontact::results
