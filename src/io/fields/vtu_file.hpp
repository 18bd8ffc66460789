#pragma once
/// A .vtu file as XML and arrays of numbers: ASCII or binary, compressed or not.

#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "vtk_decoding.hpp"

namespace creepcontact::io {

/// Refers to the text.
class VtuFile {
 public:
  /// @param name  of the file, for messages @param purpose  what is wanted: "temperatures"
  /// @throws ModelError if it is not a .vtu file
  VtuFile(std::string_view text, std::string name, std::string purpose);

  /// <UnstructuredGrid>
  const pugi::xml_node& grid() const { return grid_; }
  /// @param array  a <DataArray> @throws ModelError naming the array if it is missing, has another number of components
  /// or of numbers, or is damaged
  std::vector<double> numbers(const pugi::xml_node& array, std::size_t n, int components) const;
  /// @throws ModelError "cannot read temperatures from '...': ..."
  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::vector<double> numbers_of(const pugi::xml_node& array, std::size_t n) const;

  std::string name_, purpose_;
  pugi::xml_document document_;
  pugi::xml_node grid_;
  std::string_view appended_;
  VtkFormat format_;
  bool appended_is_base64_ = false;
};

}  // namespace creepcontact::io
