#pragma once
/// The XML of one .vtu file around arrays that are already encoded.

#include <string>
#include <vector>

#include "creepcontact/io/fields/field_writer.hpp"

namespace creepcontact::io {

struct VtuContent {
  double time = 0;
  std::vector<TextArray> texts;
  std::size_t n_points = 0, n_cells = 0;
  const EncodedArray* points = nullptr;
  const std::vector<EncodedArray>* cells = nullptr;  ///< connectivity, offsets, types
  std::vector<EncodedArray> point_data, cell_data;
};

/// XML, but for the bytes of the arrays, which it contains as they are: AppendedData, raw.
std::string vtu_document(const VtuContent& content);

}  // namespace creepcontact::io
