#include "geo_scan.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <string_view>

namespace creepcontact::io {
namespace {

/// A word, a sign, or a string without the quotation mark at its end, so that it cannot be mistaken for a word.
struct Token {
  std::string text;
  int line = 0;
  bool is_string() const { return text.front() == '"'; }
  bool is_word() const;
};

bool begins_word(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) || c == '_';
}

bool continues_word(char c) {
  return begins_word(c) || std::isdigit(static_cast<unsigned char>(c));
}

bool Token::is_word() const {
  return begins_word(text.front());
}

std::vector<Token> tokens(std::string_view text) {
  std::vector<Token> result;
  std::size_t i = 0;
  int line = 1;
  while (i < text.size()) {
    const std::string_view rest = text.substr(i);
    std::size_t length = 1;
    if (rest.starts_with("//")) {
      length = std::min(rest.find('\n'), rest.size());
    } else if (rest.starts_with("/*")) {
      const auto end = rest.find("*/", 2);
      length = end == std::string_view::npos ? rest.size() : end + 2;
    } else if (rest[0] == '"' || rest[0] == '\'') {
      const auto end = std::min(rest.find(rest[0], 1), rest.size());
      result.push_back({'"' + std::string(rest.substr(1, end - 1)), line});
      length = std::min(end + 1, rest.size());
    } else if (continues_word(rest[0])) {
      while (length < rest.size() && continues_word(rest[length])) ++length;
      result.push_back({std::string(rest.substr(0, length)), line});
    } else if (!std::isspace(static_cast<unsigned char>(rest[0]))) {
      result.push_back({std::string(rest.substr(0, 1)), line});
    }
    line += static_cast<int>(std::count(rest.begin(), rest.begin() + length, '\n'));
    i += length;
  }
  return result;
}

/// How often each word is in the text, whether or not it is in a comment or in quotation marks.
std::map<std::string, int, std::less<>> words_anywhere(std::string_view text) {
  std::map<std::string, int, std::less<>> counts;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && continues_word(text[end])) ++end;
    if (end > i) ++counts[std::string(text.substr(i, end - i))];
    i = end + 1;
  }
  return counts;
}

/// Gmsh merges these by their extensions, exactly as written here; they hold no statements.
bool is_cad(const std::filesystem::path& file) {
  static const std::set<std::string> extensions{".step", ".stp", ".iges", ".igs", ".brep", ".brp", ".stl", ".sat",
                                                ".STEP", ".STP", ".IGES", ".IGS", ".BRP",  ".STL", ".SAT"};
  return extensions.count(file.extension().string()) > 0;
}

/// Whether Gmsh takes the name for one relative to the file that gives it, as the scan does.
bool is_plain_name(const std::string& name) {
  return !name.empty() && name.front() != '\\' && (name.size() < 2 || name[1] != ':');
}

/// The content of a file; nullopt if there is something that is not to be read to its end.
std::optional<std::string> text_of(const std::filesystem::path& file) {
  constexpr std::uintmax_t largest = 1u << 24;
  std::error_code failure;
  if (!std::filesystem::exists(file, failure)) return "";
  if (!std::filesystem::is_regular_file(file, failure) || std::filesystem::file_size(file, failure) > largest ||
      failure)
    return std::nullopt;
  std::ifstream stream(file, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(stream), {});
  if (text.size() > largest) return std::nullopt;  // a file of the system has no size
  return text;
}

class Scanner {
 public:
  GeoScan scan(const std::filesystem::path& file) {
    std::vector<std::filesystem::path> pending{file};
    std::set<std::filesystem::path> visited;
    while (!pending.empty()) {
      file_ = pending.back();
      pending.pop_back();
      std::error_code ignored;
      if (!visited.insert(std::filesystem::weakly_canonical(file_, ignored)).second) continue;
      const std::optional<std::string> text = text_of(file_);
      if (!text) found_.unclear.push_back({file_.string(), 1, ""});
      tokens_ = tokens(text.value_or(""));
      look_at_last_line(1 + static_cast<int>(std::ranges::count(text.value_or(""), '\n')));
      for (std::size_t i = 0; i + 1 < tokens_.size(); ++i) look_at(i, pending);
      look_for_hidden(text.value_or(""));
    }
    return std::move(found_);
  }

 private:
  void look_at(std::size_t i, std::vector<std::filesystem::path>& pending) {
    const std::string& word = tokens_[i].text;
    const Token& next = tokens_[i + 1];
    if (is_reading(word)) {
      if (next.is_string())
        follow(i, pending);
      else if (next.is_word())
        found_.unclear.push_back(statement(i));
    } else if (word == "DefineConstant" && (next.text == "[" || next.text == "(")) {
      scan_list(i + 2);
    } else if (reaches_out(i)) {
      found_.reaching_out.push_back(statement(i));
    }
  }

  static bool is_reading(std::string_view word) {
    return word == "Include" || word == "Merge" || word == "MergeWithBoundingBox" || word == "Open";
  }

