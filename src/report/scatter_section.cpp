#include "scatter_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "creepcontact/base/base64.hpp"
#include "creepcontact/base/files.hpp"
#include "markdown.hpp"

namespace creepcontact::report {
namespace {

constexpr std::size_t longest_text = std::size_t{16} << 20, largest_picture = std::size_t{4} << 20;
constexpr std::size_t most_pictures = 24;

/// Pictures whose names begin so, by name.
std::vector<std::filesystem::path> pictures_named(const std::filesystem::path& directory, const std::string& begin) {
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    const std::filesystem::path& path = entry.path();
    if (!entry.is_symlink() && entry.is_regular_file() && path.extension() == ".png" &&
        path.filename().string().starts_with(begin))
      found.push_back(path);
  }
  std::ranges::sort(found);
  return found;
}

void add_picture(const std::filesystem::path& file, const std::string& what, Html& page) {
  const FileBytes read = read_file(file, largest_picture);
  if (!read.failure.empty() || read.bytes.empty()) return;
  const std::string name = file.stem().string();
  page.figure(data_url("image/png", read.bytes), fmt::format("{}: {}", what, name), fmt::format("{} ({})", what, name));
}

}  // namespace

bool has_scatter(const std::filesystem::path& directory) {
  return path_exists(directory / "study.md") && path_exists(directory / "quantiles.csv");
}

void add_scatter(const std::filesystem::path& directory, Html& page) {
  const std::string text = read_file(directory / "study.md", longest_text).bytes;
  const std::string heading = "\n## Scatter\n";
  const std::size_t begin = text.find(heading);
  if (begin == std::string::npos) return;
  const std::size_t end = text.find("\n## ", begin + heading.size());
  page.element("h2", "Scatter");
  page.raw(markdown(text.substr(begin + heading.size(), end - begin - heading.size()), 2));
  std::size_t n = 0;
  const std::vector<std::pair<const char*, const char*>> kinds{{"probabilities", "Probability over time"},
                                                               {"fan_", "Median and bands over time"},
                                                               {"histogram_", "Values at the end"},
                                                               {"cloud_", "Values at the end over one key"}};
  for (const auto& [name, what] : kinds)
    for (const std::filesystem::path& file : pictures_named(directory, name))
      if (n++ < most_pictures) add_picture(file, what, page);
}

}  // namespace creepcontact::report
