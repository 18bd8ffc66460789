#pragma once
/// The names that configurations may use, gathered from the registries.

#include "creepcontact/config/vocabulary.hpp"

namespace creepcontact::run {

config::Vocabulary vocabulary();

}  // namespace creepcontact::run