  void follow(std::size_t i, std::vector<std::filesystem::path>& pending) {
    const std::string name = tokens_[i + 1].text.substr(1);
    const std::filesystem::path other = file_.parent_path() / name;
    const bool is_merged = tokens_[i].text != "Include";
    if (is_merged && other.extension() == ".gz")  // Gmsh starts gunzip, by a shell
      found_.reaching_out.push_back(statement(i));
    else if (!is_plain_name(name))
      found_.unclear.push_back(statement(i));
    else if (!is_merged || !is_cad(other))
      pending.push_back(other);
  }

  /// Words and characters that Gmsh may read otherwise than the scan does: a Macro goes on in the line after its name,
  /// which may be in a comment; a NUL ends comments and texts, and so does the length of a text.
  void look_for_hidden(std::string_view text) {
    static const std::set<std::string, std::less<>> guarded{"SystemCall",
                                                            "NonBlockingSystemCall",
                                                            "System",
                                                            "CreateDir",
                                                            "Save",
                                                            "Print",
                                                            "Printf",
                                                            "OnelabRun",
                                                            "Exit",
                                                            "Abort",
                                                            "Include",
                                                            "Merge",
                                                            "Open",
                                                            "ExternalProcess",
                                                            "MergeWithBoundingBox"};
    static const std::set<std::string, std::less<>> always{"StringToName", "S2N",           "Plugin",
                                                           "CommandLine",  "ShapeFromFile", "SendToServer"};
    constexpr std::size_t longest = 1000;  // characters of a text
    std::map<std::string, int, std::less<>> seen;
    for (const Token& token : tokens_) {
      if (token.is_word()) ++seen[token.text];
      if (token.is_string() && token.text.size() > longest)
        found_.unclear.push_back({file_.string(), token.line, "a long text"});
    }
    for (const auto& [word, count] : words_anywhere(text))
      if (always.count(word) > 0 || (guarded.count(word) > 0 && count > seen[word]))
        found_.unclear.push_back({file_.string(), 1, word});
    if (text.find('\0') != std::string_view::npos) found_.unclear.push_back({file_.string(), 1, "a NUL character"});
  }

  /// @param last  number of the line without an end; nothing is on it if the text ends with a line end
  void look_at_last_line(int last) {
    const auto ends =
        std::ranges::count_if(tokens_, [&](const Token& token) { return token.line == last && token.text == ";"; });
    if (ends > 1) found_.lost.push_back(statement(tokens_.size() - 1));
  }

  /// Whether the word is a statement rather than a name: `Save "a.msh";` but not `Save = 1;`.
  bool reaches_out(std::size_t i) const {
    static const std::set<std::string> with_argument{
        "SystemCall", "NonBlockingSystemCall", "System", "CreateDir", "Save", "Print"};
    const std::string& word = tokens_[i].text;
    const Token& next = tokens_[i + 1];
    if (with_argument.count(word) > 0) return next.is_string() || next.is_word();
    if (word == "Exit" || word == "Abort") return next.text == ";";
    if (word == "OnelabRun") return next.text == "(" || next.is_string() || next.is_word();
    if (word == "ExternalProcess") return next.text == ";";  // a field of sizes that a program computes
    return word == "Printf" && next.text == "(" && behind_brackets(i + 1) == ">";
  }

  std::string behind_brackets(std::size_t i) const {
    int depth = 0;
    for (; i + 1 < tokens_.size(); ++i) {
      if (tokens_[i].text == "(") ++depth;
      if (tokens_[i].text == ")" && --depth == 0) return tokens_[i + 1].text;
    }
    return "";
  }

  GeoStatement statement(std::size_t i) const { return {file_.string(), tokens_[i].line, tokens_[i].text}; }

  /// Items "name", "name = number" and "name = {number, options}"; lists and strings are not for overriding.
  void scan_list(std::size_t i) {
    const auto text = [&](std::size_t k) -> const std::string& { return tokens_[k].text; };
    bool begins = true;
    for (int depth = 1; i + 1 < tokens_.size(); ++i) {
      const bool is_named = begins && is_identifier(text(i));
      if (is_named && (text(i + 1) == "," || text(i + 1) == "]" || text(i + 1) == ")"))
        found_.constants.insert(text(i));
      if (is_named && text(i + 1) == "=" && i + 3 < tokens_.size()) {
        const Token& value = tokens_[text(i + 2) == "{" ? i + 3 : i + 2];
        if (!value.is_string()) found_.constants.insert(text(i));
      }
      begins = false;
      if (text(i) == "[" || text(i) == "(" || text(i) == "{") ++depth;
      if (text(i) == "]" || text(i) == ")" || text(i) == "}") --depth;
      if (depth == 0) return;
      if (depth == 1 && text(i) == ",") begins = true;
    }
  }

  std::filesystem::path file_;
  std::vector<Token> tokens_;
  GeoScan found_;
};

}  // namespace

bool is_identifier(std::string_view name) {
  return !name.empty() && begins_word(name.front()) && std::ranges::all_of(name, continues_word);
}

GeoScan scan_geo(const std::filesystem::path& file) {
  return Scanner().scan(file);
}

}  // namespace creepcontact::io
