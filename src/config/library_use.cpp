#include "library_use.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <set>
#include <stdexcept>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/suggestion.hpp"
#include "creepcontact/base/unit_system.hpp"
#include "library_files.hpp"
#include "material_units.hpp"
#include "toml_document.hpp"
#include "unit_conversion.hpp"

namespace creepcontact::config {
namespace {

namespace fs = std::filesystem;

/// Returns the steps of a path "creep[0].A": creep, 0, A.
std::vector<std::string> steps_of(const std::string& path) {
  std::vector<std::string> steps(1);
  for (const char letter : path) {
    if (letter == '.' || letter == '[')
      steps.emplace_back();
    else if (letter != ']')
      steps.back() += letter;
  }
  std::erase(steps, "");
  return steps;
}

/// One material that uses the library.
class LibraryUse {
 public:
  /// @param has_cycles  the loads of the model have a period
  LibraryUse(const Item& item, toml::table& material, const std::string& units, bool has_cycles,
             const Vocabulary& vocabulary, Context& context)
      : item_(item),
        material_(material),
        units_(units),
        has_cycles_(has_cycles),
        vocabulary_(vocabulary),
        context_(context) {}

  void insert() {
    const Item use = item_.child("use");
    std::vector<std::pair<std::string, Location>> names;
    if (const auto* one = use.node->as_string()) names.emplace_back(one->get(), use.location);
    if (const auto* several = use.node->as_array())
      for (std::size_t i = 0; i < several->size(); ++i)
        if (const auto* one = several->get(i)->as_string()) names.emplace_back(one->get(), use.element(i).location);
    const std::size_t expected = use.node->is_array() ? use.node->as_array()->size() : 1;
    if (names.size() != expected || names.empty())
      fail(use.location, fmt::format("{}; allowed: {}", describe(*use.node), type));
    std::vector<std::string> taken;
    if (names.size() == expected)
      for (const auto& [name, where] : names) {
        take(name, where);
        taken.push_back(name);
      }
    require_elastic_constants(taken);
    if (const toml::node* own = material_.get("override")) {
      if (own->is_table()) override_values();
      material_.erase("override");
    }
    material_.erase("use");
    if (!failed_) return;
    // A mistake has been reported: what follows from it is not.
    if (material_.contains("orthotropic")) return;
    material_.emplace("young_modulus", 1.0);
    material_.emplace("poisson_ratio", 0.3);
  }

  static constexpr const char* type =
      "\"steel/variant\" of the material library (see `creepcontact list materials`), \"file.toml/material\", or a "
      "list of "
      "them";

 private:
  void fail(const Location& where, const std::string& message) {
    context_.errors.add(where, message);
    failed_ = true;
  }

  /// The file of a steel, and what its name is for users; an empty path: there is none, which has been reported.
  fs::path file_of(const std::string& key, const Location& where) {
    const std::string suffix = ".toml";
    if (key.ends_with(suffix)) return (context_.directory / key).lexically_normal();
    if (vocabulary_.materials.empty()) {
      fail(where, "this program has no material library");
      return {};
    }
    const std::vector<std::string> keys = library_keys(vocabulary_.materials);
    if (std::ranges::count(keys, key) > 0) return vocabulary_.materials / (key + suffix);
    std::string hint = did_you_mean(key, keys);
    std::vector<std::string> others;
    for (const LibraryMaterial& material : matching(material_library(vocabulary_.materials), key))
      others.push_back('\'' + material.key + '\'');
    if (!others.empty()) hint = fmt::format("; did you mean {}?", fmt::join(others, " or "));
    fail(where, fmt::format("unknown steel '{}'{} (allowed: {})", key, hint, fmt::join(keys, ", ")));
    return {};
  }

  void take(const std::string& name, const Location& where) {
    const std::size_t in_name = name.find(".toml/");
    const std::size_t slash = in_name == std::string::npos ? name.find('/') : in_name + 5;
    const std::string key = name.substr(0, slash);
    const std::string variant = slash < name.size() ? name.substr(slash + 1) : "";
    const fs::path path = file_of(key, where);
    if (path.empty()) return;
    toml::table file;
    LibraryMaterial known;
    try {
      file = parse_toml(read_text(path), path, [] { return std::vector<KeyInfo>(); });
      if (file.contains("materials")) return take_material(file, path, name, variant, where);
      known = read_library_file(path);
    } catch (const ConfigError& error) {
      return fail(where, error.what());
    }
    const auto found = std::ranges::find(known.variants, variant, &LibraryVariant::name);
    if (!variant.empty() && found == known.variants.end()) {
      std::vector<std::string> variants;
      for (const LibraryVariant& one : known.variants) variants.push_back(one.name);
      return fail(where, fmt::format("{} has no variant '{}'{} (allowed: {})", key, variant,
                                     did_you_mean(variant, variants), fmt::join(variants, ", ")));
    }
    const auto units = conversion(known.units, key, where);
    if (!units) return;
    const bool is_first = std::exchange(first_, false);
    bool is_used = is_first;
    if (is_first) take_properties(file, known, *units);
    if (variant.empty()) {
      if (!is_used) fail(where, fmt::format("'{}' adds nothing to what comes before it", name));
      return;
    }
    is_used |= take_blocks(*file["variants"][variant].as_table(), *units);
    if (!is_used)
      return fail(where, fmt::format("'{}' adds nothing: its blocks ({}) are given by what comes before it or next to "
                                     "`use`",
                                     name, contents(*found)));
    const LibrarySource& source = *known.source(found->source);
    add_source(name, source);
  }

