#pragma once
/// The search for events in time in every function of the configuration.

#include <optional>
#include <string>
#include <vector>

#include "course_events.hpp"
#include "model_parts.hpp"

namespace creepcontact::model {

/// A function that changes in time: directly, or because the temperature does.
struct SearchedFunction {
  std::string key;              ///< the first that has it
  std::vector<Course> courses;  ///< at places that represent all others; one at least
  /// Events of all courses, with limits where turns are missing. Empty for a table in t, which knows its own points.
  CourseEvents events;
  /// Where the temperature of a place passes a point of a table in T, or a kink or jump of an expression in T.
  std::vector<double> passages;
};

/// Every function of config.functions that changes in time, functions with the same text and places once.
///
/// Places: where it acts (KeyPlaces). A function that does not depend on the place is searched at one. Otherwise at a
/// dozen that lie far from each other, and at those where samples at all places show changes that the ones searched so
/// far do not explain. Temperature: the field's there. Stress and creep strain: several levels of elastic strain and of
/// creep strain. Cost: about 40 000 evaluations per place, at most some millions in all.
///
/// Warns of functions with more jumps and kinks than can be found, and of vibrations that no bound on steps resolves.
std::vector<SearchedFunction> search_functions(const config::Config& config, const Bodies& bodies,
                                               const std::optional<mechanics::TemperatureField>& temperature);

}  // namespace creepcontact::model
