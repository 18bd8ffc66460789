#pragma once
/// What walks the values of a configuration: Value::visit and Field::visit call it in the order of the tables.

#include <filesystem>
#include <string>
#include <vector>

#include "creepcontact/base/function.hpp"
#include "creepcontact/base/toml_string.hpp"
#include "creepcontact/config/schema.hpp"
#include "creepcontact/config/writer.hpp"

namespace creepcontact::config {

/// A reference to a function that outlives the call to which it is passed.
template <class Result, class... Arguments>
class Call {
 public:
  template <class Function>
  Call(const Function& function)  // NOLINT(google-explicit-constructor): any function is a call
      : object_(&function), call_([](const void* object, Arguments... arguments) -> Result {
          return (*static_cast<const Function*>(object))(arguments...);
        }) {}
  Result operator()(Arguments... arguments) const { return call_(object_, arguments...); }

 private:
  const void* object_;
  Result (*call_)(const void*, Arguments...);
};

class Visitor;
/// Visits a value.
using Walk = Call<void, Visitor&>;

class Visitor {
 public:
  virtual ~Visitor() = default;
  Visitor() = default;
  Visitor(const Visitor&) = delete;
  Visitor& operator=(const Visitor&) = delete;

  /// A key of a table.
  struct Key {
    const std::string& name;
    const KeyInfo* info;    ///< declaration; null: the name is the user's
    bool has_keys;          ///< tables of further keys are its value, or in it
    bool is_meaningful;     ///< false: other keys of the table exclude it
    Call<bool> is_default;  ///< a file without the key means the same
  };

  virtual void key(const Key& key, Walk value) = 0;
  virtual void element(std::size_t index, Walk value) = 0;
  virtual void table(Call<void> keys) { keys(); }
  virtual void list(Call<void> elements) { elements(); }

  /// A value without parts. @param toml  text of it in a file
  virtual void leaf(Call<std::string> toml) = 0;
  /// @param variables  that its key allows
  virtual void function(const Function& value, const std::vector<std::string>& variables) = 0;
  /// A file, relative to the working directory.
  virtual void path(const std::filesystem::path& file) = 0;
};

/// What an empty string is in a file: a default that says nothing.
inline constexpr const char* no_text = "\"\"";

/// Texts of a TOML file.
std::string toml_of(double number);
inline std::string toml_of(const std::string& text) {
  return toml_string(text);
}
std::string toml_of(const Function& function);
/// A key, bare where TOML allows it.
std::string toml_key(const std::string& name);

/// Collects a value as one line of TOML, tables as inline tables without the keys that have their defaults.
class InlineText final : public Visitor {
 public:
  /// @param directory  to which paths are relative
  explicit InlineText(std::filesystem::path directory = {}) : directory_(std::move(directory)) {}

  void key(const Key& key, Walk value) override;
  void element(std::size_t index, Walk value) override;
  void table(Call<void> keys) override;
  void list(Call<void> elements) override;
  void leaf(Call<std::string> toml) override { text += toml(); }
  void function(const Function& value, const std::vector<std::string>& variables) override;
  void path(const std::filesystem::path& file) override;

  std::string text;

 private:
  void separate();

  std::filesystem::path directory_;
  bool is_first_ = true;  // of the table or list that is open
};

/// A value in one line.
template <class T, class Visit>
std::string inline_text(const Visit& visit, const T& value) {
  InlineText text;
  visit(value, text);
  return text.text;
}

}  // namespace creepcontact::config
