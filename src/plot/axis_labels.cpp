#include "axis_labels.hpp"

namespace creepcontact::plot {

namespace {

QuantityKind without_unit(const io::SummaryProbe& probe) {
  if (probe.label.empty()) return {"value", Dimension::none};
  const Dimension dimension = probe.dimension;
  const bool is_total = dimension == Dimension::force || dimension == Dimension::area || dimension == Dimension::moment;
  if (probe.integrated_over.empty() || is_total) return {probe.label, dimension};
  if (dimension == Dimension::stress && probe.integrated_over == "surface") return {"force", Dimension::force};
  return {probe.label + ", sum", Dimension::none};
}

}  // namespace

QuantityKind kind_of(const io::SummaryProbe& probe, const std::string& units) {
  QuantityKind kind = without_unit(probe);
  if (!probe.unit || *probe.unit == unit_of(kind.dimension, units)) return kind;
  // Values in another unit are not to share an axis with those in that of the run.
  kind.unit = probe.unit;
  using enum Dimension;
  if (kind.dimension == none && !probe.unit->empty())
    for (const Dimension dimension : {time, length, area, force, moment, energy, stress, temperature})
      if (unit_of(dimension, units) == *probe.unit) return {kind.name, dimension};
  return kind;
}

std::string labelled(const std::string& name, Dimension dimension, const std::string& units) {
  return with_unit(name, unit_of(dimension, units));
}

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " (" + unit + ")";
}

}  // namespace creepcontact::plot
