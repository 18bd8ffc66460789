#pragma once
/// The names that configurations may use, gathered from the registries.

#include <string>

#include "creepcontact/config/vocabulary.hpp"

namespace creepcontact::simulation {

config::Vocabulary vocabulary();

/// A table for people. @param what  integrators, laws, elements or quantities
/// @throws ConfigError for anything else
std::string list(const std::string& what);

}  // namespace creepcontact::simulation
