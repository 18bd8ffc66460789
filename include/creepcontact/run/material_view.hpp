#pragma once
/// All variants of a steel of the material library side by side, for users who choose one.

#include <optional>
#include <string>
#include <vector>

#include "creepcontact/plot/run_plots.hpp"

namespace creepcontact::run {

struct MaterialViewOptions {
  std::optional<double> temperature;  ///< in the unit of the library file; not given: that of the first check
  std::string variant;                ///< empty: all
};

struct MaterialView {
  std::string text;                        ///< a table for a terminal
  std::vector<plot::NamedFigure> figures;  ///< none if there is nothing to draw
};

/// Bars at constant temperature in the units of the library file: creep at three stresses, relaxation, isochronous
/// curves, rupture strength. The largest stress is that of 1 % creep after 1000 h by the first variant that creeps, or
/// of rupture then.
/// @param name  of the steel: its key or another name
/// @throws ConfigError if there is no such steel or variant
MaterialView material_view(const std::string& name, const MaterialViewOptions& options);

}  // namespace creepcontact::run
