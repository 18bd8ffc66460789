/// Decks of CalculiX and Abaqus (.inp).

#include <sstream>

#include "creepcontact/deck/deck.hpp"
#include "fuzz_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace creepcontact;
  fuzz::may_refuse([&] {
    std::istringstream text{std::string(fuzz::text_of(data, size))};
    const deck::Deck read = deck::read_deck(text, "fuzz.inp");
    fuzz::require(read.node_numbers.size() == read.positions.size(), "a position for every node");
    for (const deck::ElementBlock& block : read.elements)
      fuzz::require(
          block.nodes.size() == block.numbers.size() * static_cast<std::size_t>(mesh::n_nodes(block.type.cell)),
          "all nodes of every element");
  });
  return 0;
}
