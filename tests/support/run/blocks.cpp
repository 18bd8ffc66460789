#include "support/run/blocks.hpp"

#include <algorithm>

namespace creepcontact::run::test {

std::string separate_blocks() {
  return R"(SetFactory("OpenCASCADE");
e = 1e-3;
Box(1) = {0, 0, -2, 2, 1, 2};
Box(2) = {0, 0, 0, 2, 1, 1};
Transfinite Curve{1:24} = 3;
Transfinite Curve{9:12} = 4;
Transfinite Curve{21:24} = 5;
Transfinite Surface{1:12};
Recombine Surface{1:12};
Transfinite Volume{1:2};
Physical Surface("lower_top") = {6};
Physical Surface("upper_bottom") = {11};
)" + groups;
}

std::string joined_blocks() {
  return R"(SetFactory("OpenCASCADE");
e = 1e-3;
Box(1) = {0, 0, -2, 2, 1, 2};
Box(2) = {0, 0, 0, 2, 1, 1};
BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Delete; }
Transfinite Curve{:} = 3;
Transfinite Surface{:};
Recombine Surface{:};
Transfinite Volume{:};
joint() = Surface In BoundingBox{-e, -e, -e, 9, 9, e};
Physical Surface("lower_top") = {joint()};
Physical Surface("upper_bottom") = {joint()};
)" + groups;
}

Case::Case(const std::string& geometry) {
  io::test::write_text(directory_ / "blocks.geo", geometry);
}

config::Config Case::config(const std::string& more, const std::vector<std::string>& overrides) const {
  return parse(case_text + more, overrides);
}

config::Config Case::parse(const std::string& text, const std::vector<std::string>& overrides) const {
  return config::parse(text, directory_ / "case.toml", vocabulary(), overrides);
}

std::string Case::position(const std::string& text, const std::string& more) const {
  const std::string whole = case_text + more;
  const std::size_t at = whole.find(text);
  const auto line = 1 + std::count(whole.begin(), whole.begin() + at, '\n');
  const std::size_t column = at - (at == 0 ? 0 : whole.rfind('\n', at - 1));
  return (directory_ / "case.toml").string() + ":" + std::to_string(line) + ":" + std::to_string(column) + ": ";
}

System::System(const config::Config& config)
    : model(build_model(config)),
      solver(model.assembly, model.solver, watch),
      rate(solver, creep::survey_elastic_stress(solver, config.time.output, model.breakpoints), config.time.tolerance,
           watch) {}

}  // namespace creepcontact::run::test
