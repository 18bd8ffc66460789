#include "creepcontact/config/material_library.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/toml_string.hpp"
#include "creepcontact/base/units.hpp"
#include "creepcontact/config/reader.hpp"
#include "creepcontact/config/writer.hpp"
#include "library_files.hpp"
#include "library_use.hpp"
#include "toml_document.hpp"

namespace creepcontact::config {
namespace {

namespace fs = std::filesystem;

/// Reads what the tables of a library file need, and collects what is missing.
class LibraryReader {
 public:
  explicit LibraryReader(fs::path file) : file_(std::move(file)) {}

  LibraryMaterial read() {
    const toml::table document = parse_toml(read_text(file_), file_, [] { return std::vector<KeyInfo>(); });
    LibraryMaterial made{.key = file_.stem().string()};
    made.name = text(document, "name");
    made.composition = text(document, "composition");
    made.also = texts(document["also"].node());
    made.units = units_text(document);
    for_each_table(document, "sources", [&](const std::string& id, const toml::table& table) {
      made.sources.push_back({.id = id,
                              .citation = text(table, "citation", id),
                              .where = text(table, "where", id, true),
                              .copies = texts(table["copies"].node()),
                              .status = text(table, "status", id),
                              .licence = text(table, "licence", id)});
      if (made.sources.back().copies.empty()) missing(id, "copies");
    });
    read_properties(document, made);
    for_each_table(document, "variants", [&](const std::string& name, const toml::table& table) {
      made.variants.push_back(variant(name, table));
      if (made.source(made.variants.back().source) == nullptr) missing(name, "a source of [sources]");
    });
    if (const toml::array* rejected = document["rejected"].as_array())
      for (const toml::node& one : *rejected)
        if (const toml::table* table = one.as_table())
          made.rejected.emplace_back(text(*table, "name"), text(*table, "reason"));
    if (!missing_.empty()) throw ConfigError(fmt::format("{}: missing: {}", file_.string(), fmt::join(missing_, "; ")));
    return made;
  }

 private:
  void missing(const std::string& of, const std::string& what) {
    missing_.push_back(of.empty() ? what : of + ": " + what);
  }

  std::string text(const toml::table& table, std::string_view key, const std::string& of = {},
                   bool may_be_empty = false) {
    const auto found = table[key].value<std::string>();
    if (!found || (found->empty() && !may_be_empty)) missing(of, std::string(key));
    return found.value_or("");
  }

  static std::vector<std::string> texts(const toml::node* node) {
    std::vector<std::string> all;
    if (node == nullptr) return all;
    if (const auto one = node->value<std::string>()) all.push_back(*one);
    if (const toml::array* list = node->as_array())
      for (const toml::node& one : *list) all.push_back(one.value<std::string>().value_or(""));
    return all;
  }

  template <class Take>
  static void for_each_table(const toml::table& document, std::string_view key, const Take& take) {
    const toml::table* tables = document[key].as_table();
    if (tables == nullptr) return;
    std::vector<std::pair<toml::source_position, std::string>> order;
    for (const auto& [name, node] : *tables)
      if (node.is_table()) order.emplace_back(node.source().begin, std::string(name.str()));
    std::ranges::sort(order);
    for (const auto& [place, name] : order) take(name, *tables->get_as<toml::table>(name));
  }

  void read_properties(const toml::table& document, LibraryMaterial& made) {
    const toml::table* properties = document["properties"].as_table();
    if (properties == nullptr) return missing("", "properties");
    for (const auto& [key, node] : *properties) {
      const std::string name(key.str());
      if (name == "source" || name == "reference_temperature") continue;
      const std::vector<std::string> known = library_properties();
      if (std::ranges::count(known, name) == 0) missing(name, "a property that the program knows");
      const auto source = (*properties)["source"][name].value<std::string>();
      if (!source || made.source(*source) == nullptr) missing(name, "its source in properties.source");
      made.properties.emplace_back(name, source.value_or(""));
    }
  }

  static std::optional<Interval> range(const toml::table& table, std::string_view key) {
    const toml::array* pair = table["data_range"][key].as_array();
    if (pair == nullptr || pair->size() != 2) return std::nullopt;
    return Interval{(*pair)[0].value<double>().value_or(0), (*pair)[1].value<double>().value_or(0)};
  }

  LibraryVariant variant(const std::string& name, const toml::table& table) {
    LibraryVariant made{.name = name};
    made.title = text(table, "title", name);
    made.source = text(table, "source", name);
    made.notes = text(table, "notes", name);
    made.rupture = table.contains("rupture");
    made.fatigue = table.contains("fatigue");
    made.stress_range = range(table, "stress");
    made.temperature_range = range(table, "T");
    made.time_range = range(table, "time");
    made.strain_range = range(table, "strain");
    if (const toml::array* creep = table["creep"].as_array())
      for (const toml::node& block : *creep) {
        const toml::table* law = block.as_table();
        made.laws.push_back(law != nullptr ? text(*law, "law", name) : "");
      }
    if (made.laws.empty() && !made.rupture && !made.fatigue) missing(name, "creep, rupture or fatigue");
    if (const toml::array* checks = table["checks"].as_array())
      for (const toml::node& one : *checks)
        if (const toml::table* check = one.as_table()) made.checks.push_back(read_check(name, *check));
    if (made.checks.empty()) missing(name, "checks");
    return made;
  }

