#pragma once
/// Values of a deck as the configuration writes them.

#include <string>
#include <utility>
#include <vector>

#include "creepcontact/base/tensor.hpp"
#include "creepcontact/deck/deck.hpp"

namespace creepcontact::deck {

std::string toml_string(const std::string& text);
/// Key of a table: bare where TOML allows it.
std::string toml_key(const std::string& text);
std::string toml_vector(const Vector3& vector);
/// A function of T by its points: a number if there is one alone.
std::string function_of_temperature(const std::vector<std::pair<double, double>>& points);
/// A column of a table over the temperature, which is the column `of_temperature`; what is missing is 0.
std::string function_of_temperature(const Table& table, std::size_t column, std::size_t of_temperature);
/// "file:line: ", or nothing
std::string prefix(const Place& at);

}  // namespace creepcontact::deck
