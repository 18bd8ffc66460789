#pragma once
/// Geometry of a cylinder or a sphere resting on a block at the origin, a half slice or a quarter, with elements that
/// grow away from the contact.

#include <string>

namespace creepcontact::test {

struct RoundOnBlock {
  bool sphere;
  double radius;  ///< also the extent of the block
  double fine;    ///< elements have `size` closer to the origin than this
  double size;
  double width = 0;  ///< of the cylinder's slice, one element wide
};

/// Groups: volumes upper (round), lower (block); surfaces upper_round, upper_far (the flat top through the centre),
/// lower_top, lower_far, and <body>_x0, <body>_y0, for a slice also <body>_back.
std::string round_on_block_geo(const RoundOnBlock& bodies);

}  // namespace creepcontact::test
