#pragma once
/// Lines of decks (.inp, as CalculiX and Abaqus read them) as cards: a keyword with its parameters, and lines of data.

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace creepcontact::deck {

/// Position in a file.
struct Place {
  std::string file;
  std::size_t line = 0;  ///< from 1

  std::string text() const;  ///< "file:line"
};

/// "*SOLID SECTION, ELSET=Bolt, MATERIAL=Steel"
struct Card {
  std::string name;  ///< upper case, single blanks: "SOLID SECTION"
  /// The parameters by name, upper case without blanks. Values are as written, without quotes and the blanks around
  /// them; empty for a parameter without one.
  std::map<std::string, std::string> parameters = {};
  Place place = {};
  bool goes_on = false;  ///< it ends with a comma, and the next line has no "=": data, or parameters without values

  bool has(const std::string& parameter) const { return parameters.contains(parameter); }
  /// Empty if it is missing.
  const std::string& value(const std::string& parameter) const;
  /// "file:line: *SOLID SECTION: what"
  std::string message(const std::string& what) const;
};

/// Fields of a data line, without the blanks around them. Empty fields at the end are left out.
struct DataLine {
  std::vector<std::string_view> fields;  ///< valid until the next line is read
  bool goes_on = false;                  ///< it ends with a comma
  Place place = {};

  std::string_view field(std::size_t i) const { return i < fields.size() ? fields[i] : std::string_view(); }
};

/// What the cards of a deck are handed to, in their order.
struct CardSink {
  std::function<void(const Card&)> card;
  std::function<void(const DataLine&)> data;  ///< of the last card
};

/// Reads a deck from its file, and those that *INCLUDE names, line by line. Comments (**) and lines before the first
/// card are skipped. Lines may end with CR LF. A keyword continues in the next line after a comma, if that line has a
/// parameter.
/// @throws ConfigError with file and line: a file that cannot be read or is not text, a text without cards, a card
/// without a name, files that include each other
void read_cards(const std::filesystem::path& path, const CardSink& sink);
/// Reads a text instead of a file. @param name  for messages; the directory of this name is that of the files it
/// includes
void read_cards(std::istream& text, const std::filesystem::path& name, const CardSink& sink);

/// Names without regard to case: sets, surfaces, materials.
std::string upper_case(std::string_view text);

/// A number as Fortran reads it: 1, 1., 1.5e-3, 1.5d-3, 1.5-3. nullopt if the field is none.
std::optional<double> number(std::string_view field);
/// Reads a whole number of at most 1e15 in size.
std::optional<std::int64_t> whole_number(std::string_view field);

}  // namespace creepcontact::deck
