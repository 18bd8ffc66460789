#pragma once
/// The names that configurations may use, collected from the registries.

#include "creepcontact/config/vocabulary.hpp"

namespace creepcontact::run {

/// Laws, integrators and quantities known to the program.
config::Vocabulary vocabulary();

}  // namespace creepcontact::run
