#pragma once
/// Collects the functions and the values of a struct by the declaration of its keys.

#include "creepcontact/config/configured.hpp"
#include "value.hpp"

namespace creepcontact::config {

/// Keeps the path of the key that is visited.
class PathVisitor : public Visitor {
 public:
  void key(const Key& key, Walk value) override;
  void element(std::size_t index, Walk value) override;

 protected:
  std::string path_;
};

class FunctionCollector final : public PathVisitor {
 public:
  void leaf(Call<std::string> /*toml*/) override {}
  void function(const Function& value, const std::vector<std::string>& variables) override;
  void path(const std::filesystem::path& /*file*/) override {}

  std::vector<ConfiguredFunction> functions;
};

class ValueCollector final : public PathVisitor {
 public:
  /// @param identifying  collects only what identifies the model
  explicit ValueCollector(bool identifying) : identifying_(identifying) {}

  void key(const Key& key, Walk value) override;
  void leaf(Call<std::string> toml) override { values.push_back({path_, toml()}); }
  void function(const Function& value, const std::vector<std::string>& variables) override;
  void path(const std::filesystem::path& file) override { values.push_back({path_, toml_of(file.string())}); }

  std::vector<ConfiguredValue> values;

 private:
  bool identifying_;
};

template <class T>
std::vector<ConfiguredFunction> functions_of(const Value<T>& declared, const T& value) {
  FunctionCollector collector;
  declared.visit(value, collector);
  return std::move(collector.functions);
}

/// @param identifying  false: of all keys
template <class T>
std::vector<ConfiguredValue> values_of(const Value<T>& declared, const T& value, bool identifying) {
  ValueCollector collector(identifying);
  declared.visit(value, collector);
  return std::move(collector.values);
}

}  // namespace creepcontact::config
