#include "axis_labels.hpp"

namespace creepcontact::plot {

QuantityKind kind_of(const io::SummaryProbe& probe) {
  if (probe.label.empty()) return {"value", Dimension::none};
  const Dimension dimension = dimension_of(probe.dimension);
  const bool is_total = dimension == Dimension::force || dimension == Dimension::area;
  if (probe.integrated_over.empty() || is_total) return {probe.label, dimension};
  if (dimension == Dimension::stress && probe.integrated_over == "surface") return {"force", Dimension::force};
  return {probe.label + ", sum", Dimension::none};
}

std::string labelled(const std::string& name, Dimension dimension, const std::string& units) {
  const std::string unit = unit_of(dimension, units);
  return unit.empty() ? name : name + " (" + unit + ")";
}

}  // namespace creepcontact::plot
