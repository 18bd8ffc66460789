#pragma once
/// Elements of a deck by their numbers, their faces, and surfaces of these.

#include <span>

#include "loading.hpp"

namespace creepcontact::deck {

mesh::CellType element_cell(const Deck& deck, std::int64_t element);
/// Numbers of its nodes, in the order of the deck.
std::span<const std::int64_t> element_nodes(const Deck& deck, std::int64_t element);
std::span<std::int64_t> element_nodes(Deck& deck, std::int64_t element);

/// Nodes of a face that exists, corners first.
Numbers face_nodes(const Deck& deck, const ElementFace& face);
/// Its corners, sorted.
Numbers face_corners(const Deck& deck, const ElementFace& face);

/// Type of a face with this number of nodes of such an element; in sections of an edge.
mesh::CellType face_cell(mesh::CellType element, std::size_t n_nodes);
/// Normal of a face (sections: of an edge) away from the element, about times its size.
Vector3 outward_area(const Deck& deck, const ElementFace& face);

/// Faces of a surface, of its element faces or of its nodes; sorted.
/// @param impossible  gets faces that do not exist
std::vector<ElementFace> faces_of(const Deck& deck, const Surface& surface, std::vector<Note>& impossible);

/// Returns the faces of the surface with a name, or else of the set of nodes; none if there is neither.
std::vector<ElementFace> faces_named(const Deck& deck, const std::string& name, std::vector<Note>& impossible);

}  // namespace creepcontact::deck
