#include "creepcontact/io/msh/gmsh_reader.hpp"

#include <fmt/ranges.h>

#include <cmath>

#include "../file_text.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/settings/mesh_formats.hpp"
#include "geo_scan.hpp"
#include "mesher_process.hpp"
#include "msh_reader.hpp"

namespace creepcontact::io {
namespace {

void check_options(const std::filesystem::path& file, const GmshOptions& options, bool is_geo) {
  if (options.order != 1 && options.order != 2)
    throw ConfigError(fmt::format("mesh order is {}; allowed: 1 or 2", options.order));
  if (!options.parameters.empty() && !is_geo)
    throw ConfigError(fmt::format("{}: parameters are for .geo files only", file.string()));
}

void check_parameters(const std::filesystem::path& file, const GmshOptions& options, const GeoScan& scan) {
  for (const auto& [name, value] : options.parameters) {
    if (!is_identifier(name))
      throw ConfigError(
          fmt::format("mesh.parameters: '{}' is not the name of a constant; a name consists of letters, digits and "
                      "underscores, and does not begin with a digit",
                      name));
    if (!std::isfinite(value))
      throw ConfigError(fmt::format("mesh.parameters.{} is {}; allowed: finite numbers", name, value));
    if (scan.constants.count(name) > 0) continue;
    throw ConfigError(
        fmt::format("{}: DefineConstant defines no number '{}'; it defines: {}", file.string(), name,
                    scan.constants.empty() ? "none" : fmt::format("{}", fmt::join(scan.constants, ", "))));
  }
}

void refuse_reaching_out(const GeoScan& scan) {
  std::string lines;
  for (const GeoStatement& statement : scan.reaching_out) {
    lines += fmt::format("{}{}:{}: '{}' runs a program, writes a file or ends Gmsh", lines.empty() ? "" : "\n",
                         statement.file, statement.line, statement.word);
  }
  if (lines.empty()) return;
  throw ModelError(lines +
                   "\nThe mesh needs no such statement: remove it, or add --trust-geometry if you trust the file");
}

/// Rather than a mesh without the groups that the user sees in the file.
void refuse_lost_statements(const GeoScan& scan) {
  if (scan.lost.empty()) return;
  throw ModelError(
      fmt::format("{}:{}: the last line has several statements and no line end, and Gmsh would take the first of them "
                  "alone; end the file with a new line",
                  scan.lost[0].file, scan.lost[0].line));
}

mesh::Mesh mesh_geo(const std::filesystem::path& file, const GmshOptions& options) {
  const GeoScan scan = scan_geo(file);
  check_parameters(file, options, scan);
  if (!options.trusted) refuse_reaching_out(scan);
  refuse_lost_statements(scan);
  const MesherRequest request{.file = file,
                              .dimension = options.section.dimension(),
                              .order = options.order,
                              .parameters = options.parameters,
                              .memory_limit_mb = options.memory_limit_mb,
                              .trusted = options.trusted,
                              .needs_confinement = !scan.unclear.empty()};
  return read_msh(run_mesher(request, options.time_limit), file.string(), options.section);
}

/// A mesh in a format that Gmsh reads.
mesh::Mesh convert(const std::filesystem::path& file, const GmshOptions& options) {
  const MesherRequest request{.file = file,
                              .dimension = options.section.dimension(),
                              .order = options.order,
                              .parameters = {},
                              .memory_limit_mb = options.memory_limit_mb,
                              .trusted = options.trusted};
  return read_msh(run_mesher(request, options.time_limit), file.string(), options.section);
}

}  // namespace

mesh::Mesh read_mesh(const std::filesystem::path& file, const GmshOptions& options) {
  const std::string extension = file.extension().string();
  const bool is_geo = extension == ".geo", is_msh = extension == ".msh";
  if (settings::is_cad_file(extension) || extension == ".inp")
    throw ModelError(
        fmt::format("{}: not a mesh of Gmsh; CAD models and decks have readers of their own", file.string()));
  if (!settings::is_mesh_file(extension))
    throw ModelError(
        fmt::format("{}: unknown kind of mesh file; allowed: {}", file.string(), settings::mesh_files_in_words));
  if (const std::string reason = why_unreadable(file); !reason.empty())
    throw ModelError(fmt::format("{}: {}", file.string(), reason));
  check_options(file, options, is_geo);
  if (is_msh) return read_msh(file_text<ModelError>(file), file.string(), options.section);
  return is_geo ? mesh_geo(file, options) : convert(file, options);
}

}  // namespace creepcontact::io
