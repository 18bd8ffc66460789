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
#include "toml_document.hpp"
#include "unit_conversion.hpp"

namespace creepcontact::config {
namespace {

namespace fs = std::filesystem;

using Dimensions = std::vector<std::pair<std::string, UnitPowers>>;

const Dimensions& property_dimensions() {
  static const Dimensions all{{"young_modulus", unit::stress},
                              {"poisson_ratio", unit::none},
                              {"thermal_expansion", unit::per_degree},
                              {"reference_temperature", unit::temperature}};
  return all;
}
/// `parameter` is a temperature times a logarithm; `time_unit` is the unit of the model in that of the data.
const Dimensions& rupture_dimensions() {
  static const Dimensions all{{"rupture_time", unit::time},
                              {"stress", unit::stress},
                              {"parameter", unit::degree},
                              {"absolute_zero", unit::temperature},
                              {"time_unit", unit::per_time}};
  return all;
}
const Dimensions& fatigue_dimensions() {
  static const Dimensions all{{"cycles_to_failure", unit::none}};
  return all;
}
const Dimensions& range_dimensions() {
  static const Dimensions all{
      {"stress_range", unit::stress}, {"temperature_range", unit::temperature}, {"time_range", unit::time}};
  return all;
}

void convert(toml::table& table, const Dimensions& dimensions, const UnitConversion& units) {
  for (const auto& [key, dimension] : dimensions) units.replace(table, key, dimension);
}

/// The constants of a creep law, those that are not given with their defaults.
void convert_law(toml::table& block, const Law& law, const UnitConversion& units) {
  toml::array constants;
  for (const LawKey& key : law.keys) {
    if (const toml::node* given = block.get(key.name)) {
      constants.push_back(*given);
    } else if (!key.list && !key.fallback.empty() && key.fallback.front().is_constant()) {
      constants.push_back(key.fallback.front()({}));
    } else {
      constants.push_back(toml::array{});
    }
  }
  const auto value = [&](std::size_t place) { return constants.get(place); };
  for (std::size_t i = 0; i < law.keys.size(); ++i) {
    const LawKey& key = law.keys[i];
    if (!key.words.empty()) continue;
    if (block.contains(key.name)) {
      units.replace(block, key.name, key.dimension, value);
    } else if (const auto old = constants.get(i)->value<double>()) {
      toml::array box;
      units.append(*constants.get(i), key.dimension, value, box);
      if (box.get(0)->value<double>() != old) block.insert_or_assign(key.name, std::move(*box.get(0)));
    }
  }
}

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
    else
      for (const auto& [name, where] : names) take(name, where);
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
      "\"steel/variant\" of the material library (see `creepcontact list materials`), or a list of them";

 private:
  void fail(const Location& where, const std::string& message) {
    context_.errors.add(where, message);
    failed_ = true;
  }

  /// The file of a steel, and what its name is for users; an empty path: there is none, which has been reported.
  fs::path file_of(const std::string& key, const Location& where) {
    const std::string suffix = ".toml";
    if (vocabulary_.materials.empty()) {
      fail(where, "this program has no material library");
      return {};
    }
    if (key.ends_with(suffix)) return (context_.directory / key).lexically_normal();
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
      known = read_library_file(path);
      file = parse_toml(read_text(path), path, [] { return std::vector<KeyInfo>(); });
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
    UnitConversion units{UnitChange{}};
    bool same_units = false;
    try {
      const UnitChange change = unit_change(unit_system(known.units), unit_system(units_));
      same_units =
          change.stress == 1 && change.time == 1 && change.length == 1 && change.degree == 1 && change.zero == 0;
      units = UnitConversion(change);
    } catch (const std::invalid_argument&) {
      same_units = true;  // units that are wrong have been reported
    }
    const bool is_first = std::exchange(first_, false);
    bool is_used = is_first;
    if (is_first) take_properties(file, known, same_units ? nullptr : &units);
    if (variant.empty()) {
      if (!is_used) fail(where, fmt::format("'{}' adds nothing to what comes before it", name));
      return;
    }
    is_used |= take_blocks(*file["variants"][variant].as_table(), same_units ? nullptr : &units);
    if (!is_used)
      return fail(where, fmt::format("'{}' adds nothing: its blocks ({}) are given by what comes before it or next to "
                                     "`use`",
                                     name, contents(*found)));
    const LibrarySource& source = *known.source(found->source);
    add_source(name, source);
  }

  static std::string contents(const LibraryVariant& variant) {
    std::vector<std::string> all;
    if (!variant.laws.empty()) all.emplace_back("creep");
    if (variant.rupture) all.emplace_back("rupture");
    if (variant.fatigue) all.emplace_back("fatigue");
    return fmt::format("{}", fmt::join(all, ", "));
  }

