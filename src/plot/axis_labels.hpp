#pragma once
/// What the axes of plots are called.

#include <string>

#include "creepcontact/base/units.hpp"
#include "creepcontact/io/summary.hpp"

namespace creepcontact::plot {

/// What is on an axis: "stress", and its dimension. The kinds of one dimension share an axis, but for those that have
/// none (strain, damage), which are different things.
struct QuantityKind {
  std::string name;
  Dimension dimension = Dimension::none;
};

/// A quantity that is not known has the kind "value". Stress over a surface is a force, other integrals have no unit
/// here.
QuantityKind kind_of(const io::SummaryProbe& probe);

/// "stress (MPa)", or the name alone if the unit is not known.
std::string labelled(const std::string& name, Dimension dimension, const std::string& units);

}  // namespace creepcontact::plot