  /// Takes all keys of [materials.<variant>] of another configuration, such as `fit` writes it.
  void take_material(toml::table& file, const fs::path& path, const std::string& name, const std::string& variant,
                     const Location& where) {
    toml::table* materials = file["materials"].as_table();
    std::vector<std::string> names;
    if (materials != nullptr)
      for (const auto& [known, node] : *materials)
        if (node.is_table()) names.emplace_back(known.str());
    if (std::ranges::count(names, variant) == 0)
      return fail(where, fmt::format("'{}' has no material '{}'{} (allowed: {})", path.string(), variant,
                                     did_you_mean(variant, names), fmt::join(names, ", ")));
    toml::table& taken = *materials->get_as<toml::table>(variant);
    if (taken.contains("use"))
      return fail(where, fmt::format("'{}' takes its data by `use` itself: name what it uses", name));
    if (const auto units = file["units"].value<std::string>()) taken.emplace("units", *units);
    const Item item{&taken, {.file = path.string(), .line = 1, .column = 1, .key = "materials." + variant}};
    apply_own_units(item, taken, units_, vocabulary_, context_.errors);
    if (taken.contains("young_modulus") || taken.contains("orthotropic")) first_ = false;
    bool is_used = false;
    toml::array sources;
    if (toml::node* given = taken.get("sources")) sources.push_back(std::move(*given));
    taken.erase("sources");
    for (auto&& [key, node] : taken) is_used |= material_.insert(key, std::move(node)).second;
    if (!is_used) return fail(where, fmt::format("'{}' adds nothing to what comes before it or next to `use`", name));
    add_source_text(fmt::format("{}{}", name, sources.empty() ? "" : ": " + joined(*sources.get(0))));
  }

  static std::string joined(const toml::node& texts) {
    if (const auto one = texts.value<std::string>()) return *one;
    std::vector<std::string> all;
    if (const auto* list = texts.as_array())
      for (const toml::node& one : *list) all.push_back(one.value<std::string>().value_or(""));
    return fmt::format("{}", fmt::join(all, "; "));
  }

  /// Without a conversion if the units of the model are wrong, which has been reported.
  std::optional<MaterialUnits> conversion(const std::string& from, const std::string& key, const Location& where) {
    try {
      unit_system(from);
    } catch (const std::invalid_argument& error) {
      fail(where, fmt::format("the units of {} are wrong: {}", key, error.what()));
      return std::nullopt;
    }
    try {
      return MaterialUnits(from, units_, vocabulary_);
    } catch (const std::invalid_argument&) {
      return MaterialUnits(from, from, vocabulary_);
    }
  }

  static std::string contents(const LibraryVariant& variant) {
    std::vector<std::string> all;
    if (!variant.laws.empty()) all.emplace_back("creep");
    if (variant.rupture) all.emplace_back("rupture");
    if (variant.fatigue) all.emplace_back("fatigue");
    return fmt::format("{}", fmt::join(all, ", "));
  }

  void take_properties(toml::table& file, const LibraryMaterial& known, const MaterialUnits& units) {
    toml::table* properties = file["properties"].as_table();
    units.convert_properties(*properties);
    std::map<std::string, std::vector<std::string>> by_source;
    for (const std::string& key : converted_properties()) {
      toml::node* value = properties->get(key);
      const bool is_elastic = key == "young_modulus" || key == "poisson_ratio";
      if (value == nullptr || material_.contains(key) || (is_elastic && material_.contains("orthotropic"))) continue;
      material_.insert_or_assign(key, std::move(*value));
      for (const auto& [property, source] : known.properties)
        if (property == key) by_source[source].push_back(key);
    }
    for (const auto& [source, keys] : by_source)
      add_source(fmt::format("{} ({})", known.key, fmt::join(keys, ", ")), *known.source(source));
  }

  void require_elastic_constants(const std::vector<std::string>& names) {
    if (failed_ || material_.contains("orthotropic")) return;
    for (const char* key : {"young_modulus", "poisson_ratio"}) {
      if (material_.contains(key)) continue;
      Location where = item_.location;
      where.key = join_key(where.key, key);
      fail(where, fmt::format("missing: there is none in {}, so give it next to `use`", fmt::join(names, ", ")));
    }
  }

