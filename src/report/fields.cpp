#include "fields.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/suggestion.hpp"

namespace creepcontact::report {
namespace {

constexpr std::array first_ones{"von_mises",
                                "contact_pressure",
                                "displacement_magnitude",
                                "creep_strain_equivalent",
                                "principal_1",
                                "temperature",
                                "damage",
                                "life_fraction",
                                "remaining_life",
                                "contact_shear",
                                "gap",
                                "slip",
                                "contact_status",
                                "stress_theta",
                                "stress_r",
                                "principal_3"};

std::size_t rank(const Field& field) {
  return static_cast<std::size_t>(std::ranges::find(first_ones, field.name) - first_ones.begin());
}

/// "von_mises", "MPa" of "von_mises [MPa]"
std::pair<std::string, std::string> name_and_unit(const std::string& array) {
  const std::size_t begin = array.rfind(" [");
  if (begin == std::string::npos || array.back() != ']') return {array, ""};
  return {array.substr(0, begin), array.substr(begin + 2, array.size() - begin - 3)};
}

/// The components of an array that is not known.
void add_unknown(const io::FieldArray& array, std::vector<Field>& fields) {
  const auto [name, unit] = name_and_unit(array.name);
  static constexpr std::array tensor{"xx", "yy", "zz", "xy", "yz", "zx"}, vector{"x", "y", "z", "", "", ""};
  for (int c = 0; c < array.components; ++c) {
    const auto i = static_cast<std::size_t>(c);
    std::string suffix;
    if (i < array.component_names.size())
      suffix = array.component_names[i];
    else if (array.components == 6)
      suffix = tensor[i];
    else if (array.components == 3)
      suffix = vector[i];
    else if (array.components > 1)
      suffix = std::to_string(c);
    const bool has_suffix = !suffix.empty();
    fields.push_back({fmt::format("{}{}{}", name, has_suffix ? "_" : "", suffix),
                      fmt::format("{}{}{}", name, has_suffix ? " " : "", suffix), unit, array.name, c, false});
  }
}

}  // namespace

std::vector<Field> fields_of(const io::FieldFile& file, const std::vector<io::RecordedField>& known) {
  std::vector<Field> fields;
  for (const io::FieldArray& array : file.point_arrays()) {
    const std::string name = name_and_unit(array.name).first;
    if (name == "body") continue;
    bool is_known = false;
    for (const io::RecordedField& record : known)
      if (record.array == name && record.component < array.components) {
        fields.push_back(record);
        fields.back().array = array.name;
        is_known = true;
      }
    if (!is_known) add_unknown(array, fields);
  }
  std::ranges::stable_sort(fields, {}, rank);
  return fields;
}

std::vector<double> values_of(const Field& field, const io::FieldFile& file) {
  const std::vector<double> all = file.point_values(field.array);
  const std::size_t n = file.n_points(), width = n == 0 ? 1 : all.size() / n;
  std::vector<double> values(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double* const row = all.data() + width * i;
    if (field.component >= 0) {
      values[i] = row[field.component];
    } else {
      double sum = 0;
      for (std::size_t c = 0; c < width; ++c) sum += row[c] * row[c];
      values[i] = std::sqrt(sum);
    }
  }
  return values;
}

std::string displacement_array(const io::FieldFile& file) {
  for (const io::FieldArray& array : file.point_arrays())
    if (name_and_unit(array.name).first == "displacement" && array.components == 3) return array.name;
  return "";
}

const Field& field_named(const std::string& name, const std::vector<Field>& fields) {
  const auto found = std::ranges::find(fields, name, &Field::name);
  if (found != fields.end()) return *found;
  std::vector<std::string> names;
  names.reserve(fields.size());
  for (const Field& field : fields) names.push_back(field.name);
  throw ConfigError(fmt::format("no field '{}' in the results{} (there are: {})", name, did_you_mean(name, names),
                                fmt::join(names, ", ")));
}

}  // namespace creepcontact::report
