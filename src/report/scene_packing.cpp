#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <nlohmann/json.hpp>
#include <span>

#include "creepcontact/base/base64.hpp"
#include "scene.hpp"

namespace creepcontact::report {
namespace {

constexpr std::uint16_t no_value = 65535;

struct FloatRange {
  float low = std::numeric_limits<float>::infinity(), high = -low;
};

FloatRange range_of(const std::vector<std::vector<float>>& values) {
  FloatRange range;
  for (const std::vector<float>& at_time : values)
    for (const float value : at_time)
      if (std::isfinite(value)) range = {std::min(range.low, value), std::max(range.high, value)};
  return range.low <= range.high ? range : FloatRange{0, 0};
}

float largest_of(const std::vector<std::vector<float>>& displacements) {
  const FloatRange range = range_of(displacements);
  return std::max(std::abs(range.low), std::abs(range.high));
}

/// Blocks of numbers one after the other, each at a multiple of four bytes.
class Bytes {
 public:
  template <typename Number>
  void add(std::span<const Number> numbers) {
    const auto* first = reinterpret_cast<const char*>(numbers.data());
    bytes_.append(first, numbers.size_bytes());
  }
  void end_block() { bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0'); }

  std::string compressed() const {
    uLongf length = ::compressBound(bytes_.size());
    std::string result(length, '\0');
    if (::compress2(reinterpret_cast<Bytef*>(result.data()), &length, reinterpret_cast<const Bytef*>(bytes_.data()),
                    bytes_.size(), 6) != Z_OK)
      throw std::bad_alloc();  // zlib knows no other failure here
    result.resize(length);
    return result;
  }

 private:
  std::string bytes_;
};

std::vector<std::int16_t> displacement_codes(const std::vector<float>& values, float largest) {
  std::vector<std::int16_t> codes(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    codes[i] = largest > 0 && std::isfinite(values[i])
                   ? static_cast<std::int16_t>(std::lround(values[i] / largest * 32767))
                   : std::int16_t{0};
  return codes;
}

std::vector<std::uint16_t> codes(const std::vector<float>& values, const FloatRange& range) {
  const double span = static_cast<double>(range.high) - static_cast<double>(range.low);
  std::vector<std::uint16_t> codes(values.size(), no_value);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isfinite(values[i]))
      codes[i] = static_cast<std::uint16_t>(
          span > 0 ? std::lround((static_cast<double>(values[i]) - static_cast<double>(range.low)) / span * 65534) : 0);
  return codes;
}

}  // namespace

std::string without_tags(const std::string& json) {
  std::string text;
  for (const char c : json)
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  return text;
}

PackedScene packed(const Scene& scene) {
  const float largest = largest_of(scene.displacements);
  nlohmann::ordered_json header{{"title", scene.title},
                                {"times", scene.times},
                                {"time_unit", scene.time_unit},
                                {"length_unit", scene.length_unit},
                                {"flat", scene.flat},
                                {"model", scene.is_model},
                                {"warp", suggested_warp(scene)},
                                {"begin",
                                 {{"field", scene.fields.empty() ? "" : scene.fields.front().name},
                                  {"time", scene.times.empty() ? 0 : scene.times.size() - 1}}},
                                {"bodies", nlohmann::ordered_json::array()},
                                {"surface_points", scene.n_surface},
                                {"inner_points", scene.n_points() - scene.n_surface},
                                {"fields", nlohmann::ordered_json::array()},
                                {"largest_displacement", largest},
                                {"has_tetrahedra", !scene.tetrahedra.empty()},
                                {"note", scene.note}};
  for (const SceneBody& body : scene.bodies)
    header["bodies"].push_back({{"name", body.name},
                                {"triangles", {body.first_triangle, body.n_triangles}},
                                {"edges", {body.first_edge, body.n_edges}},
                                {"tetrahedra", {body.first_tetrahedron, body.n_tetrahedra}}});

  Bytes bytes;
  bytes.add(std::span(scene.positions));
  bytes.add(std::span(scene.triangles));
  bytes.add(std::span(scene.edges));
  bytes.add(std::span(scene.tetrahedra));
  for (std::size_t t = 0; t < scene.times.size(); ++t) {
    const std::vector<float> none(scene.positions.size(), 0.0F);
    const auto codes = displacement_codes(scene.displacements.empty() ? none : scene.displacements[t], largest);
    bytes.add(std::span(codes));
  }
  bytes.end_block();
  for (std::size_t f = 0; f < scene.fields.size(); ++f) {
    const FloatRange range = range_of(scene.values[f]);
    const Field& field = scene.fields[f];
    header["fields"].push_back({{"name", field.name},
                                {"label", field.label},
                                {"unit", field.unit},
                                {"min", range.low},
                                {"max", range.high},
                                {"on_contact", field.is_on_contact}});
    for (const std::vector<float>& at_time : scene.values[f]) {
      const auto numbers = codes(at_time, range);
      bytes.add(std::span<const std::uint16_t>(numbers));
    }
  }
  bytes.end_block();
  return {without_tags(header.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)),
          base64(bytes.compressed())};
}

}  // namespace creepcontact::report
