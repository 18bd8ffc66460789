#pragma once
/// Criteria: what a run is judged by, at the end of every step.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "creepcontact/config/config.hpp"
#include "creepcontact/creep/equilibrium_solver.hpp"
#include "creepcontact/io/tables/summary.hpp"
#include "creepcontact/model/model.hpp"
#include "creepcontact/results/probes.hpp"

namespace creepcontact::results {

/// found/allowed of a maximum and allowed/found of a minimum, for any signs: above 1 the limit is passed, 0 is far from
/// it, infinite beyond a limit of 0 or on its wrong side.
double utilisation(double found, double allowed, bool is_minimum);

/// What a criterion finds in one state.
struct Finding {
  double found = 0, allowed = 0, utilisation = 0;
  int body = -1;  ///< number of the body that has the place; -1: there is none
  Vector3 position = Vector3::Zero();

  static constexpr std::size_t n_numbers = 7;
  void append_to(std::vector<double>& numbers) const;
  static Finding from(std::span<const double, n_numbers> numbers);
};

/// One criterion; evaluated in process 0 alone.
class CriterionMeasure {
 public:
  virtual ~CriterionMeasure() = default;
  /// nullopt: it has no value in this state.
  virtual std::optional<Finding> in(Snapshot& snapshot) const = 0;
};

/// Judges the criteria and keeps the states that are closest to their limits.
class CriteriaWatch {
 public:
  /// @param model, probes  of the configuration; they must outlive the object
  /// @throws ModelError if a path is not in its body
  CriteriaWatch(const config::Config& config, const model::Model& model,
                std::span<const std::unique_ptr<Probe>> probes);
  ~CriteriaWatch();

  std::size_t n_criteria() const { return criteria_.size(); }
  /// Numbers for judge(): Finding::n_numbers of each criterion that counts at this time, NaN of the others. In process
  /// 0.
  std::vector<double> findings(Snapshot& snapshot) const;
  /// Findings of one criterion, whatever the time.
  std::vector<double> findings_of(std::size_t criterion, Snapshot& snapshot) const;
  /// Keeps what is closer to a limit than what was found before.
  void judge(double time, std::span<const double> findings);

  /// Times between the ends of steps at which something has to be judged: where a criterion begins or ends to count, or
  /// its limit jumps. Numbers of those that have come at a time and have not been passed.
  std::vector<std::size_t> due(double time) const;
  bool is_due(std::size_t edge, double time) const { return time >= edges_[edge].time; }
  std::size_t criterion_of(std::size_t edge) const { return edges_[edge].criterion; }
  void pass(std::size_t edge) { edges_[edge].is_passed = true; }

  void fill(io::Summary& summary) const;
  void save(creep::Memory& memory) const;
  /// Does nothing if the memory has another number of criteria.
  void restore(const creep::Memory& memory);

 private:
  struct Edge {
    double time = 0;
    std::size_t criterion = 0;
    bool is_passed = false;
  };
  bool counts(std::size_t criterion, double time) const;

  const std::vector<config::Criterion>& criteria_;
  std::vector<std::string> bodies_;
  std::vector<std::unique_ptr<CriterionMeasure>> measures_;
  std::vector<Edge> edges_;
  std::vector<double> worst_;  // Finding::n_numbers and the time of each; NaN: none yet
  std::vector<std::string> demands_, units_;
};

/// "criterion 'tight': met: 14.2 MPa found, at least 12 MPa (85 %) at t = 1e+05"
std::string criterion_line(const std::string& name, const io::Summary::Criterion& criterion);

}  // namespace creepcontact::results
