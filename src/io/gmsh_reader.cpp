#include "creepcontact/io/gmsh_reader.hpp"

#include <fmt/ranges.h>
#include <gmsh.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <future>
#include <set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/io/msh_reader.hpp"
#include "geo_constants.hpp"
#include "gmsh_content.hpp"
#include "gmsh_session.hpp"

namespace creepcontact::io {
namespace {

void check_options(const std::filesystem::path& file, const GmshOptions& options, bool is_geo) {
  if (options.order != 1 && options.order != 2)
    throw ConfigError(fmt::format("mesh order is {}; it may be 1 or 2", options.order));
  if (options.parameters.empty()) return;
  if (!is_geo) throw ConfigError(fmt::format("{}: parameters are for .geo files only", file.string()));
  const std::set<std::string> constants = geo_constants(file);
  for (const auto& [name, value] : options.parameters) {
    if (constants.count(name) > 0) continue;
    throw ConfigError(fmt::format("{}: DefineConstant makes no number '{}'; it makes: {}", file.string(), name,
                                  constants.empty() ? "none" : fmt::format("{}", fmt::join(constants, ", "))));
  }
}

mesh::Mesh mesh_geometry(const std::filesystem::path& file, const GmshOptions& options) {
  const GmshSession session(file.string());
  const auto set_order = [&] {
    gmsh::option::setNumber("Mesh.ElementOrder", options.order);
    gmsh::option::setNumber("Mesh.SecondOrderIncomplete", 1);
  };
  session.set_variables(options.parameters);
  session.run([&] {
    set_order();
    gmsh::merge(file.string());
  });
  session.run([&] {
    set_order();  // the file may have had its own idea
    gmsh::model::mesh::generate(3);
  });
  MshContent content;
  session.run([&] { content = gmsh_content(); });
  return import_msh(content, file.string());
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) throw ModelError(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
  return bytes;
}

}  // namespace

mesh::Mesh read_mesh(const std::filesystem::path& file, const GmshOptions& options) {
  const bool is_geo = file.extension() == ".geo";
  if (!is_geo && file.extension() != ".msh")
    throw ModelError(fmt::format("{}: unknown kind of mesh; .geo and .msh are read", file.string()));
  if (!std::filesystem::is_regular_file(file)) throw ModelError(fmt::format("{}: no such file", file.string()));
  check_options(file, options, is_geo);
  if (!is_geo) return read_msh(bytes_of(file), file.string());
  // Gmsh sets the number of OpenMP threads of the thread that calls it; the program's own must keep its.
  return std::async(std::launch::async, [&] { return mesh_geometry(file, options); }).get();
}

}  // namespace creepcontact::io
