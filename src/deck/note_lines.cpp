#include "note_lines.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
#include <utility>

#include "values.hpp"

namespace creepcontact::deck {

std::vector<std::string> lines_of_notes(const std::vector<Note>& notes) {
  std::map<std::string, std::size_t> known;
  std::vector<const Note*> first;
  std::vector<std::set<std::pair<std::string, std::size_t>>> places;
  for (const Note& note : notes) {
    const bool is_missing = note.consequence.starts_with("there is no ");
    const std::string key = (is_missing ? "" : note.card) + "\n" + note.consequence;
    const auto [found, is_new] = known.try_emplace(key, first.size());
    if (is_new) {
      first.push_back(&note);
      places.emplace_back();
    }
    places[found->second].emplace(note.place.file, note.place.line);
  }
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const std::size_t others = places[i].size() - 1;
    lines.push_back(fmt::format("{}*{}: {}", prefix(first[i]->place), first[i]->card, first[i]->consequence));
    if (others > 0) lines.back() += fmt::format(" (and at {} more place{})", others, others == 1 ? "" : "s");
  }
  return lines;
}

}  // namespace creepcontact::deck
