#include "creepcontact/io/fields/frd_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <span>
#include <stdexcept>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/platform/replace_file.hpp"

namespace creepcontact::io {
namespace {

using mesh::CellType;

constexpr std::string_view end_of_file = " 9999\n", end_of_block = " -3\n";

/// Number of the element type, and the places in Gmsh's order of its nodes.
struct FrdElement {
  int type = 0;
  std::span<const int> order;
};

FrdElement frd_element(CellType cell) {
  static constexpr std::array same{0, 1, 2, 3, 4, 5, 6, 7};
  static constexpr std::array hex20{0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 13, 9, 10, 12, 14, 15, 16, 18, 19, 17};
  static constexpr std::array wedge15{0, 1, 2, 3, 4, 5, 6, 9, 7, 8, 10, 11, 12, 14, 13};
  static constexpr std::array tet10{0, 1, 2, 3, 4, 5, 6, 7, 9, 8};
  switch (cell) {
    case CellType::hex8:
      return {1, same};
    case CellType::wedge6:
      return {2, std::span(same).first(6)};
    case CellType::tet4:
      return {3, std::span(same).first(4)};
    case CellType::hex20:
    case CellType::hex27:
      return {4, hex20};
    case CellType::wedge15:
      return {5, wedge15};
    case CellType::tet10:
      return {6, tet10};
    case CellType::tri3:
      return {7, std::span(same).first(3)};
    case CellType::tri6:
      return {8, std::span(same).first(6)};
    case CellType::quad4:
      return {9, std::span(same).first(4)};
    default:
      return {10, same};
  }
}

/// Twelve columns: of an exponent with three digits nothing is left but 0.
std::string real(double value) {
  constexpr double min_magnitude = 1e-99;
  if (!(std::abs(value) > min_magnitude)) return " 0.00000E+00";
  return fmt::format("{:12.5E}", std::clamp(value, -9.99999e99, 9.99999e99));
}

/// Length of the beginning of a file that holds whole results up to last_time; 0 if it holds no mesh.
/// @param n_steps  their number
std::size_t kept_length(const std::string& text, double last_time, int& n_steps) {
  constexpr double rounding = 1e-6;  // of the times in the file
  const std::string_view all = text;
  std::size_t kept = 0, begin = 0;
  int n_blocks = 0;
  bool is_later = false;
  while (begin < text.size()) {
    const std::size_t end = text.find('\n', begin);
    if (end == std::string::npos) break;
    const std::string_view line = all.substr(begin, end + 1 - begin);
    if (line.starts_with("  100C") && line.size() > 24) {
      const double time = std::strtod(std::string(line.substr(12, 12)).c_str(), nullptr);
      if (time > last_time + rounding * std::abs(last_time)) is_later = true;
      if (!is_later && line.size() > 63) n_steps = std::atoi(std::string(line.substr(58, 5)).c_str());
    }
    if (is_later) break;
    begin = end + 1;
    if (line == end_of_block && ++n_blocks >= 2) kept = begin;
  }
  return kept;
}

}  // namespace

FrdWriter::FrdWriter(std::filesystem::path path, const std::vector<const mesh::Mesh*>& bodies,
                     Continuation continuation)
    : path_(std::move(path)) {
  number_nodes(bodies);
  if (continuation.resume) {
    std::ifstream stream(path_, std::ios::binary);
    const std::string text = stream ? std::string(std::istreambuf_iterator<char>(stream), {}) : "";
    const std::size_t kept = kept_length(text, continuation.last_time, n_steps_);
    if (kept > 0) {
      platform::replace_file(path_, text.substr(0, kept) + std::string(end_of_file));
      open();
      return;
    }
    log::warning("'{}' of the interrupted run is missing or empty; its results up to t = {:.6g} are lost",
                 path_.string(), continuation.last_time);
  }
  platform::replace_file(path_, mesh_text(bodies) + std::string(end_of_file));
  open();
}

void FrdWriter::open() {
  file_.reset(platform::reopen_stream(path_, false));
  if (!file_) throw ConfigError(fmt::format("cannot write '{}': {}", path_.string(), platform::write_failure(errno)));
}

void FrdWriter::number_nodes(const std::vector<const mesh::Mesh*>& bodies) {
  std::vector<std::int64_t> all;
  for (const mesh::Mesh* body : bodies)
    for (std::size_t i = 0; i < body->n_cell_nodes(); ++i)
      all.push_back(body->node_numbers.empty() ? std::ssize(all) + 1 : body->node_numbers[i]);
  numbers_ = all;
  std::ranges::sort(numbers_);
  numbers_.erase(std::unique(numbers_.begin(), numbers_.end()), numbers_.end());
  for (const std::int64_t number : all)
    place_.push_back(static_cast<std::size_t>(std::ranges::lower_bound(numbers_, number) - numbers_.begin()));
}

std::string FrdWriter::mesh_text(const std::vector<const mesh::Mesh*>& bodies) const {
  std::vector<Vector3> positions(numbers_.size());
  std::size_t first = 0, n_elements = 0;
  for (const mesh::Mesh* body : bodies) {
    for (std::size_t i = 0; i < body->n_cell_nodes(); ++i) positions[place_[first + i]] = body->nodes[i];
    first += body->n_cell_nodes();
    for (const mesh::CellBlock& block : body->blocks)
      if (body->is_bulk(block.type)) n_elements += block.size();
  }
  std::string text = fmt::format("    1Ccreepcontact\n    1UPGM               creepcontact\n    2C{:18}{:12}{:37}1\n",
                                 "", numbers_.size(), "");
  for (std::size_t i = 0; i < numbers_.size(); ++i)
    text += fmt::format(" -1{:10}{}{}{}\n", numbers_[i], real(positions[i][0]), real(positions[i][1]),
                        real(positions[i][2]));
  text += end_of_block;
  text += fmt::format("    3C{:18}{:12}{:37}1\n", "", n_elements, "");
  first = 0;
  std::size_t counted = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (const mesh::CellBlock& block : bodies[b]->blocks) {
      if (!bodies[b]->is_bulk(block.type)) continue;
      const FrdElement element = frd_element(block.type);
      for (std::size_t e = 0; e < block.size(); ++e) {
        ++counted;
        const std::int64_t number = block.numbers.empty() ? static_cast<std::int64_t>(counted) : block.numbers[e];
        text += fmt::format(" -1{:10}{:5}{:5}{:5}", number, element.type, 0, b + 1);
        for (std::size_t k = 0; k < element.order.size(); ++k) {
          if (k % 10 == 0) text += "\n -2";
          const auto node = static_cast<std::size_t>(block.cell(e)[static_cast<std::size_t>(element.order[k])]);
          text += fmt::format("{:10}", numbers_[place_[first + node]]);
        }
        text += '\n';
      }
    }
    first += bodies[b]->n_cell_nodes();
  }
  return text + std::string(end_of_block);
}

