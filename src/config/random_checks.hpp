#pragma once
/// Whether a configuration can have what its random keys may become.

#include "creepcontact/config/study.hpp"
#include "diagnostics.hpp"

namespace creepcontact::config {

/// The override of a sampled value; its place is that of the key.
Setting sampled_setting(const RandomKey& key, double value);

/// Reads the configuration of a combination of the axes with each key at the ends of its distribution, the others at
/// their medians. @param settings  of the combination. Cost: two readings per key
void check_random_keys(const Study& study, const std::vector<Setting>& settings, const Vocabulary& vocabulary,
                       Diagnostics& errors);

}  // namespace creepcontact::config
