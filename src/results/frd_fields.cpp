#include "frd_fields.hpp"

#include <algorithm>
#include <limits>
#include <string_view>

namespace creepcontact::results {
namespace {

using Kind = io::FrdField::Kind;

/// One block of the file, of one array or of several scalar ones.
struct Block {
  std::string_view name;
  Kind kind;
  std::vector<std::string_view> arrays;
  std::vector<std::string> components;
};

const std::vector<Block>& blocks() {
  static const std::vector<Block> all{
      {"DISP", Kind::vector, {"displacement"}, {"D1", "D2", "D3"}},
      {"STRESS", Kind::tensor, {"stress"}, {"SXX", "SYY", "SZZ", "SXY", "SYZ", "SZX"}},
      {"CREEP", Kind::tensor, {"creep_strain"}, {"CXX", "CYY", "CZZ", "CXY", "CYZ", "CZX"}},
      {"PE", Kind::scalars, {"creep_strain_equivalent"}, {"PE"}},
      {"NDTEMP", Kind::scalars, {"temperature"}, {"T"}},
      {"CONTACT",
       Kind::scalars,
       {"gap", "slip", "contact_pressure", "contact_shear"},
       {"COPEN", "CSLIP", "CPRESS", "CSHEAR"}},
      {"DAMAGE", Kind::scalars, {"damage"}, {"DAMAGE"}},
      {"LIFE", Kind::scalars, {"life_fraction"}, {"LIFE"}},
      {"REMLIFE", Kind::scalars, {"remaining_life"}, {"REMLIFE"}},
  };
  return all;
}

const io::FieldData* find(const std::vector<io::FieldData>& arrays, std::string_view name) {
  const auto found = std::ranges::find(arrays, name, &io::FieldData::name);
  return found == arrays.end() ? nullptr : &*found;
}

}  // namespace

std::vector<io::FrdField> frd_fields(const std::vector<io::FieldData>& at_points) {
  std::vector<io::FrdField> result;
  for (const Block& block : blocks()) {
    std::vector<const io::FieldData*> arrays;
    std::vector<std::string> components;
    for (std::size_t i = 0; i < block.arrays.size(); ++i)
      if (const io::FieldData* found = find(at_points, block.arrays[i])) {
        arrays.push_back(found);
        if (block.arrays.size() > 1) components.push_back(block.components[i]);
      }
    if (arrays.empty()) continue;
    io::FrdField field{
        std::string(block.name), block.arrays.size() > 1 ? components : block.components, block.kind, {}};
    if (arrays.size() == 1 && block.arrays.size() == 1) {
      field.values = arrays.front()->values;
    } else {
      // The arrays are 0 at nodes that are not in a contact.
      constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
      for (std::size_t i = 0; i < arrays.front()->values.size(); ++i) {
        const bool is_known = std::ranges::any_of(arrays, [&](const auto* array) { return array->values[i] != 0; });
        for (const io::FieldData* array : arrays) field.values.push_back(is_known ? array->values[i] : nowhere);
      }
    }
    result.push_back(std::move(field));
  }
  return result;
}

}  // namespace creepcontact::results
