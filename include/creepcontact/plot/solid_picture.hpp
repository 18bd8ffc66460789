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

/// What is marked, and its group of colours.
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

/// The gnuplot commands that draw `<stem>.svg`, or `<stem>.png` with format='png'. Solids have two views of all bodies,
/// one from the front and one from behind, and the same of each body alone, since contact surfaces hide each other (of
/// the first four). Painter's algorithm: facets that face away are left out, the others are painted from back to front.
std::string gnuplot_script(const SolidPicture& picture, const std::string& stem);

/// Writes `<stem>.gp` and draws `<stem>.svg` and `<stem>.png`. Makes the directory if necessary.
/// @throws as draw(Figure)
void draw(const SolidPicture& picture, const std::filesystem::path& directory, const std::string& stem);

}  // namespace creepcontact::plot
