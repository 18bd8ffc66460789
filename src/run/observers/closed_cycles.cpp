#include "closed_cycles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace creepcontact::run {
namespace {
const std::string closed_cycles_name = "closed_cycles";
}

ClosedCycles::ClosedCycles(std::size_t n_bodies) : used_up_(n_bodies, std::numeric_limits<double>::infinity()) {}

void ClosedCycles::keep_used_lives(CycleRecord& record, std::int64_t cycle, std::int64_t jumped) {
  for (std::size_t b = 0; b < record.bodies.size(); ++b) {
    CycleRecord::Body& body = record.bodies[b];
    if (std::isfinite(used_up_[b])) {
      body.limit = used_up_[b];
      continue;
    }
    if (body.life.empty() || body.life.back().largest < 1) continue;
    used_up_[b] = body.limit =
        std::clamp(body.limit, static_cast<double>(cycle - jumped), static_cast<double>(cycle + 1));
  }
}

std::optional<double> ClosedCycles::change(const CycleRecord& record, std::int64_t cycle) const {
  if (last_ < 0) return std::nullopt;
  const auto n_cycles = static_cast<double>(cycle - last_);
  double change = record.stress_change;
  for (std::size_t i = 0; i < record.probes.size(); ++i) {
    const CycleRecord::Probe& probe = record.probes[i];
    const double size = std::max(std::abs(probe.min), std::abs(probe.max));
    if (size > 0) change = std::max(change, std::abs(probe.range() - probe_ranges_[i]) / n_cycles / size);
  }
  return change;
}

void ClosedCycles::add(const CycleRecord& record, std::int64_t cycle) {
  last_ = cycle;
  probe_ranges_.clear();
  for (const CycleRecord::Probe& probe : record.probes) probe_ranges_.push_back(probe.range());
}

void ClosedCycles::save(Memory& memory) const {
  memory.save(closed_cycles_name, *this, saved_members);
}

void ClosedCycles::restore(const Memory& memory, std::size_t n_probes) {
  memory.restore(closed_cycles_name, *this, saved_members);
  if (probe_ranges_.size() != n_probes) forget_last();
}

}  // namespace creepcontact::run
