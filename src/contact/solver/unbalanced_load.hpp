#pragma once
/// Can contact pressures balance the loads at all?

#include "creepcontact/contact/solver/problem.hpp"

namespace creepcontact::contact {

/// Looks for the pressures (>= 0; any sign on tied rows) whose resultants come nearest to those of the loads:
/// non-negative least squares (Lawson and Hanson 1974). What is left is, by Farkas' lemma, a motion that opens no
/// contact and along which the loads do work. @throws UnbalancedLoad with that motion, the largest amplitude 1
void throw_if_unbalanced(const ContactProblem& problem, const ContactLoad& load);

}  // namespace creepcontact::contact
