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

  void add_body(const DeckBody& body);
  /// @returns the name of the group
  std::string add_nodes(const std::string& name, const Numbers& nodes);
  std::string add_faces(const std::string& name, const std::vector<ElementFace>& faces);
  std::string msh() const;

 private:
  io::MshContent::Elements& new_group(int dimension, const std::string& name, int type);
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
