#include <fmt/format.h>

#include <iostream>

#include "command.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/plot/figure.hpp"
#include "creepcontact/run/material_view.hpp"

namespace creepcontact::cli {

int material(const Command& self, const Arguments& arguments) {
  namespace po = boost::program_options;
  run::MaterialViewOptions options;
  std::string directory;
  double temperature = 0;
  CommandLine line(self);
  line.add_options()("temperature,t", po::value(&temperature)->value_name("T"),
                     "in the unit of the library (default: that of the first check of the data)");
  line.add_options()("law,l", po::value(&options.variant)->value_name("VARIANT"), "only this variant");
  line.add_options()("output,o", po::value(&directory)->value_name("DIR"), "draw pictures into this directory");
  if (!line.parse(arguments, "NAME of a steel; creepcontact list materials shows them")) return 0;
  if (line.has("temperature")) options.temperature = temperature;
  const run::MaterialView view = run::material_view(line.positional(), options);
  std::cout << view.text;
  if (directory.empty()) return 0;
  for (const plot::NamedFigure& figure : view.figures) {
    plot::draw(figure.figure, directory, figure.name);
    for (const char* const suffix : {".svg", ".png"})
      std::cout << (std::filesystem::path(directory) / (figure.name + suffix)).string() << '\n';
  }
  return 0;
}

}  // namespace creepcontact::cli
