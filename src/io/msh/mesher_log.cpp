#include "mesher_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "creepcontact/io/msh/mesher_protocol.hpp"

namespace creepcontact::io {
namespace {

constexpr std::size_t errors_told = 5, warnings_told = 20, last_told = 3;  // warnings that differ
constexpr std::size_t longest_line = 2000;

/// What follows "Error   : " and the like; empty if the line is of another kind.
std::string text_behind(const std::string& line, const std::string& kind) {
  if (!line.starts_with(kind)) return "";
  const std::size_t colon = line.find_first_not_of(' ', kind.size());
  return colon == std::string::npos || line[colon] != ':' ? "" : line.substr(std::min(colon + 2, line.size()));
}

/// The text between apostrophes.
std::string quoted(const std::string& text) {
  const std::size_t begin = text.find('\''), end = text.rfind('\'');
  return begin < end ? text.substr(begin + 1, end - begin - 1) : "";
}

/// Warnings that differ in numbers alone are repetitions.
std::string without_numbers(const std::string& text) {
  std::string result;
  for (const char c : text)
    if (std::string_view("0123456789.").find(c) == std::string_view::npos)
      result += c;
    else if (result.empty() || result.back() != '0')
      result += '0';
  return result;
}

/// Gmsh's frame around the warnings that it has told before, and their numbers.
bool is_summary(const std::string& warning) {
  const std::size_t begin = warning.find_first_not_of(' ');
  const std::string text = begin == std::string::npos ? "" : without_numbers(warning.substr(begin));
  constexpr std::array counts{"0 warning", "0 warnings", "0 error", "0 errors"};
  return text.starts_with("---") || text.starts_with("Mesh generation error summary") ||
         text.starts_with("Check the full log") || std::ranges::find(counts, text) != counts.end();
}

std::string indented(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += "\n  " + line;
  return text;
}

}  // namespace

void MesherLog::add(std::string_view bytes) {
  for (char c : bytes) {
    if (c == '\n' || c == '\r')
      end();
    else if (unfinished_.size() < longest_line)
      unfinished_ += c;
  }
}

void MesherLog::end() {
  if (!unfinished_.empty()) take(unfinished_);
  unfinished_.clear();
}

void MesherLog::take(const std::string& line) {
  if (line.starts_with(mesher::mark)) {
    own_.push_back(line.substr(std::string_view(mesher::mark).size()));
    return;
  }
  if (const std::string text = text_behind(line, "Error"); !text.empty()) {
    lacks_memory_ |= text.starts_with("Out of memory");
    lacks_descriptors_ |= text.starts_with("Unable to open file '") && std::filesystem::exists(quoted(text));
    if (++n_errors_ <= errors_told) errors_.push_back(text);
  } else if (const std::string warning = text_behind(line, "Warning"); !warning.empty() && !is_summary(warning)) {
    const std::string kind = without_numbers(warning);
    if (const auto known = std::ranges::find(warnings_, kind, &Warning::kind); known != warnings_.end())
      ++known->count;
    else if (warnings_.size() < warnings_told)
      warnings_.push_back({warning, kind});
    else
      ++n_other_warnings_;
  }
  extrusions_touch_ |= line.find("extruded node") != std::string::npos;
  last_.push_back(line);
  if (last_.size() > last_told) last_.erase(last_.begin());
}

std::string MesherLog::errors() const {
  std::string text = indented(errors_);
  if (n_errors_ > errors_told)
    text += fmt::format("\n  and {} more, which may follow from these", n_errors_ - errors_told);
  if (extrusions_touch_)
    text += "\n  (bodies that touch need SetFactory(\"OpenCASCADE\"): the built-in kernel merges their faces)";
  if (lacks_descriptors_)
    text += "\n  (the file exists: if it includes itself, it is opened until the system allows no more open files)";
  return text;
}

std::vector<std::string> MesherLog::warnings() const {
  std::vector<std::string> texts;
  for (const Warning& warning : warnings_)
    texts.push_back(warning.count == 1 ? warning.text : fmt::format("{} ({} times)", warning.text, warning.count));
  if (n_other_warnings_ > 0) texts.push_back(fmt::format("{} others", n_other_warnings_));
  return texts;
}

std::string MesherLog::own_words() const {
  return indented(own_);
}

std::string MesherLog::last_words() const {
  return last_.empty() ? "" : "; its last messages:" + indented(last_);
}

}  // namespace creepcontact::io
