#pragma once
/// The mesh of a deck with its groups as a .msh file.

#include <map>
#include <string>
#include <vector>

#include "bodies.hpp"
#include "creepcontact/io/msh_content.hpp"
#include "loading.hpp"

namespace creepcontact::deck {

class MeshOutput {
 public:
  explicit MeshOutput(const Deck& deck);

  // Each returns the name of the group that it makes.
  std::string add_body(const DeckBody& body);
  std::string add_nodes(const std::string& name, const Numbers& nodes);
  std::string add_faces(const std::string& name, const std::vector<ElementFace>& faces);
  std::string msh() const;

 private:
  using CellNodes = std::vector<std::uint64_t>;
  /// @param cells  at least one, of one dimension
  void add_group(const std::string& name, const std::map<mesh::CellType, std::vector<CellNodes>>& cells);
  std::string free_name(const std::string& wanted);

  const Deck& deck_;
  io::MshContent content_;
  std::map<std::string, int> names_;  // groups by name: how often
  std::uint64_t next_tag_ = 1;
};

/// Faces of a surface, of its element faces or of its nodes; sorted.
/// @param impossible  gets faces that do not exist
std::vector<ElementFace> faces_of(const Deck& deck, const Surface& surface, std::vector<Note>& impossible);

}  // namespace creepcontact::deck
