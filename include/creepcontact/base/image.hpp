#pragma once
/// Images that pages embed: a logo.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace creepcontact {

/// The media type that the content has: "image/png", "image/jpeg" or "image/svg+xml"; empty: none of these.
std::string image_type(std::string_view bytes);

/// An image file, or why it is none.
struct ImageFile {
  std::string bytes;
  std::string failure;  ///< empty on success
};
inline constexpr std::size_t max_image_bytes = std::size_t{1} << 20;
/// Reads a PNG, JPEG or SVG of at most max_image_bytes; nothing but regular files.
ImageFile read_image(const std::filesystem::path& path);

}  // namespace creepcontact
