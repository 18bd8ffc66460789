#pragma once
/// A page that shows a model before its run: bodies, faces, and what acts on them. One file, which needs no network.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace creepcontact::report {

struct ModelPage {
  struct Body {
    std::string name;
    std::size_t first_triangle = 0, n_triangles = 0;
    std::size_t first_edge = 0, n_edges = 0;
  };
  struct Face {
    int number = 0;
    std::size_t body = 0;
    std::string kind, text;            ///< "cylinder, hollow", "radius 30, axis z through (0, 0, 5)"
    std::vector<std::string> names;    ///< of groups and surfaces that have all of it
    std::vector<std::string> next_to;  ///< "touches: 8 of 'pin'"
    std::size_t first_triangle = 0, n_triangles = 0;
  };
  /// A group or surface and what the configuration does with it.
  struct Group {
    std::string name;
    std::vector<std::string> uses;  ///< "support: x = 0"
    std::vector<int> faces;
  };

  std::string title, length_unit;
  std::vector<std::string> notes;  ///< sentences above the picture
  bool flat = false;               ///< a section in the plane z = 0
  std::vector<float> positions;    ///< 3 per point; faces share none
  std::vector<std::uint32_t> triangles, edges;
  std::vector<Body> bodies;
  std::vector<Face> faces;
  std::vector<Group> groups;
  std::vector<float> distances;  ///< per point: from the body next to it; NaN: none
};

/// Replaces the file, whole. @throws ConfigError if its directory cannot be made, or if the program was built without
/// the interactive view; Error if the disk is full
void write_model_page(const ModelPage& page, const std::filesystem::path& file);

}  // namespace creepcontact::report
