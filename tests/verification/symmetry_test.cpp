/// Contacts that planes of symmetry cut: results of half and quarter models against those of the whole.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verification/boxes.hpp"
#include "verification/case.hpp"
#include "verification/plane_regions.hpp"
#include "verification/rings.hpp"

namespace creepcontact {
namespace symmetry_cases {
namespace {

struct CutCase {
  const char* name;
  int order;
  const char* contact;  ///< keys of the contact
  bool quarter;
  double A;  ///< creep rate at unit stress; 0: elastic
};

std::string model(const CutCase& of, bool whole) {
  std::string toml = fmt::format("[mesh]\nfile = \"case.geo\"\norder = {}\n", of.order) +
                     test::body("low", 1000, 0.3, of.A, 3) + test::body("up", 400, 0.3, of.A, 3);
  toml += "[time]\nend = 1\noutput = [0.5, 1]\n" +
          std::string(of.A > 0 ? "integrator = \"explicit_euler\"\nstep = 0.25\n" : "");
  toml += "[contact_solver]\ntolerance = 1e-12\ninitial_substeps = 4\n";
  for (const char* component : {"x", "y", "z"}) toml += test::support("low_z0", component);
  toml += test::support("up_z1", "y") + test::support("up_z1", "z", "\"-0.003*(1 + t)\"");
  toml += test::support("up_z1", "x", of.quarter ? "0" : "\"0.002*t\"");
  if (!whole)
    for (const char* body : {"low", "up"}) {
      toml += test::support(body + std::string("_y0"), "y");
      if (of.quarter) toml += test::support(body + std::string("_x0"), "x");
    }
  toml += test::contact_table("up_z0", "low_z1", of.contact);
  for (const char* reduce : {"min", "max"}) {
    const std::string at = fmt::format("on = \"up_z0\"\nreduce = \"{}\"", reduce);
    for (const std::string quantity : {"contact_pressure", "contact_shear", "slip", "contact_status"})
      if (quantity != "slip" || std::string(of.contact).find("tied") == std::string::npos)
        toml += test::probe(fmt::format("{}_{}", quantity, reduce), quantity, at);
    for (const char* body : {"low", "up"})
      for (const char* quantity : {"displacement_x", "displacement_z"})
        toml += test::probe(fmt::format("{}_{}_{}", body, quantity, reduce), quantity,
                            fmt::format("body = \"{}\"\nreduce = \"{}\"", body, reduce));
  }
  // At single points stresses are smoothed, in which a plane of symmetry is an end of the body.
  for (const char* body : {"low", "up"})
    for (const char* quantity : {"von_mises", "stress_zz", "creep_strain_equivalent"})
      toml += test::probe(fmt::format("{}_{}_mean", body, quantity), quantity,
                          fmt::format("body = \"{}\"\nreduce = \"mean\"", body));
  for (const char* quantity : {"contact_force_x", "contact_force_z", "contact_area"})
    toml += test::probe(std::string("sum_") + quantity, quantity, "on = \"up_z0\"");
  return toml;
}

std::string geo(const CutCase& of, bool whole) {
  const int nx = of.quarter && !whole ? 1 : 2, ny = whole ? 2 : 1;
  const double x0 = nx == 2 ? 1 : 0, y0 = ny == 2 ? 1 : 0;
  const auto box = [&](const char* name, double lx, double ly, double z, double lz, int m, int n) {
    return test::Box{name, {-x0 * lx, -y0 * ly, z}, {nx * lx, ny * ly, lz}, {nx * m, ny * n, 2}};
  };
  return test::boxes_geo({box("low", 1.5, 1.25, -1, 1, 3, 2), box("up", 1, 0.8, 0, 0.7, 2, 3)});
}

class CutModels : public testing::TestWithParam<CutCase> {};

TEST_P(CutModels, AreAsTheWhole) {
  const CutCase& of = GetParam();
  const test::Table whole = test::run_case(model(of, true), geo(of, true)).history,
                    part = test::run_case(model(of, false), geo(of, false)).history;
  const double parts = of.quarter ? 4 : 2;
  for (const std::string& name : whole.names()) {
    const bool is_odd = name == "sum_contact_force_x" || name.find("displacement_x") != std::string::npos;
    if (name == "time" || (of.quarter && is_odd)) continue;
    const double factor = name.starts_with("sum_") ? parts : 1;
    double scale = 0;
    for (const std::string& other : whole.names())  // min and max have one scale
      if (other.substr(0, other.rfind('_')) == name.substr(0, name.rfind('_')))
        for (const double value : whole.column(other)) scale = std::max(scale, std::abs(value));
    for (std::size_t row = 0; row < whole.rows(); ++row)
      EXPECT_NEAR(factor * part.column(name)[row], whole.column(name)[row], 1e-8 * scale + 1e-14) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, CutModels,
                         testing::Values(CutCase{"friction", 1, "friction = 0.3", false, 0},
                                         CutCase{"friction_creep", 1, "friction = 0.3", false, 1e-5},
                                         CutCase{"friction_quarter", 1, "friction = 0.3", true, 0},
                                         CutCase{"friction_order2", 2, "friction = 0.3", false, 0},
                                         CutCase{"tied", 1, "type = \"tied\"", false, 0},
                                         CutCase{"tied_quarter", 2, "type = \"tied\"", true, 0},
                                         CutCase{"tied_low_slave", 1, "type = \"tied\"\nslave = \"low_z1\"", false, 0},
                                         CutCase{"tied_creep", 1, "type = \"tied\"", false, 1e-5}),
                         [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace symmetry_cases
}  // namespace creepcontact
