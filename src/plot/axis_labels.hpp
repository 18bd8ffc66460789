#pragma once
/// What the axes of plots are called.

#include <optional>
#include <string>

#include "creepcontact/base/units.hpp"
#include "creepcontact/io/tables/summary.hpp"

namespace creepcontact::plot {

/// What is on an axis: "stress", and its dimension. The kinds of one dimension share an axis, but for those that have
/// none (strain, damage), which are different things.
struct QuantityKind {
  std::string name;
  Dimension dimension = Dimension::none;
  std::optional<std::string> unit = {};  ///< of these values; nullopt: that of the dimension
};

/// A quantity that is not known has the kind "value". Stress over a surface is a force, other integrals have no unit
/// here.
/// @param units  of the run
QuantityKind kind_of(const io::SummaryProbe& probe, const std::string& units);

/// "stress (MPa)", or the name alone if the unit is not known.
std::string labelled(const std::string& name, Dimension dimension, const std::string& units);
/// "stress (MPa)" with this unit, or the name alone if it is empty.
std::string with_unit(const std::string& name, const std::string& unit);

}  // namespace creepcontact::plot