  /// Fatigue data without cycles would be a mistake in a configuration, but not in one that takes all of a variant.
  /// @returns true if the variant has one that was not there
  bool take_blocks(toml::table& variant, const MaterialUnits& units) {
    bool taken = false;
    for (const char* key : {"creep", "rupture", "fatigue"}) {
      toml::node* block = variant.get(key);
      if (block == nullptr || material_.contains(key)) continue;
      taken = true;
      const std::string_view name = key;
      if (name == "fatigue" && !has_cycles_) continue;
      if (name == "rupture") units.convert_rupture(*block->as_table());
      if (name == "fatigue") units.convert_fatigue(*block->as_table());
      if (name == "creep")
        for (toml::node& one : *block->as_array()) {
          add_ranges(*one.as_table(), variant);
          units.convert_creep(*one.as_table());
        }
      material_.insert_or_assign(key, std::move(*block));
    }
    return taken;
  }

  /// Gives a block the ranges of its variant.
  static void add_ranges(toml::table& block, const toml::table& variant) {
    for (const auto& [from, to] :
         {std::pair("stress", "stress_range"), std::pair("T", "temperature_range"), std::pair("time", "time_range")})
      if (const toml::array* range = variant["data_range"][from].as_array(); range != nullptr && !block.contains(to))
        block.insert_or_assign(to, *range);
  }

  void add_source(const std::string& what, const LibrarySource& source) {
    add_source_text(fmt::format("{}: {}{}{} (status: {})", what, source.citation, source.where.empty() ? "" : "; ",
                                source.where, source.status));
  }

  void add_source_text(const std::string& text) {
    toml::array all;
    if (const toml::node* given = material_.get("sources")) {
      if (const toml::array* list = given->as_array())
        all = *list;
      else
        all.push_back(*given);
    }
    all.push_back(text);
    material_.insert_or_assign("sources", std::move(all));
  }

  void override_values() {
    const Item given = item_.child("override");
    toml::table values = std::move(*material_.get("override")->as_table());
    std::vector<std::string> keys;
    for (const auto& [key, node] : values) keys.emplace_back(key.str());
    for (const std::string& key : keys) override_value(key, *values.get(key), given.location);
  }

  void override_value(const std::string& path, toml::node& value, const Location& table) {
    const Location where = locate(value.source(), join_key(table.key, path), table);
    const std::vector<std::string> steps = steps_of(path);
    toml::node* at = &material_;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const bool is_last = i + 1 == steps.size();
      if (toml::array* list = at->as_array()) {
        std::size_t index = list->size();
        std::from_chars(steps[i].data(), steps[i].data() + steps[i].size(), index);
        if (index >= list->size() || is_last)
          return context_.errors.add(
              where, fmt::format("there is no entry '{}' in the list", steps[i]),
              fmt::format("a path such as \"creep[0].A\" with an index from 0 to {}", list->size() - 1));
        at = list->get(index);
      } else if (toml::table* inner = at->as_table(); inner != nullptr && is_last) {
        inner->insert_or_assign(steps[i], std::move(value));
        return;
      } else {
        at = inner != nullptr ? inner->get(steps[i]) : nullptr;
        if (at == nullptr)
          return context_.errors.add(where, fmt::format("the material has no '{}'", steps[i]),
                                     "the path of a value that the material has, such as \"creep[0].A\"");
      }
    }
  }

  Item item_;
  toml::table& material_;
  const std::string& units_;
  bool has_cycles_;
  const Vocabulary& vocabulary_;
  Context& context_;
  bool first_ = true, failed_ = false;
};

/// Reports units that are missing or not understood. @returns those of the document
std::string units_for_library(const toml::table& document, const Location& root, Context& context) {
  const Item item = Item{&document, root}.child("units");
  const auto given = item.node != nullptr ? item.node->value<std::string>() : std::nullopt;
  if (!given) {
    context.errors.add(item.location, "missing, needed by `use` of a material", accepted_units());
    return {};
  }
  try {
    unit_system(*given);
  } catch (const std::invalid_argument& error) {
    context.errors.add(item.location, error.what(), accepted_units());
  }
  return *given;
}

/// The units of the model; empty if it has none that are understood.
std::string known_units_of(const toml::table& document) {
  std::string text = document["units"].value<std::string>().value_or("");
  try {
    unit_system(text);
    return text;
  } catch (const std::invalid_argument&) {
    return "";
  }
}

}  // namespace

void insert_library_data(toml::table& document, const std::string& file, const Vocabulary& vocabulary,
                         Context& context) {
  toml::table* materials = document["materials"].as_table();
  if (materials == nullptr) return;
  const Location root{.file = file, .line = 1, .column = 1};
  const std::string known_units = known_units_of(document);
  std::optional<std::string> units;
  for (auto&& [name, node] : *materials) {
    toml::table* material = node.as_table();
    if (material == nullptr) continue;
    const Item item = Item{&document, root}.child("materials").child(name.str());
    if (material->contains("use")) {
      if (!units) units = units_for_library(document, root, context);
      const bool has_cycles = static_cast<bool>(document["time"]["cycle"]);
      LibraryUse(item, *material, *units, has_cycles, vocabulary, context).insert();
    }
    apply_own_units(item, *material, known_units, vocabulary, context.errors);
  }
}

const char* library_use_type() {
  return LibraryUse::type;
}

std::vector<std::string> library_properties() {
  std::vector<std::string> keys = converted_properties();
  keys.insert(keys.begin(), "density");
  return keys;
}

}  // namespace creepcontact::config
