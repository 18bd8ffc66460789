#include "support/run/result_files.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>

namespace creepcontact::test {
namespace {

nlohmann::json::json_pointer position(const std::string& key) {
  return nlohmann::json::json_pointer("/" + key);
}

}  // namespace

Table::Table(const std::filesystem::path& path) : table_(io::read_csv_table(path)) {}

const std::vector<double>& Table::column(const std::string& name) const {
  if (const std::vector<double>* found = table_.column(name)) return *found;
  throw std::out_of_range("no column " + name);
}

double Table::sum(const std::string& name) const {
  const std::vector<double>& values = column(name);
  return std::accumulate(values.begin(), values.end(), 0.0);
}

double Table::at(const std::string& name, double time) const {
  const std::vector<double>& values = column(name);
  for (std::size_t i = 0; i < rows(); ++i)
    if (std::abs(times()[i] - time) <= 1e-9 * std::max(1.0, std::abs(time))) return values[i];
  throw std::out_of_range("no row at t = " + std::to_string(time));
}

SummaryFile::SummaryFile(const std::filesystem::path& path)
    : json_(std::make_shared<nlohmann::json>(nlohmann::json::parse(std::ifstream(path)))) {}

bool SummaryFile::has(const std::string& key) const {
  return json_->contains(position(key));
}

double SummaryFile::number(const std::string& key) const {
  return json_->at(position(key)).get<double>();
}

bool SummaryFile::truth(const std::string& key) const {
  return json_->at(position(key)).get<bool>();
}

std::vector<std::string> SummaryFile::texts(const std::string& key) const {
  return has(key) ? json_->at(position(key)).get<std::vector<std::string>>() : std::vector<std::string>{};
}

std::string SummaryFile::text(const std::string& key) const {
  return json_->at(position(key)).get<std::string>();
}

}  // namespace creepcontact::test
