/// Decks of CalculiX and Abaqus that become a configuration: the reader of configurations takes what is written.

#include <sstream>

#include "creepcontact/config/reader.hpp"
#include "creepcontact/deck/import.hpp"
#include "fuzz_target.hpp"
#include "unit/config/test_vocabulary.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace creepcontact;
  static const config::Vocabulary vocabulary = config::test_vocabulary();
  fuzz::may_refuse([&] {
    std::istringstream text{std::string(fuzz::text_of(data, size))};
    const deck::Import made = deck::import_deck(deck::read_deck(text, "fuzz.inp"), "fuzz");
    fuzz::require(!made.msh.empty(), "a mesh");
    try {
      config::parse(made.toml, "fuzz.toml", vocabulary, {});
    } catch (const Error& error) {
      std::fprintf(stderr, "%s\n", error.what());
      fuzz::require(false, "what import writes is a configuration");
    }
  });
  return 0;
}
