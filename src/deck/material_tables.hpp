#pragma once
/// Thermal expansion and creep, which materials and gaskets have.

#include <optional>

#include "draft.hpp"

namespace creepcontact::deck {

/// The thermal expansion along all axes; nullopt if there is none, or no temperature changes.
std::optional<Function> expansion_of(Draft& draft, const Material& material);
/// Adds the law of *CREEP, if there is one. Without *VISCO steps nothing creeps: that is among what is left out.
/// @param what_is_left  then: "material is elastic" @param key  of the material or the gasket
void make_creep(Draft& draft, const Material& material, const std::string& what_is_left,
                std::vector<config::CreepMechanism>& creep, const std::string& key);

/// Temperatures of a table must increase. @returns whether they do; else the model is impossible
bool is_in_order(Draft& draft, const char* card, const Table& table, std::size_t of_temperature);

}  // namespace creepcontact::deck
