#include <fmt/format.h>

#include <filesystem>
#include <iostream>

#include "command.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/config/reader.hpp"
#include "creepcontact/platform/replace_file.hpp"
#include "creepcontact/run/faces.hpp"
#include "creepcontact/run/vocabulary.hpp"
#include "model_page.hpp"

namespace creepcontact::cli {
namespace {

constexpr std::size_t listed_faces = 200;

}  // namespace

int faces(const Command& self, const Arguments& arguments) {
  namespace po = boost::program_options;
  std::string proposal, unit;
  bool as_json = false, all = false;
  double distance = 0;
  CommandLine line(self);
  line.add_options()("propose,p", po::value(&proposal)->value_name("FILE.toml"),
                     "write a configuration with the bodies and with a contact for each pair of faces that is found");
  line.add_options()("json", po::bool_switch(&as_json), "print one JSON object, with all faces");
  line.add_options()("all", po::bool_switch(&all), "list all faces, however many there are");
  line.add_options()("distance", po::value(&distance)->value_name("D"),
                     "within which faces of different bodies are next to each other (default: half a per cent of the "
                     "model, at most a twentieth of the smallest body)");
  line.add_options()("unit", po::value(&unit)->value_name("UNIT"),
                     "unit of the lengths: mm (default), m, cm, um, km, in, ft; a CAD model is converted to it");
  add_trust(line);
  if (!line.parse(arguments, "FILE: a CAD model, a mesh, or a configuration")) return 0;
  const std::filesystem::path file = line.positional();
  config::Config config = file.extension() == ".toml" ? config::read(file, run::vocabulary()) : mesh_alone(file, unit);
  config.mesh.trust_geometry = line.has(trust_option);
  const model::ModelFaces found = model::model_faces(config, distance);
  std::cout << (as_json ? run::faces_json(found, file.string())
                        : run::faces_text(found, file.string(), all ? found.patches.size() : listed_faces));
  if (proposal.empty()) return 0;
  if (path_exists(proposal)) throw ConfigError(fmt::format("'{}' exists; name a new file, or remove it", proposal));
  platform::replace_file(proposal, run::proposed_configuration(found, config.mesh.file, proposal, run::vocabulary()));
  if (!as_json) std::cout << "\nproposed: " << proposal << '\n';
  return 0;
}

}  // namespace creepcontact::cli