void FrdWriter::append(const FrdField& field, double time, std::string& text) const {
  const std::size_t width = field.components.size();
  if (field.values.size() != width * place_.size())
    throw std::invalid_argument(
        fmt::format("frd: '{}' has {} values for {} nodes", field.name, field.values.size(), place_.size()));
  std::vector<double> sums(width * numbers_.size(), 0.0);
  std::vector<int> counts(numbers_.size(), 0);
  for (std::size_t i = 0; i < place_.size(); ++i) {
    const std::span row(field.values.data() + width * i, width);
    if (std::ranges::all_of(row, [](double value) { return std::isnan(value); })) continue;
    ++counts[place_[i]];
    for (std::size_t k = 0; k < width; ++k) sums[width * place_[i] + k] += std::isnan(row[k]) ? 0 : row[k];
  }
  const auto n = std::ranges::count_if(counts, [](int count) { return count > 0; });
  text += fmt::format("    1PSTEP{:26}{:12}{:12}\n", n_steps_, 1, 1);
  text +=
      fmt::format("  100CL{:5}{:12.7g}{:12}{:20}{:2}{:5}{:10}{:2}\n", 100 + n_steps_, time, n, "", 0, n_steps_, "", 1);
  text += fmt::format(" -4  {:<8}{:5}{:5}\n", field.name, width + (field.kind == FrdField::Kind::vector ? 1 : 0), 1);
  constexpr std::array<std::array<int, 2>, 6> tensor_places{{{1, 1}, {2, 2}, {3, 3}, {1, 2}, {2, 3}, {3, 1}}};
  for (std::size_t k = 0; k < width; ++k) {
    const bool is_tensor = field.kind == FrdField::Kind::tensor;
    const int first = is_tensor                              ? tensor_places[k][0]
                      : field.kind == FrdField::Kind::vector ? static_cast<int>(k) + 1
                                                             : 0;
    text += fmt::format(" -5  {:<8}{:5}{:5}{:5}{:5}\n", field.components[k], 1, static_cast<int>(field.kind), first,
                        is_tensor ? tensor_places[k][1] : 0);
  }
  if (field.kind == FrdField::Kind::vector) text += " -5  ALL         1    2    0    0    1ALL\n";
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    if (counts[i] == 0) continue;
    text += fmt::format(" -1{:10}", numbers_[i]);
    for (std::size_t k = 0; k < width; ++k) text += real(sums[width * i + k] / counts[i]);
    text += '\n';
  }
  text += end_of_block;
}

void FrdWriter::write(double time, const std::vector<FrdField>& fields) {
  ++n_steps_;
  std::string text;
  for (const FrdField& field : fields) append(field, time, text);
  put(text);
}

/// Writes over the line that ends the file, and writes that line again after the text.
void FrdWriter::put(const std::string& text) {
  const std::string all = text + std::string(end_of_file);
  const bool written = std::fseek(file_.get(), -static_cast<long>(end_of_file.size()), SEEK_END) == 0 &&
                       std::fwrite(all.data(), 1, all.size(), file_.get()) == all.size() &&
                       std::fflush(file_.get()) == 0;
  if (!written) throw Error(fmt::format("cannot write '{}': {}", path_.string(), platform::write_failure(errno)), 4);
}

}  // namespace creepcontact::io
