#pragma once
// Reads back the arrays of a .vtu, written from the description of the format rather than from the writer.

#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <pugixml.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace creepcontact::io::test {

class VtuReader {
 public:
  explicit VtuReader(const std::filesystem::path& file) {
    const auto result = document_.load_file(file.c_str());
    if (!result) throw std::runtime_error(result.description());
    appended_ = root().child("AppendedData").text().as_string();
    appended_.erase(0, appended_.find('_') + 1);
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
  static std::string decode(std::string_view text) {
    static const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t bits = 0;
    int n_bits = 0;
    for (char c : text) {
      if (c == '=') break;
      bits = bits << 6 | static_cast<std::uint32_t>(digits.find(c));
      if ((n_bits += 6) < 8) continue;
      bytes += static_cast<char>(bits >> (n_bits -= 8) & 255);
    }
    return bytes;
  }
  static std::size_t encoded_length(std::size_t bytes) { return (bytes + 2) / 3 * 4; }
  static std::vector<std::uint64_t> integers(std::string_view text, std::size_t n) {
    const std::string bytes = decode(text.substr(0, encoded_length(8 * n)));
    std::vector<std::uint64_t> result(n);
    std::memcpy(result.data(), bytes.data(), 8 * n);
    return result;
  }

  std::string inflate(std::size_t offset) const {
    std::string_view text = std::string_view(appended_).substr(offset);
    const std::size_t n_blocks = integers(text, 1)[0];
    const auto header = integers(text, 3 + n_blocks);
    text.remove_prefix(encoded_length(8 * header.size()));
    std::size_t n_compressed = 0;
    for (std::size_t b = 0; b < n_blocks; ++b) n_compressed += header[3 + b];
    const std::string compressed = decode(text.substr(0, encoded_length(n_compressed)));
    std::string result;
    std::size_t begin = 0;
    for (std::size_t b = 0; b < n_blocks; ++b) {
      uLongf size = b + 1 == n_blocks && header[2] != 0 ? header[2] : header[1];
      std::string block(size, '\0');
      if (::uncompress(reinterpret_cast<Bytef*>(block.data()), &size,
                       reinterpret_cast<const Bytef*>(compressed.data() + begin), header[3 + b]) != Z_OK ||
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
