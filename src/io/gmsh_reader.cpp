#include "creepcontact/io/gmsh_reader.hpp"

#include <fmt/ranges.h>
#include <gmsh.h>

#include <future>
#include <set>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "geo_constants.hpp"
#include "gmsh_import.hpp"
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

mesh::Mesh read(const std::filesystem::path& file, const GmshOptions& options, bool is_geo) {
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
  if (is_geo) {
    session.run([&] {
      set_order();  // the file may have had its own idea
      gmsh::model::mesh::generate(3);
    });
  }
  mesh::Mesh mesh;
  session.run([&] { mesh = import_model(file.string(), !is_geo); });
  return mesh;
}

}  // namespace

mesh::Mesh read_mesh(const std::filesystem::path& file, const GmshOptions& options) {
  const bool is_geo = file.extension() == ".geo";
  if (!is_geo && file.extension() != ".msh")
    throw ModelError(fmt::format("{}: unknown kind of mesh; .geo and .msh are read", file.string()));
  if (const std::string reason = why_unreadable(file); !reason.empty())
    throw ModelError(fmt::format("{}: {}", file.string(), reason));
  check_options(file, options, is_geo);
  // Gmsh sets the number of OpenMP threads of the thread that calls it; the program's own must keep its.
  return std::async(std::launch::async, [&] { return read(file, options, is_geo); }).get();
}

}  // namespace creepcontact::io
