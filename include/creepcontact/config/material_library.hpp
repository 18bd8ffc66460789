#pragma once
/// The material library: files of published data of steels, which `use` of a material names.

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/config/config.hpp"
#include "creepcontact/config/vocabulary.hpp"

namespace creepcontact::config {

/// Where data of a library file come from.
struct LibrarySource {
  std::string id;
  std::string citation;
  std::string where;                ///< page, table, equation; empty: the copy does not name it
  std::vector<std::string> copies;  ///< what was read
  std::string status;               ///< how well it is confirmed
  std::string licence;
};

/// A value against which a variant is checked, in the units of the file.
struct LibraryCheck {
  std::string quantity;
  double T = 0;
  std::optional<double> stress = {}, time = {}, strain_range = {}, ramp = {};
  int branch = 0;  ///< of laws with several
  double value = 0;
  double tolerance = 0;  ///< relative
  double factor = 1;     ///< instead of a tolerance: between value/factor and value*factor; 1: not given
  bool printed = false;  ///< in a source
  std::string where = {};
};

/// One set of data of a steel.
struct LibraryVariant {
  std::string name, title = {}, source = {}, notes = {};
  std::vector<std::string> laws = {};  ///< of its creep; empty: it has no creep
  bool rupture = false, fatigue = false;
  std::optional<Interval> stress_range = {}, temperature_range = {}, time_range = {}, strain_range = {};
  std::vector<LibraryCheck> checks = {};
};

/// A file of the library.
struct LibraryMaterial {
  std::string key;  ///< name of the file without .toml
  std::string name = {}, composition = {};
  std::vector<std::string> also = {};  ///< other names
  std::string units = {};              ///< of its numbers, as `units` of a configuration
  std::vector<LibrarySource> sources = {};
  /// Keys of [materials.<name>] that all variants have, with their sources.
  std::vector<std::pair<std::string, std::string>> properties = {};
  std::vector<LibraryVariant> variants = {};
  std::vector<std::pair<std::string, std::string>> rejected = {};  ///< data that were found and left out, and why

  /// True if all variants have this key.
  bool has(const std::string& property) const;
  /// @returns nullptr if there is none
  const LibrarySource* source(const std::string& id) const;
};

/// @param directory  with the files of the library; empty: none @returns all of them in the order of their keys
/// @throws ConfigError for a file that cannot be read or lacks what every file needs
std::vector<LibraryMaterial> material_library(const std::filesystem::path& directory);

/// What `use` may name: "grade_91", then "grade_91/swindeman_1999" and so on.
std::vector<std::string> names_of(const std::vector<LibraryMaterial>& library);

/// Materials whose key or one of whose names contains the word, whatever its case.
std::vector<LibraryMaterial> matching(const std::vector<LibraryMaterial>& library, const std::string& word);

/// The material that one variant makes, without a model. Where the library has no elastic constants, they are 1 and 0.
/// @param units  as `units` of a configuration @throws ConfigError
Material library_material(const LibraryMaterial& steel, const std::string& variant, const std::string& units,
                          const Vocabulary& vocabulary);

/// A table for a terminal, or sections with tables in Markdown.
std::string library_listing(const std::vector<LibraryMaterial>& library);
std::string library_markdown(const std::vector<LibraryMaterial>& library);

}  // namespace creepcontact::config
