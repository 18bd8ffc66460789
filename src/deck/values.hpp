#pragma once
/// Values of a deck as the configuration has them.

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/base/tensor.hpp"
#include "creepcontact/deck/deck.hpp"

namespace creepcontact::deck {

/// The number with 15 digits: the last ones of a sum such as 0.1 + 0.2 are left out.
double rounded(double number);
std::array<double, 3> rounded(const Vector3& vector);
/// A function of T by its points: a number if there is one alone.
Function function_of_temperature(const std::vector<std::pair<double, double>>& points);
/// A column of a table over the temperature, which is the column `of_temperature`; what is missing is 0.
Function function_of_temperature(const Table& table, std::size_t column, std::size_t of_temperature);
/// Whether each value is above the one before.
bool is_increasing(const std::vector<double>& values);
/// "file:line: ", or nothing
std::string prefix(const Place& at);

}  // namespace creepcontact::deck
