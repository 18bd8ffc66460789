/// Decks of CalculiX and Abaqus that become a configuration, which the reader takes or refuses.

#include <toml++/toml.h>

#include <sstream>

#include "creepcontact/config/reader.hpp"
#include "creepcontact/deck/import.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "fuzz_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace creepcontact;
  static const config::Vocabulary vocabulary = run::vocabulary();
  fuzz::may_refuse([&] {
    std::istringstream text{std::string(fuzz::text_of(data, size))};
    const deck::Import made = deck::import_deck(deck::read_deck(text, "fuzz.inp"), "fuzz");
    fuzz::require(!made.msh.empty(), "a mesh");
    const std::string text_of_config = config::to_toml(made.config, vocabulary, made.comments);
    // Values that no run takes are told with their cards by the program, but all that is written is TOML.
    try {
      static_cast<void>(toml::parse(text_of_config));
    } catch (const toml::parse_error& error) {
      std::fprintf(stderr, "%s\n", error.what());
      fuzz::require(false, "what import writes is TOML");
    }
    config::parse(text_of_config, "fuzz.toml", vocabulary, {});
  });
  return 0;
}
