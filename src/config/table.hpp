#pragma once
/// Tables of keys, and lists: kinds of values made of kinds of values. A Field binds a key to a member of a struct,
/// whose default-constructed value is the key's default.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <type_traits>

#include "value.hpp"

namespace creepcontact::config {

enum class Presence { optional, required };

template <class S>
struct Field {
  KeyInfo info;
  std::vector<KeyInfo> keys;  ///< below it
  std::function<void(const Item&, Context&, S&)> read;
  /// Visits the key of a struct that exists, unless the struct does not have it.
  std::function<void(const Field&, const S&, Visitor&)> visit;
  MakeJson json;                                     ///< of the value
  std::function<bool(const S&)> is_meaningful = {};  ///< not given: always
  std::function<bool(const S&)> is_needed = {};      ///< even with its default; not given: never

  /// @param words  what holds if the key is not given, where this cannot be written as a default value
  Field otherwise(const std::string& words) && {
    info.default_value.clear();
    info.otherwise = words;
    return std::move(*this);
  }
  /// @param dimension  KeyInfo::dimension
  Field in(const std::string& dimension) && {
    info.dimension = dimension;
    return std::move(*this);
  }
  /// @param condition  of the struct: else a file must not have the key
  Field only_if(std::function<bool(const S&)> condition) && {
    is_meaningful = std::move(condition);
    return std::move(*this);
  }
  /// @param condition  of the struct: a file without the key would be wrong, or mean something else than its default
  Field needed_if(std::function<bool(const S&)> condition) && {
    is_needed = std::move(condition);
    return std::move(*this);
  }
  /// It, and all below it, may differ between a run and the one that goes on from its checkpoint.
  Field changeable() && {
    info.identifies_model = false;
    for (KeyInfo& key : keys) key.identifies_model = false;
    return std::move(*this);
  }
};

/// Names every key that is not among `keys`. @returns true if there is none
bool known_keys_only(const Item& table, const std::vector<std::string>& keys, Context& context);
/// Names the required keys that are missing.
void require_keys(const Item& table, const std::vector<KeyInfo>& keys, Context& context);
/// Appends `keys` with paths below `parent`: "end" -> "time.end", "[].name" -> "probes[].name"
void append_below(const std::string& parent, const std::vector<KeyInfo>& keys, std::vector<KeyInfo>& all);

/// Makes the schema of a table without keys, to which keys are added: no others are allowed.
Json schema_of_table();
/// Adds a key with its meaning and default. @param value  schema of its value
void add_key(const KeyInfo& key, Json value, Json& table);
/// @param size  number of entries; 0: any
Json schema_of_list(const Json& entry, int size = 0);

/// Reports a table written with one bracket too few or too many, [supports] or [[time]].
/// @returns true if it is one. @param form  how the key is written
bool has_wrong_brackets(const Item& item, Form form, Context& context);

/// Makes KeyInfo::brief of a type.
std::string brief_type(const std::string& type, const std::string& brief);

/// The value of a member that is a T, or an optional; null: not given.
template <class T, class Member>
const T* value_in(const Member& member) {
  if constexpr (std::is_convertible_v<const Member&, const T&>)
    return &static_cast<const T&>(member);
  else
    return member ? &*member : nullptr;
}

/// @param member  of S, or a callable from S& and from const S& to a reference; a T or an optional<T>
template <class S, class Member, class T>
Field<S> field(const std::string& name, Member member, const Value<T>& value, const std::string& description,
               Presence presence = Presence::optional) {
  Field<S> made{{.path = name,
                 .type = value.type,
                 .required = presence == Presence::required,
                 .default_value = {},
                 .description = description,
                 .brief = brief_type(value.type, value.brief),
                 .form = value.form,
                 .words = value.words},
                value.keys,
                {},
                {},
                value.json};
  made.read = [member, read = value.read](const Item& item, Context& context, S& into) {
    if (auto found = read(item, context)) std::invoke(member, into) = std::move(*found);
  };
  S defaults{};
  const auto& initial = std::invoke(member, defaults);
  constexpr bool is_always_there = std::is_convertible_v<decltype(initial), const T&>;
  std::string fallback;  // as a file would have it
  if constexpr (is_always_there) {
    if (presence == Presence::optional && value.visit) fallback = inline_text(value.visit, static_cast<T>(initial));
    if (value.form == Form::value && fallback != no_text && !fallback.starts_with('{'))
      made.info.default_value = fallback;
  }
  made.visit = [member, visit = value.visit, presence, fallback](const Field<S>& own, const S& from, Visitor& to) {
    const T* const found = value_in<T>(std::invoke(member, from));
    if (found == nullptr) return;
    const auto is_default = [&] {
      return is_always_there && presence == Presence::optional && !(own.is_needed && own.is_needed(from)) &&
             inline_text(visit, *found) == fallback;
    };
    to.key({.name = own.info.path,
            .info = &own.info,
            .has_keys = !own.keys.empty(),
            .is_meaningful = !own.is_meaningful || own.is_meaningful(from),
            .is_default = is_default},
           [&](Visitor& inner) { visit(*found, inner); });
  };
  return made;
}

template <class S>
Value<S> table(const std::vector<Field<S>>& fields, const std::string& type = "a table") {
  Value<S> value{.type = type, .read = {}, .form = Form::table, .json = {}};
  std::vector<std::string> names;
  std::vector<KeyInfo> own;
  for (const Field<S>& entry : fields) {
    names.push_back(entry.info.path);
    own.push_back(entry.info);
    value.keys.push_back(entry.info);
    append_below(entry.info.path, entry.keys, value.keys);
  }
  const auto shared = std::make_shared<const std::vector<Field<S>>>(fields);  // copies of copies add up
  value.json = [shared] {
    Json schema = schema_of_table();
    for (const Field<S>& entry : *shared) add_key(entry.info, entry.json(), schema);
    return schema;
  };
  value.visit = [shared](const S& from, Visitor& to) {
    to.table([&] {
      for (const Field<S>& entry : *shared) entry.visit(entry, from, to);
    });
  };
  value.read = [shared, names, own, type](const Item& item, Context& context) -> std::optional<S> {
    if (has_wrong_brackets(item, Form::table, context)) return std::nullopt;
    if (!item.node->is_table()) {
      context.errors.add(item.location, describe(*item.node), type);
      return std::nullopt;
    }
    known_keys_only(item, names, context);
    require_keys(item, own, context);
    S into{};
    for (const Field<S>& entry : *shared) {
      const Item found = item.child(entry.info.path);
      if (found.node) entry.read(found, context, into);
    }
    return into;
  };
  return value;
}

/// Lets a table, or a list of them, be written among the keys around it: rotation = { ... }
template <class S>
Value<S> written_inline(Value<S> table) {
  table.form = Form::value;
  return table;
}

/// Reads an A, then makes the B of it.
/// @param convert  (A, Item, Context&) -> optional<B>
/// @param back     (const B&) -> A, or a reference to it
template <class B, class A, class Convert, class Back>
Value<B> converted(const Value<A>& from, Convert convert, Back back) {
  Value<B> value{.type = from.type,
                 .read = {},
                 .keys = from.keys,
                 .brief = from.brief,
                 .plural = from.plural,
                 .form = from.form,
                 .words = from.words,
                 .json = from.json};
  value.read = [read = from.read, convert](const Item& item, Context& context) -> std::optional<B> {
    auto found = read(item, context);
    if (!found) return std::nullopt;
    return convert(std::move(*found), item, context);
  };
  if (from.visit) value.visit = [visit = from.visit, back](const B& one, Visitor& to) { visit(back(one), to); };
  return value;
}

/// Checks what has been read, and completes it. @param convert  (A, Item, Context&) -> optional<A>
template <class A, class Convert>
Value<A> converted(const Value<A>& from, Convert convert) {
  return converted<A>(from, convert, [](const A& one) -> const A& { return one; });
}

/// What a list with a wrong entry yields: nothing, or the entries that are right (so that checks go on with those).
enum class Partial { dropped, kept };

template <class T>
Value<std::vector<T>> list(const Value<T>& entry, Partial partial = Partial::dropped) {
  Value<std::vector<T>> value{
      .type = "a list, each " + entry.type, .read = {}, .json = [json = entry.json] { return schema_of_list(json()); }};
  if (!entry.plural.empty()) value.brief = "list of " + entry.plural;
  append_below("[]", entry.keys, value.keys);
  value.read = [read = entry.read, partial, type = value.type](const Item& item,
                                                               Context& context) -> std::optional<std::vector<T>> {
    const toml::array* array = item.node->as_array();
    if (!array) {
      context.errors.add(item.location, describe(*item.node), type);
      return std::nullopt;
    }
    std::vector<T> all;
    for (std::size_t i = 0; i < array->size(); ++i) {
      if (auto found = read(item.element(i), context)) all.push_back(std::move(*found));
    }
    if (partial == Partial::dropped && all.size() != array->size()) return std::nullopt;
    return all;
  };
  value.visit = [visit = entry.visit](const std::vector<T>& all, Visitor& to) {
    to.list([&] {
      for (std::size_t i = 0; i < all.size(); ++i) to.element(i, [&](Visitor& inner) { visit(all[i], inner); });
    });
  };
  return value;
}

/// Reads references; a single one needs no list. @param what  one of them
Value<std::vector<Reference>> one_or_more(const std::string& what);
/// Reads texts that are not empty; a single one needs no list. @param what  one of them
Value<std::vector<std::string>> one_or_more_texts(const std::string& what);

/// Reads `[low, high]`. @param entry  one of the two
Value<Interval> interval(const Value<double>& entry);

/// Reads [[array.of.tables]].
template <class T>
Value<std::vector<T>> tables(const Value<T>& entry) {
  Value<std::vector<T>> value = list(entry, Partial::kept);
  value.form = Form::tables;
  value.read = [read = value.read](const Item& item, Context& context) -> std::optional<std::vector<T>> {
    if (has_wrong_brackets(item, Form::tables, context)) return std::nullopt;
    return read(item, context);
  };
  return value;
}

/// A table, or a list of them.
template <class T>
Value<std::vector<T>> one_or_more_tables(const Value<T>& entry) {
  Value<std::vector<T>> value = tables(entry);
  value.json = [one = entry.json, several = value.json] { return schema_of_any({one(), several()}); };
  value.read = [one = entry.read, several = value.read](const Item& item,
                                                        Context& context) -> std::optional<std::vector<T>> {
    if (!item.node->is_table()) return several(item, context);
    auto found = one(item, context);
    if (!found) return std::nullopt;
    return std::vector{std::move(*found)};
  };
  return value;
}

/// @param what  of components in space, or of other three
template <class T>
Value<std::array<T, 3>> triple(const Value<T>& entry, const std::string& what = "[x, y, z]") {
  const bool in_space = what.starts_with('[');
  Value<std::array<T, 3>> value{.type = what + ", each " + entry.type,
                                .read = {},
                                .brief = in_space ? "`" + what + "`, " + entry.plural : "list of three " + entry.plural,
                                .json = [json = entry.json] { return schema_of_list(json(), 3); }};
  value.read = [entry, type = value.type](const Item& item, Context& context) -> std::optional<std::array<T, 3>> {
    const toml::array* array = item.node->as_array();
    if (!array || array->size() != 3) {
      context.errors.add(item.location, describe(*item.node), type);
      return std::nullopt;
    }
    auto found = list(entry).read(item, context);
    if (!found) return std::nullopt;
    return std::array<T, 3>{(*found)[0], (*found)[1], (*found)[2]};
  };
  value.visit = [visit = entry.visit](const std::array<T, 3>& all, Visitor& to) {
    to.list([&] {
      for (std::size_t i = 0; i < all.size(); ++i) to.element(i, [&](Visitor& inner) { visit(all[i], inner); });
    });
  };
  return value;
}

/// A key whose name is the user's.
inline Visitor::Key user_key(const std::string& name) {
  static constexpr auto never = [] { return false; };
  return {.name = name, .info = nullptr, .has_keys = true, .is_meaningful = true, .is_default = never};
}

/// Reads tables whose names are the user's, in the order of the file. T has members name and location.
template <class T>
Value<std::vector<T>> named(const Value<T>& entry) {
  Value<std::vector<T>> value{.type = "tables by name", .read = {}, .form = Form::named, .json = [json = entry.json] {
                                return Json{{"type", "object"}, {"minProperties", 1}, {"additionalProperties", json()}};
                              }};
  append_below("<name>", entry.keys, value.keys);
  value.read = [read = entry.read, type = value.type](const Item& item,
                                                      Context& context) -> std::optional<std::vector<T>> {
    if (has_wrong_brackets(item, Form::named, context)) return std::nullopt;
    const toml::table* tables = item.node->as_table();
    if (!tables || tables->empty()) {
      context.errors.add(item.location, tables ? "an empty table" : describe(*item.node), type);
      return std::nullopt;
    }
    std::vector<T> all;
    for (const auto& [key, node] : *tables) {
      if (auto found = read(item.child(key.str()), context)) {
        found->name = key.str();
        all.push_back(std::move(*found));
      }
    }
    std::stable_sort(all.begin(), all.end(), [](const T& a, const T& b) {
      return std::pair(a.location.line, a.location.column) < std::pair(b.location.line, b.location.column);
    });
    return all;
  };
  value.visit = [visit = entry.visit](const std::vector<T>& all, Visitor& to) {
    to.table([&] {
      for (const T& one : all) to.key(user_key(one.name), [&](Visitor& inner) { visit(one, inner); });
    });
  };
  return value;
}

}  // namespace creepcontact::config
