#pragma once
/// What is known of a problem of heat before it is solved: how fast bodies follow their surfaces, and whether their
/// elements are fine enough for their films.

#include <cstddef>
#include <span>
#include <vector>

#include "creepcontact/heat/conduction.hpp"

namespace creepcontact::heat {

/// How fast a body follows.
struct HeatingThrough {
  double depth = 0;  ///< volume over the surface through which heat comes; 0: none comes
  double time = 0;   ///< of the run: depth squared over the diffusivity
};

/// How a temperature that acts on a body jumps.
struct Jumps {
  double first = 0;  ///< against the body, at the start
  double later = 0;  ///< the largest one of a table in t
  double range = 0;  ///< against the body, at any time
};

/// How fine the elements at a film are.
struct FilmFigures {
  std::size_t flow = 0;     ///< of Definition::flows
  double coefficient = 0;   ///< the largest one
  double element_size = 0;  ///< from the surface inwards, where the Biot number is largest
  double biot = 0;          ///< of the elements: coefficient times their size over the conductivity
  Jumps jumps = {};         ///< of the fluid; where the coefficient jumps, of that with as much heat
};

struct GivenFigures {
  std::size_t given = 0;  ///< of Definition::given
  Jumps jumps = {};
};

struct Figures {
  std::vector<HeatingThrough> bodies;
  std::vector<FilmFigures> films;
  std::vector<GivenFigures> given;
};

/// @param start  temperatures by body, at which properties are taken @param end  of the run
/// Cost: a pass through the cells
Figures figures(const Definition& definition, std::span<const double> start, double end);

}  // namespace creepcontact::heat