  LibraryCheck read_check(const std::string& of, const toml::table& table) {
    LibraryCheck made{.quantity = text(table, "quantity", of)};
    const auto number = [&](std::string_view key) { return table[key].value<double>(); };
    if (!number("T") || !number("value")) missing(of, "T or value of a check");
    if (!number("tolerance") && !number("factor")) missing(of, "tolerance or factor of a check");
    if (!table.contains("printed")) missing(of, "printed of a check");
    made.T = number("T").value_or(0);
    made.stress = number("stress");
    made.time = number("time");
    made.strain_range = number("strain_range");
    made.ramp = number("ramp");
    made.branch = static_cast<int>(number("branch").value_or(0));
    made.value = number("value").value_or(0);
    made.tolerance = number("tolerance").value_or(0);
    made.factor = number("factor").value_or(1);
    made.printed = table["printed"].value<bool>().value_or(false);
    made.where = text(table, "where", of);
    return made;
  }

  std::string units_text(const toml::table& document) {
    const std::string units = library_units(document);
    if (units.empty()) missing("units", "stress, time, temperature, length");
    return units;
  }

  fs::path file_;
  std::vector<std::string> missing_;
};

std::string without_case(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string range_text(const std::optional<Interval>& range, const std::string& unit) {
  return range ? fmt::format("{:g} to {:g} {}", range->low, range->high, unit) : "";
}

std::string ranges(const LibraryMaterial& material, const LibraryVariant& variant) {
  const auto unit = [&](Dimension dimension) { return unit_of(dimension, material.units); };
  std::vector<std::string> all;
  for (const std::string& one :
       {range_text(variant.temperature_range, unit(Dimension::temperature)),
        range_text(variant.stress_range, unit(Dimension::stress)),
        range_text(variant.time_range, unit(Dimension::time)), range_text(variant.strain_range, "strain range")})
    if (!one.empty()) all.push_back(one);
  return fmt::format("{}", fmt::join(all, ", "));
}

std::string contents(const LibraryVariant& variant, const char* mark) {
  std::vector<std::string> all;
  if (!variant.laws.empty()) {
    std::vector<std::string> laws;
    for (const std::string& law : variant.laws) laws.push_back(mark + law + mark);
    all.push_back(fmt::format("creep ({})", fmt::join(laws, ", ")));
  }
  if (variant.rupture) all.emplace_back("rupture");
  if (variant.fatigue) all.emplace_back("fatigue");
  return fmt::format("{}", fmt::join(all, ", "));
}

/// Texts of several lines as one, with what Markdown tables need.
std::string table_cell(const std::string& text) {
  std::string line;
  for (const char letter : text) {
    if (letter == '|') line += '\\';
    line += letter == '\n' ? ' ' : letter;
  }
  return line;
}

std::string status_of(const LibraryMaterial& material, const std::string& source) {
  const LibrarySource* found = material.source(source);
  return found != nullptr ? found->status : "";
}

std::string steel_section(const LibraryMaterial& material) {
  std::string text = fmt::format("### {}\n\n`{}`: {}. Also {}.\n\n", material.name, material.key, material.composition,
                                 fmt::join(material.also, ", "));
  if (material.properties.empty()) {
    text += "No elastic constants or expansion were found: give `young_modulus` and `poisson_ratio` next to `use`.\n\n";
  } else {
    std::vector<std::string> properties;
    for (const auto& [key, source] : material.properties) properties.push_back(fmt::format("`{}` [{}]", key, source));
    text += fmt::format("All variants: {}.\n\n", fmt::join(properties, ", "));
  }
  if (!material.variants.empty())
    text += "| variant | has | range | source, status | what to know |\n|---|---|---|---|---|\n";
  for (const LibraryVariant& variant : material.variants)
    text += fmt::format("| `{}` {} | {} | {} | {}: {} | {} |\n", variant.name, table_cell(variant.title),
                        contents(variant, "`"), ranges(material, variant), variant.source,
                        table_cell(status_of(material, variant.source)), table_cell(variant.notes));
  if (!material.variants.empty()) text += '\n';
  text += "| source | citation | where | licence |\n|---|---|---|---|\n";
  for (const LibrarySource& source : material.sources)
    text += fmt::format("| {} | {} | {} | {} |\n", source.id, table_cell(source.citation), table_cell(source.where),
                        table_cell(source.licence));
  if (!material.rejected.empty()) text += "\nFound and left out:\n\n";
  for (const auto& [name, reason] : material.rejected)
    text += fmt::format("- {}: {}\n", table_cell(name), table_cell(reason));
  return text + '\n';
}

}  // namespace

std::string library_units(const toml::table& document) {
  std::vector<std::string> words;
  for (const char* key : {"length", "stress", "time", "temperature"})
    if (const auto word = document["units"][key].value<std::string>())
      words.push_back(*word == "C" || *word == "F" ? "deg" + *word : *word);
  return words.size() == 4 ? fmt::format("{}", fmt::join(words, ", ")) : "";
}

std::vector<std::string> library_keys(const fs::path& directory) {
  std::vector<std::string> keys;
  std::error_code failure;
  if (!directory.empty())
    for (const fs::directory_entry& entry : fs::directory_iterator(directory, failure))
      if (entry.path().extension() == ".toml") keys.push_back(entry.path().stem().string());
  std::ranges::sort(keys);
  return keys;
}

const LibrarySource* LibraryMaterial::source(const std::string& id) const {
  const auto found = std::ranges::find(sources, id, &LibrarySource::id);
  return found == sources.end() ? nullptr : &*found;
}

bool LibraryMaterial::has(const std::string& property) const {
  return std::ranges::any_of(properties, [&](const auto& one) { return one.first == property; });
}

Material library_material(const LibraryMaterial& steel, const std::string& variant, const std::string& units,
                          const Vocabulary& vocabulary) {
  std::string keys = fmt::format("use = {}\n", toml_string(steel.key + '/' + variant));
  if (!steel.has("young_modulus")) keys += "young_modulus = 1\n";
  if (!steel.has("poisson_ratio")) keys += "poisson_ratio = 0\n";
  if (!steel.has("thermal_expansion")) keys += "reference_temperature = 0\n";
  const std::string text = fmt::format(
      "units = {}\nmesh.file = \"none.msh\"\nbodies.bar = {{ region = \"bar\", material = \"steel\" }}\n"
      "time = {{ end = 1, cycle = 1 }}\ntemperature.value = 0\n[materials.steel]\n{}",
      toml_string(units), keys);
  return parse(text, "", vocabulary).materials.front();
}

LibraryMaterial read_library_file(const fs::path& file) {
  return LibraryReader(file).read();
}

std::vector<LibraryMaterial> material_library(const fs::path& directory) {
  std::vector<LibraryMaterial> all;
  for (const std::string& key : library_keys(directory)) all.push_back(read_library_file(directory / (key + ".toml")));
  return all;
}

std::vector<std::string> names_of(const std::vector<LibraryMaterial>& library) {
  std::vector<std::string> names;
  for (const LibraryMaterial& material : library) {
    names.push_back(material.key);
    for (const LibraryVariant& variant : material.variants) names.push_back(material.key + '/' + variant.name);
  }
  return names;
}

std::vector<LibraryMaterial> matching(const std::vector<LibraryMaterial>& library, const std::string& word) {
  std::vector<LibraryMaterial> found;
  const std::string wanted = without_case(word);
  std::ranges::copy_if(library, std::back_inserter(found), [&](const LibraryMaterial& material) {
    std::vector<std::string> names = material.also;
    names.insert(names.end(), {material.key, material.name});
    return std::ranges::any_of(
        names, [&](const std::string& name) { return without_case(name).find(wanted) != std::string::npos; });
  });
  return found;
}

std::string library_listing(const std::vector<LibraryMaterial>& library) {
  std::string text;
  for (const LibraryMaterial& material : library) {
    text += fmt::format("{}  {} ({}); {}\n", material.key, material.name, material.composition,
                        fmt::join(material.also, ", "));
    std::vector<std::string> properties;
    for (const auto& [key, source] : material.properties)
      properties.push_back(fmt::format("{} ({})", key, status_of(material, source)));
    text += fmt::format("  {}\n", properties.empty() ? "no elastic constants: give them next to `use`"
                                                     : fmt::format("{}", fmt::join(properties, ", ")));
    std::size_t width = 0;
    for (const LibraryVariant& variant : material.variants) width = std::max(width, variant.name.size());
    for (const LibraryVariant& variant : material.variants) {
      std::vector<std::string> parts{variant.title, contents(variant, ""), ranges(material, variant),
                                     status_of(material, variant.source)};
      std::erase(parts, "");
      text += fmt::format("  /{:<{}}  {}\n", variant.name, width, fmt::join(parts, "; "));
    }
  }
  std::erase(text, '`');
  return text;
}

std::string library_markdown(const std::vector<LibraryMaterial>& library) {
  std::string text;
  for (const LibraryMaterial& material : library) text += steel_section(material);
  return text;
}

}  // namespace creepcontact::config
