#pragma once
/// Pictures of bodies: their surfaces in one colour each, shaded, with marked faces, edges and points.

#include <filesystem>
#include <string>
#include <vector>

#include "creepcontact/base/tensor.hpp"

namespace creepcontact::plot {

/// A plane polygon of the surface of a body, corners counterclockwise as seen from outside. In flat pictures a cell in
/// the plane z = 0.
struct Facet {
  std::vector<Vector3> corners;
  int body = 0;   ///< index into SolidPicture::bodies
  int mark = -1;  ///< index into SolidPicture::marks; -1: none
};

/// A marked edge (two corners or more) or point (one corner).
struct MarkedLine {
  std::vector<Vector3> corners;
  int body = 0, mark = 0;
};

/// A mark, and the family of its colours.
struct SolidMark {
  enum class Kind { support, load, contact };
  std::string name;
  Kind kind = Kind::support;
};

struct SolidPicture {
  std::string title = {};
  bool flat = false;  ///< seen along z with axes of coordinates; else projected, from the front and from behind
  std::string length_unit = {};
  std::vector<std::string> bodies = {};
  std::vector<SolidMark> marks = {};
  std::vector<Facet> facets = {};
  std::vector<MarkedLine> lines = {};
};

/// The job that draws it, as in src/plot/picture.py. Solids are seen from the front and from behind, all bodies and
/// each body alone (of the first four), since contact surfaces hide each other.
std::string picture_job(const SolidPicture& picture, const std::filesystem::path& output);

/// Draws it as a PNG file. The directory must exist. @throws as draw_by_vtk()
void draw(const SolidPicture& picture, const std::filesystem::path& file);

}  // namespace creepcontact::plot
