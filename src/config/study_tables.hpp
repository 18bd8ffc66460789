#pragma once
/// The tables of a study.

#include "creepcontact/config/study.hpp"
#include "value.hpp"

namespace creepcontact::config {

Value<Study> study_table();

}  // namespace creepcontact::config
