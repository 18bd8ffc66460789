#pragma once
/// From materials of a configuration to those of a model.

#include <memory>

#include "creepcontact/config/config.hpp"
#include "creepcontact/material/life_fraction.hpp"
#include "creepcontact/material/material.hpp"

namespace creepcontact::model {

material::Material make_material(const config::Material& material);
std::shared_ptr<const material::RuptureData> rupture_data(const config::Rupture& rupture);

}  // namespace creepcontact::model
