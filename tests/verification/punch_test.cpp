/// Flat punches with a sharp edge on a half space: the pressure up to near the edge, and its smoothness.

#include "verification/boxes.hpp"
#include "verification/contact_state.hpp"
#include "verification/half_space.hpp"
#include "verification/reference/punch.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace {

using test::HalfSpace;

struct Case {
  std::string name;
  int fine, divisions;  // elements along the patch of the half space; along the punch
  std::string slave;
};

TEST(Punch, ExplorePlane) {
  for (const int order : {1, 2})
    for (const auto& [fine, divisions] : {std::pair(12, 8), std::pair(16, 8), std::pair(14, 10), std::pair(24, 10), std::pair(14, 20), std::pair(28, 20)})
      for (const char* slave : {"auto", "punch_z0", "base_patch"}) {
        const double width = 0.1;
        const HalfSpace base{"base", 0, -1, 1.5, fine, 30, 10, 12, width};
        const std::vector<test::Box> punch{{"punch", {0, 0, 0}, {1, width, 1}, {divisions, 1, 4}}};
        std::string toml = "[mesh]\nfile = \"case.geo\"\n" + test::body("base", 1, 0.3) + test::body("punch", 1e4, 0.3) +
                           test::half_space_supports(base, 0) + test::support("punch_x0", "x") +
                           test::support("punch_y0", "y") + test::support("punch_y1", "y") +
                           test::support("punch_z1", "z", "-0.01") +
                           test::contact("punch_z0", "base_patch", std::string("slave = \"") + slave + "\"") +
                           "[time]\nend = 1\n" + test::probe("force", "contact_force_z", "on = \"punch_z0\"") +
                           test::probe("area", "contact_area", "on = \"punch_z0\"");
        const auto state = test::contact_state(toml, test::boxes_geo(punch) + test::half_space_geo(base),
                                               {"mesh.order=" + std::to_string(order)});
        const double force = 2 * state.probes.at("force") / width;
        std::map<double, double> profile;
        for (const auto& p : state.pairs.at("punch_z0/base_patch"))
          if (p.place.y() < 0.5 * width) profile[p.place.x()] = p.pressure;
        std::printf("order %d fine %d divisions %d slave %s area %.4f:", order, fine, divisions,
                    state.slave.begin()->second.c_str(), state.probes.at("area") / width);
        for (const auto& [x, pressure] : profile)
          std::printf(" %.3f:%+.2f%%", x, x < 1 ? 100 * (pressure / reference::flat_punch(force, 1, x) - 1) : pressure * 3.14159 / force*100);
        std::printf("\n");
      }
}

}  // namespace
}  // namespace creepcontact
