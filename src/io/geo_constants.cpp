#include "geo_constants.hpp"

#include <cctype>
#include <fstream>
#include <iterator>
#include <string_view>
#include <vector>

namespace creepcontact::io {
namespace {

/// Words, strings ("..." without the closing quote, so that they cannot be mistaken for words) and single signs.
std::vector<std::string> tokens(std::string_view text) {
  const auto is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.'; };
  std::vector<std::string> result;
  std::size_t i = 0;
  while (i < text.size()) {
    const std::string_view rest = text.substr(i);
    std::size_t length = 1;
    if (rest.starts_with("//")) {
      length = std::min(rest.find('\n'), rest.size());
    } else if (rest.starts_with("/*")) {
      const auto end = rest.find("*/", 2);
      length = end == std::string_view::npos ? rest.size() : end + 2;
    } else if (rest[0] == '"') {
      const auto end = std::min(rest.find('"', 1), rest.size());
      result.emplace_back(rest.substr(0, end));
      length = std::min(end + 1, rest.size());
    } else if (is_word(rest[0])) {
      while (length < rest.size() && is_word(rest[length])) ++length;
      result.emplace_back(rest.substr(0, length));
    } else if (!std::isspace(static_cast<unsigned char>(rest[0]))) {
      result.emplace_back(rest.substr(0, 1));
    }
    i += length;
  }
  return result;
}

class Scanner {
 public:
  explicit Scanner(std::set<std::string>& names) : names_(names) {}

  void scan(const std::filesystem::path& file) {
    std::error_code ignored;
    if (!visited_.insert(std::filesystem::weakly_canonical(file, ignored)).second) return;
    std::ifstream stream(file, std::ios::binary);
    const std::vector<std::string> t = tokens(std::string(std::istreambuf_iterator<char>(stream), {}));
    for (std::size_t i = 0; i + 1 < t.size(); ++i) {
      if ((t[i] == "Include" || t[i] == "Merge") && t[i + 1].ends_with(".geo") && t[i + 1].starts_with('"')) {
        scan(file.parent_path() / t[i + 1].substr(1));
      } else if (t[i] == "DefineConstant" && (t[i + 1] == "[" || t[i + 1] == "(")) {
        scan_list(t, i + 2);
      }
    }
  }

 private:
  /// Items "name", "name = number" and "name = {number, options}"; lists and strings are not for overriding.
  void scan_list(const std::vector<std::string>& t, std::size_t i) {
    bool begins = true;
    for (int depth = 1; i + 1 < t.size(); ++i) {
      if (begins && (t[i + 1] == "," || t[i + 1] == "]" || t[i + 1] == ")")) names_.insert(t[i]);
      if (begins && t[i + 1] == "=" && i + 3 < t.size()) {
        const std::string& value = t[i + 2] == "{" ? t[i + 3] : t[i + 2];
        if (!value.starts_with('"')) names_.insert(t[i]);
      }
      begins = false;
      if (t[i] == "[" || t[i] == "(" || t[i] == "{") ++depth;
      if (t[i] == "]" || t[i] == ")" || t[i] == "}") --depth;
      if (depth == 0) return;
      if (depth == 1 && t[i] == ",") begins = true;
    }
  }

  std::set<std::string>& names_;
  std::set<std::filesystem::path> visited_;
};

}  // namespace

std::set<std::string> geo_constants(const std::filesystem::path& file) {
  std::set<std::string> names;
  Scanner(names).scan(file);
  return names;
}

}  // namespace creepcontact::io
