#pragma once
/// What tells runs from each other.

#include <string>
#include <vector>

#include "creepcontact/io/tables/model_record.hpp"

namespace creepcontact::report {

/// A key of the configuration that has not the same value in all runs.
struct InputDifference {
  std::string key;
  std::vector<std::string> values;  ///< one per run; "-": it does not have the key
};

/// In the order of the keys; none if a run does not record its inputs. Titles and remarks do not count.
std::vector<InputDifference> input_differences(const std::vector<const io::ModelRecord*>& runs);

/// "gap = -0.1" for every run, of the keys that differ; the name of a directory where that does not tell them apart.
/// @param directories  names of the runs, no two alike
std::vector<std::string> labels_by_inputs(const std::vector<InputDifference>& differences,
                                          const std::vector<std::string>& directories);

}  // namespace creepcontact::report
