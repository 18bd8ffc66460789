#pragma once
/// General *CONTACT: which outer faces of different bodies may touch.

#include <array>
#include <string>
#include <vector>

#include "bodies.hpp"
#include "creepcontact/settings/analysis.hpp"
#include "loading.hpp"

namespace creepcontact::deck {

/// Smooth pieces of the surfaces of two bodies that face each other.
struct FacingSurfaces {
  std::array<std::vector<ElementFace>, 2> faces;  ///< the slave first
  std::array<std::string, 2> bodies;
  bool is_even = false;           ///< the distance of planes, or of cylinders or spheres, is the same everywhere
  double least = 0, largest = 0;  ///< distance, negative where the bodies overlap; 0 up to rounding is 0
  std::string interaction;        ///< name as written; empty: none is assigned
  Place place;                    ///< of the *CONTACT INCLUSIONS
};

/// The faces, sorted, of two surfaces that are joined already.
using JoinedFaces = std::array<std::vector<ElementFace>, 2>;

/// Finds the pairs that *CONTACT INCLUSIONS asks for with ALL EXTERIOR, or with one surface: those within a part of the
/// size of the smaller body, less *CONTACT EXCLUSIONS. Pairs of two surfaces that are named are not among them.
/// @param tied  faces of ties and cuts, which touch nothing else @param joined  pairs that are a contact already
/// @param impossible  gets surfaces that do not exist
std::vector<FacingSurfaces> find_general_contacts(const Deck& deck, const Bodies& bodies, settings::Analysis analysis,
                                                  const std::vector<ElementFace>& tied,
                                                  const std::vector<JoinedFaces>& joined,
                                                  std::vector<Note>& impossible);

/// Whether a line of *CONTACT INCLUSIONS names two surfaces.
bool names_two_surfaces(const std::vector<std::string>& line);

}  // namespace creepcontact::deck
