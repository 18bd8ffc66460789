#pragma once
/// Creep against fatigue: what bodies have used, and the limits of their materials.

#include <optional>
#include <string>
#include <vector>

#include "creepcontact/io/tables/csv_table.hpp"
#include "creepcontact/io/tables/model_record.hpp"
#include "creepcontact/plot/figure.hpp"

namespace creepcontact::report {

/// The largest shares of each body after every cycle, from the start on, and the limits as far as they are near: from
/// (creep 0, fatigue 1) through the points of the configuration to (1, 0), a line for each material with fatigue data.
/// @param cycles  cycles.csv @returns nullopt if no body has both shares
std::optional<plot::Figure> interaction_figure(const std::vector<std::string>& bodies, const io::CsvTable& cycles,
                                               const std::vector<io::RecordedInput>& inputs);

}  // namespace creepcontact::report
