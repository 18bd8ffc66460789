#pragma once
// Reads back the arrays of a .vtu, written from the description of the format rather than from the writer.

#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <pugixml.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace creepcontact::io::test {

class VtuReader {
 public:
  explicit VtuReader(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    constexpr std::string_view begin = "<AppendedData encoding=\"raw\">_", end = "\n </AppendedData>\n</VTKFile>\n";
    const std::size_t at = text.find(begin);
    if (at == std::string::npos || !text.ends_with(end)) throw std::runtime_error("no appended data");
    const auto result = document_.load_string((text.substr(0, at) + "</VTKFile>").c_str());
    if (!result) throw std::runtime_error(result.description());
    appended_ = text.substr(at + begin.size(), text.size() - at - begin.size() - end.size());
  }

  pugi::xml_node root() const { return document_.child("VTKFile"); }
  pugi::xml_node grid() const { return root().child("UnstructuredGrid"); }
  pugi::xml_node piece() const { return grid().child("Piece"); }
  pugi::xml_node array(const char* section, const char* name) const {
    return piece().child(section).find_child_by_attribute("Name", name);
  }

  template <typename T>
  std::vector<T> values(const char* section, const char* name) const {
    const pugi::xml_node node = array(section, name);
    if (!node) throw std::runtime_error(std::string("no array ") + name);
    const std::string bytes = inflate(node.attribute("offset").as_ullong());
    std::vector<T> result(bytes.size() / sizeof(T));
    std::memcpy(result.data(), bytes.data(), bytes.size());
    return result;
  }

 private:
  /// From the offset on.
  std::vector<std::uint64_t> integers(std::size_t offset, std::size_t n) const {
    std::vector<std::uint64_t> result(n);
    if (offset + 8 * n > appended_.size()) throw std::runtime_error("the appended data are too short");
    std::memcpy(result.data(), appended_.data() + offset, 8 * n);
    return result;
  }

  std::string inflate(std::size_t offset) const {
    const std::size_t n_blocks = integers(offset, 1)[0];
    const auto header = integers(offset, 3 + n_blocks);
    std::string result;
    std::size_t begin = offset + 8 * header.size();
    for (std::size_t b = 0; b < n_blocks; ++b) {
      uLongf size = b + 1 == n_blocks && header[2] != 0 ? header[2] : header[1];
      std::string block(size, '\0');
      if (::uncompress(reinterpret_cast<Bytef*>(block.data()), &size,
                       reinterpret_cast<const Bytef*>(appended_.data() + begin), header[3 + b]) != Z_OK ||
          size != block.size())
        throw std::runtime_error("a block does not inflate");
      begin += header[3 + b];
      result += block;
    }
    return result;
  }

  pugi::xml_document document_;
  std::string appended_;
};

}  // namespace creepcontact::io::test
