#include "creepcontact/base/image.hpp"

#include <fmt/format.h>

#include "creepcontact/base/files.hpp"

namespace creepcontact {

std::string image_type(std::string_view bytes) {
  using namespace std::string_view_literals;
  if (bytes.starts_with("\x89PNG\r\n\x1A\n"sv)) return "image/png";
  if (bytes.starts_with("\xFF\xD8\xFF"sv)) return "image/jpeg";
  constexpr std::size_t head = 4096;  // the root element comes after comments and a document type
  if (bytes.starts_with("\xEF\xBB\xBF"sv)) bytes.remove_prefix(3);
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos || bytes[begin] != '<') return "";
  return bytes.substr(begin, head).find("<svg"sv) == std::string_view::npos ? "" : "image/svg+xml";
}

ImageFile read_image(const std::filesystem::path& path) {
  if (std::string failure = why_unreadable(path); !failure.empty()) return {"", std::move(failure)};
  std::error_code failure;
  if (!std::filesystem::is_regular_file(path, failure)) return {"", "it is not a regular file"};
  const std::uintmax_t size = std::filesystem::file_size(path, failure);
  if (!failure && size > max_image_bytes)
    return {"", fmt::format("it has {} bytes, allowed are {}", size, max_image_bytes)};
  FileBytes file = read_file(path, max_image_bytes);
  if (!file.failure.empty()) return {"", std::move(file.failure)};
  if (image_type(file.bytes).empty()) return {"", "it is neither PNG nor JPEG nor SVG"};
  return {std::move(file.bytes), ""};
}

}  // namespace creepcontact
