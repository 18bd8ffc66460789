/// Configuration files with overrides.

#include <algorithm>
#include <string>
#include <vector>

#include "creepcontact/config/configured.hpp"
#include "creepcontact/config/reader.hpp"
#include "creepcontact/config/writer.hpp"
#include "fuzz_target.hpp"
#include "unit/config/test_vocabulary.hpp"

namespace creepcontact {
namespace {

/// Comments `#set key=value` are overrides, as the option --set takes them.
std::vector<std::string> overrides_in(std::string_view text) {
  constexpr std::string_view mark = "#set ";
  std::vector<std::string> all;
  for (std::size_t at = text.find(mark); at != std::string_view::npos; at = text.find(mark, at + 1)) {
    const std::size_t begin = at + mark.size();
    all.emplace_back(text.substr(begin, text.find('\n', begin) - begin));
  }
  return all;
}

std::string values(const config::Config& config) {
  std::string text;
  for (const config::ConfiguredValue& value : config::all_values(config)) text += value.key + " = " + value.text + '\n';
  return text;
}

}  // namespace
}  // namespace creepcontact

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace creepcontact;
  static const config::Vocabulary vocabulary = config::test_vocabulary();
  const std::string_view text = fuzz::text_of(data, size);
  fuzz::may_refuse([&] {
    const config::Config config = config::parse(std::string(text), "cases/fuzz.toml", vocabulary, overrides_in(text));
    const std::vector<double>& times = config.time.output;
    fuzz::require(!config.bodies.empty() && !config.materials.empty(), "what is accepted has bodies and materials");
    fuzz::require(std::is_sorted(times.begin(), times.end()), "output times increase");
    for (const config::Body& body : config.bodies) config.material(body.material.name);
    const config::Config again = config::parse(config::to_toml(config, vocabulary), config.file, vocabulary);
    fuzz::require(values(again) == values(config), "what is written reads back as the same");
  });
  return 0;
}
