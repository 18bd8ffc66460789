#pragma once
/// Units of the quantities, as far as the words of `units` in the configuration tell them.

#include <string>

#include "creepcontact/io/summary.hpp"

namespace creepcontact::plot {

enum class Dimension { none, time, length, area, force, stress, temperature };

/// What is on an axis: "stress", and its dimension. The kinds of one dimension share an axis, but for those that have
/// none (strain, damage), which are different things.
struct QuantityKind {
  std::string name;
  Dimension dimension = Dimension::none;
};

/// A quantity that is not known has the kind "value". Stress over a surface is a force, other integrals have no unit
/// here.
QuantityKind kind_of(const io::SummaryProbe& probe);

/// "stress" for all its kinds.
std::string name_of(Dimension dimension);

/// The unit of a dimension in a list such as "mm, N, MPa, h, degC"; empty if the list has none for it.
std::string unit_of(Dimension dimension, const std::string& units);

/// "stress (MPa)", or the name alone if the unit is not known.
std::string labelled(const std::string& name, Dimension dimension, const std::string& units);

}  // namespace creepcontact::plot
