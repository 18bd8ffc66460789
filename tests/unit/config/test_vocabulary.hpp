#pragma once
/// Some laws, integrators and quantities, for configurations of tests.

#include "creepcontact/config/vocabulary.hpp"

namespace creepcontact::config {

Vocabulary test_vocabulary();

}  // namespace creepcontact::config
