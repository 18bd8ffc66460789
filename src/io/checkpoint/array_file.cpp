#include "creepcontact/io/checkpoint/array_file.hpp"

#include <fmt/format.h>

#include "checkpoint_seal.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/platform/replace_file.hpp"
#include "hdf5_file.hpp"

namespace creepcontact::io {
namespace {

constexpr const char* numbers_group = "numbers";
constexpr const char* integers_group = "integers";
constexpr const char* texts_group = "texts";

void write_groups(const std::filesystem::path& path, const NamedArrays& arrays) {
  const Hdf5Silence silence;
  Hdf5Handle file = create_hdf5(path, seal_size);
  {
    const Hdf5Handle numbers = create_group(file, numbers_group);
    for (const auto& [name, values] : arrays.numbers) write_array(numbers, name, values);
    const Hdf5Handle integers = create_group(file, integers_group);
    for (const auto& [name, values] : arrays.integers) write_array(integers, name, values);
    const Hdf5Handle texts = create_group(file, texts_group);
    for (const auto& [name, text] : arrays.texts) write_array(texts, name, std::span<const char>(text));
  }
  file.finish("write the file");
}

NamedArrays read_groups(const std::filesystem::path& path) {
  const Hdf5Silence silence;
  const Hdf5Handle file = open_hdf5(path);
  NamedArrays arrays;
  const Hdf5Handle numbers = open_group(file, numbers_group);
  for (const std::string& name : member_names(numbers)) arrays.numbers[name] = read_array<double>(numbers, name);
  const Hdf5Handle integers = open_group(file, integers_group);
  for (const std::string& name : member_names(integers))
    arrays.integers[name] = read_array<std::int64_t>(integers, name);
  const Hdf5Handle texts = open_group(file, texts_group);
  for (const std::string& name : member_names(texts)) {
    const std::vector<char> text = read_array<char>(texts, name);
    arrays.texts[name].assign(text.begin(), text.end());
  }
  return arrays;
}

}  // namespace

void write_array_file(const std::filesystem::path& path, const NamedArrays& arrays) {
  const std::filesystem::path part = platform::aside(path);
  try {
    write_groups(part, arrays);
    write_seal(part);
    platform::move_into_place(path);
  } catch (const Hdf5Error& error) {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw Error(fmt::format("cannot write '{}': {}", path.string(), error.what()), 4);
  }
}

NamedArrays read_array_file(const std::filesystem::path& path) {
  try {
    check_seal(path);
    return read_groups(path);
  } catch (const Hdf5Error& error) {
    throw ConfigError(fmt::format("'{}': {}", path.string(), error.what()));
  }
}

}  // namespace creepcontact::io
