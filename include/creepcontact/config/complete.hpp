#pragma once
/// What the reader of files adds to what they say, for configurations that are made in code.

#include "creepcontact/config/config.hpp"
#include "creepcontact/config/vocabulary.hpp"

namespace creepcontact::config {

/// Adds what follows from other keys: names of contacts, 0 and the end and the times of fields to the output times, the
/// directory of results, constants of laws that are not given, in the order of the law, reductions of areas and forces,
/// and y as the axis in axisymmetric models where it is [0, 0, 1], the default. Changes nothing in a configuration that
/// is complete, as those that have been read are.
/// @throws std::invalid_argument for a law that the vocabulary does not have, or a constant that its law does not have
void complete(Config& config, const Vocabulary& vocabulary);

}  // namespace creepcontact::config
