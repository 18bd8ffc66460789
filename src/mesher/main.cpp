/// creepcontact-mesher: meshes one geometry for creepcontact, in a process of its own, so that whatever the file does
/// to Gmsh ends here.

#include <fcntl.h>
#include <fmt/format.h>
#include <gmsh.h>
#include <sys/mman.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <functional>
#include <iostream>
#include <optional>

#include "cad.hpp"
#include "confinement.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/io/msh/mesher_protocol.hpp"
#include "creepcontact/io/msh/msh_writer.hpp"
#include "creepcontact/settings/mesh_formats.hpp"
#include "death.hpp"
#include "gmsh_content.hpp"
#include "med.hpp"
#include "unv_groups.hpp"

namespace creepcontact::mesher {
namespace {

using io::MesherRequest;
namespace status = io::mesher;

void start_gmsh() {
  gmsh::initialize(0, nullptr, false);  // false: no settings of the user's own
  gmsh::option::setNumber("General.Terminal", 1);
  gmsh::option::setNumber("General.NumThreads", 1);  // the mesh must not depend on the machine
  // An exception out of the parser would hide all errors but the first.
  gmsh::option::setNumber("General.AbortOnError", 0);
  gmsh::logger::start();
}

/// Gives variables their values, which DefineConstant then leaves alone. Only Gmsh's own language can, from a file.
void set_variables(const std::map<std::string, double>& values) {
  if (values.empty()) return;
  std::string text;
  for (const auto& [name, value] : values) text += fmt::format("{} = {};\n", name, value);  // names are identifiers
  const int file = ::memfd_create("parameters", 0);
  if (file < 0 || ::write(file, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
    throw ModelError("cannot pass the parameters to Gmsh: the system provides no memory file");
  gmsh::merge(fmt::format("/proc/self/fd/{}", file));
  ::close(file);
}

void set_order(int order) {
  gmsh::option::setNumber("General.Verbosity", 5);
  gmsh::option::setNumber("Mesh.ElementOrder", order);
  gmsh::option::setNumber("Mesh.SecondOrderIncomplete", 1);
}

double option(const char* name) {
  double value = 0;
  gmsh::option::getNumber(name, value);
  return value;
}

/// Errors are on the terminal already, unless the file has turned it off.
bool gmsh_has_failed() {
  if (option("General.Verbosity") < 1) {
    std::cerr << "Error   : the file sets General.Verbosity below 1, which hides errors; remove that" << std::endl;
    return true;
  }
  const bool is_told = option("General.Terminal") != 0;
  std::vector<std::string> lines;
  gmsh::logger::get(lines);
  bool failed = false;
  for (const std::string& line : lines) {
    if (!line.starts_with("Error")) continue;
    failed = true;
    if (!is_told) std::cerr << line << '\n';
  }
  return failed;
}

void send(const std::string& bytes) {
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t written = ::write(status::mesh_descriptor, bytes.data() + sent, bytes.size() - sent);
    if (written < 0) exit_at_once(status::gmsh_failed);  // nobody listens any more
    sent += written;
  }
}

int mesh(const MesherRequest& request) {
  be_expendable();
  start_gmsh();  // it looks for places to write to, and reads no file
  limit_memory(request.memory_limit_mb);
  // Before Gmsh interprets anything.
  const Network network = request.cad ? Network::fails : Network::ends;
  if (!request.trusted && !confine(network) && request.needs_confinement) return status::not_confined;
  set_variables(request.parameters);

  set_order(request.order);
  watch();
  if (request.file.extension() == ".med") {
    const io::MshContent content = read_med(request.file);
    stop_reading();
    send(io::write_msh(content));
    return status::done;
  }
  std::optional<io::CadFacts> cad;
  if (request.cad)
    cad = read_cad(request.file, *request.cad);
  else
    gmsh::merge(request.file.string());
  stop_reading();
  if (gmsh_has_failed()) return status::gmsh_failed;
  set_order(request.order);  // the file may have had its own idea
  const bool is_read = settings::is_converted_mesh(request.file.extension().string());
  if (!is_read) gmsh::model::mesh::generate(request.cad && request.cad->surfaces_only ? 2 : request.dimension);
  if (gmsh_has_failed()) return status::gmsh_failed;
  io::MshContent content = gmsh_content();
  if (request.file.extension() == ".unv") {
    if (const std::vector<NumberedGroup> groups = unv_groups(request.file); !groups.empty())
      set_groups(groups, content);
  }
  if ((is_read || cad) && content.physicals.empty()) name_entities(content);
  if (cad) send(cad->text() + '\n');
  send(io::write_msh(content));
  return status::done;
}

/// Gmsh throws texts.
int guarded(const MesherRequest& request) {
  std::string reason;
  try {
    return mesh(request);
  } catch (const std::string& text) {
    reason = text;
  } catch (const std::exception& error) {
    reason = error.what();
  } catch (...) {
    reason = "unknown reason";
  }
  std::cerr << "Error   : " << reason << std::endl;
  return status::gmsh_failed;
}

}  // namespace
}  // namespace creepcontact::mesher

int main(int argc, char** argv) {
  using namespace creepcontact;
  try {
    const auto request = io::MesherRequest::from(std::vector<std::string>(argv + 1, argv + argc));
    std::signal(SIGXFSZ, SIG_IGN);  // Gmsh tries whether it can write
    if (::fcntl(io::mesher::mesh_descriptor, F_SETFD, FD_CLOEXEC) != 0) return 2;
    const int status = mesher::guarded(request);
    std::fflush(nullptr);
    mesher::exit_at_once(status);
  } catch (const Error& error) {
    std::cerr << "error: " << error.what() << '\n';
    return error.exit_status();
  }
}