  void take_properties(toml::table& file, const LibraryMaterial& known, const UnitConversion* units) {
    toml::table* properties = file["properties"].as_table();
    if (units != nullptr) convert(*properties, property_dimensions(), *units);
    std::map<std::string, std::vector<std::string>> by_source;
    for (const auto& [key, dimension] : property_dimensions()) {
      toml::node* value = properties->get(key);
      const bool is_elastic = key == "young_modulus" || key == "poisson_ratio";
      if (value == nullptr || material_.contains(key) || (is_elastic && material_.contains("orthotropic"))) continue;
      material_.insert_or_assign(key, std::move(*value));
      for (const auto& [property, source] : known.properties)
        if (property == key) by_source[source].push_back(key);
    }
    for (const auto& [source, keys] : by_source)
      add_source(fmt::format("{} ({})", known.key, fmt::join(keys, ", ")), *known.source(source));
    if (material_.contains("orthotropic")) return;
    for (const char* key : {"young_modulus", "poisson_ratio"}) {
      if (material_.contains(key)) continue;
      Location where = item_.location;
      where.key = join_key(where.key, key);
      fail(where, fmt::format("missing: the library has none for {}, so give it next to `use`", known.key));
    }
  }

  /// Fatigue data without cycles would be a mistake in a configuration, but not in one that takes all of a variant.
  /// @returns true if the variant has one that was not there
  bool take_blocks(toml::table& variant, const UnitConversion* units) {
    bool taken = false;
    for (const char* key : {"creep", "rupture", "fatigue"}) {
      toml::node* block = variant.get(key);
      if (block == nullptr || material_.contains(key)) continue;
      taken = true;
      if (std::string_view(key) == "fatigue" && !has_cycles_) continue;
      if (std::string_view(key) == "creep")
        for (toml::node& one : *block->as_array()) prepare_creep(*one.as_table(), variant, units);
      else if (units != nullptr)
        prepare(*block->as_table(), key, *units);
      material_.insert_or_assign(key, std::move(*block));
    }
    return taken;
  }

  /// Gives a block the ranges of its variant, and converts it. @param units  null: it stays as it is
  void prepare_creep(toml::table& block, const toml::table& variant, const UnitConversion* units) {
    for (const auto& [from, to] :
         {std::pair("stress", "stress_range"), std::pair("T", "temperature_range"), std::pair("time", "time_range")})
      if (const toml::array* range = variant["data_range"][from].as_array(); range != nullptr && !block.contains(to))
        block.insert_or_assign(to, *range);
    if (units == nullptr) return;
    convert(block, range_dimensions(), *units);
    const auto name = block["law"].value<std::string>();
    const auto law = std::ranges::find(vocabulary_.laws, name.value_or(""), &Law::name);
    if (law != vocabulary_.laws.end()) convert_law(block, *law, *units);
  }

  static void prepare(toml::table& block, std::string_view key, const UnitConversion& units) {
    if (key == "fatigue") return convert(block, fatigue_dimensions(), units);
    if (block.contains("stress")) {  // Larson-Miller data, with their defaults
      block.emplace("absolute_zero", Rupture{}.absolute_zero);
      block.emplace("time_unit", Rupture{}.time_unit);
    }
    convert(block, rupture_dimensions(), units);
  }

  void add_source(const std::string& what, const LibrarySource& source) {
    toml::array all;
    if (const toml::node* given = material_.get("sources")) {
      if (const toml::array* list = given->as_array())
        all = *list;
      else
        all.push_back(*given);
    }
    all.push_back(fmt::format("{}: {}{}{} (status: {})", what, source.citation, source.where.empty() ? "" : "; ",
                              source.where, source.status));
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

}  // namespace

void insert_library_data(toml::table& document, const std::string& file, const Vocabulary& vocabulary,
                         Context& context) {
  toml::table* materials = document["materials"].as_table();
  if (materials == nullptr) return;
  const Location root{.file = file, .line = 1, .column = 1};
  std::optional<std::string> units;
  for (auto&& [name, node] : *materials) {
    toml::table* material = node.as_table();
    if (material == nullptr || !material->contains("use")) continue;
    if (!units) units = units_for_library(document, root, context);
    const Item item = Item{&document, root}.child("materials").child(name.str());
    const bool has_cycles = static_cast<bool>(document["time"]["cycle"]);
    LibraryUse(item, *material, *units, has_cycles, vocabulary, context).insert();
  }
}

const char* library_use_type() {
  return LibraryUse::type;
}

std::vector<std::string> library_properties() {
  std::vector<std::string> keys{"density"};
  for (const auto& [key, dimension] : property_dimensions()) keys.push_back(key);
  return keys;
}

}  // namespace creepcontact::config
