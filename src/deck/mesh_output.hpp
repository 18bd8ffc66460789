#pragma once
/// The mesh of a deck with its groups as a .msh file. Nodes and elements keep their numbers.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "bodies.hpp"
#include "creepcontact/io/msh/msh_content.hpp"
#include "loading.hpp"

namespace creepcontact::deck {

class MeshOutput {
 public:
  explicit MeshOutput(const Deck& deck);

  // Each returns the name of the group that it makes.
  std::string add_body(const DeckBody& body);
  /// The group that there is, if these nodes have one.
  std::string add_nodes(const std::string& name, const Numbers& nodes);
  std::string add_faces(const std::string& name, const std::vector<ElementFace>& faces);
  /// Triangles and quadrilaterals by their nodes. @param faces  nodes of each, at least one
  std::string add_skin(const std::string& name, const std::vector<Numbers>& faces);
  io::MshContent take() { return std::move(content_); }

 private:
  /// A new group without cells.
  io::MshContent::Key new_group(int dimension, const std::string& name);
  /// @param places  of the cell's nodes among those given
  void add_cell(io::MshContent::Key group, mesh::CellType type, std::uint64_t number,
                std::span<const std::int64_t> nodes, std::span<const int> places);
  std::string free_name(const std::string& wanted);

  const Deck& deck_;
  io::MshContent content_;
  std::map<std::string, int> names_;         // groups by name: how often
  std::map<Numbers, std::string> of_nodes_;  // groups of nodes, by these
  std::uint64_t next_number_ = 1;            // of cells that are not elements of the deck
};

}  // namespace creepcontact::deck
