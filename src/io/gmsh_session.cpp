#include "gmsh_session.hpp"

#include <fmt/format.h>
#include <gmsh.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <new>
#include <vector>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"

/// Gmsh's own, declared in none of its installed headers; weak: absent in versions that hide it.
class FunctionManager {
 public:
  [[gnu::weak]] static FunctionManager* Instance();
  [[gnu::weak]] void clear();
};

namespace creepcontact::io {
namespace {

/// Gmsh 4.8 keeps the macros of a .geo beyond the session, with the file they stood in, and crashes where a later
/// session calls one of the same name.
void forget_macros() {
  if (&FunctionManager::Instance != nullptr) FunctionManager::Instance()->clear();
}

/// Text that is a file for the life of the object.
class TemporaryGeo {
 public:
  explicit TemporaryGeo(const std::string& text) {
    std::error_code error;
    path_ = std::filesystem::temp_directory_path(error) / "creepcontact_XXXXXX.geo";
    if (error) {
      const char* const given = std::getenv("TMPDIR");
      throw ConfigError(fmt::format("no directory for temporary files{}: {}; set TMPDIR to one that exists",
                                    given ? fmt::format(" '{}' (TMPDIR)", given) : "", error.message()));
    }
    std::string pattern = path_.string();
    const int file = ::mkstemps(pattern.data(), 4);
    if (file < 0) throw ModelError(fmt::format("cannot write '{}'", path_.string()));
    path_ = pattern;
    const auto written = ::write(file, text.data(), text.size());
    ::close(file);
    if (written != static_cast<ssize_t>(text.size())) throw ModelError(fmt::format("cannot write '{}'", pattern));
  }
  ~TemporaryGeo() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  TemporaryGeo(const TemporaryGeo&) = delete;
  TemporaryGeo& operator=(const TemporaryGeo&) = delete;
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

/// What Gmsh logged as errors since the session began, a line each, the first ones; its warnings go to the log.
std::string take_errors(const std::string& name) {
  std::vector<std::string> lines;
  gmsh::logger::get(lines);
  gmsh::logger::stop();
  gmsh::logger::start();
  constexpr int told = 5;
  std::string errors;
  int found = 0;
  bool extrusions_touch = false;
  for (const std::string& line : lines) {
    if (line.starts_with("Error: ") && ++found <= told) errors += "\n  " + line.substr(7);
    if (line.starts_with("Warning: ")) log::warning("{}: Gmsh: {}", name, line.substr(9));
    extrusions_touch |= line.find("extruded node") != std::string::npos;
  }
  if (found > told) errors += fmt::format("\n  and {} more, which may follow from these", found - told);
  if (extrusions_touch)
    errors += "\n  (bodies that touch need SetFactory(\"OpenCASCADE\"): the built-in kernel makes their faces one)";
  return errors;
}

}  // namespace

GmshSession::GmshSession(std::string name) : name_(std::move(name)) {
  gmsh::initialize(0, nullptr, false);
  forget_macros();
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber("General.NumThreads", 1);  // the mesh must not depend on the machine
  // An exception out of the parser would leave it with the rest of the file, for the next file to stumble over.
  gmsh::option::setNumber("General.AbortOnError", 0);
  gmsh::logger::start();
}

GmshSession::~GmshSession() {
  try {
    gmsh::logger::stop();
    gmsh::finalize();
  } catch (...) {
    log::debug("{}: the Gmsh library did not finish cleanly", name_);
  }
}

void GmshSession::run(const std::function<void()>& calls) const {
  std::string reason;
  bool failed = true;
  try {
    calls();
    failed = false;
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::string& text) {
    reason = text;
  } catch (const std::exception& error) {
    reason = error.what();
  } catch (...) {
    reason = "unknown reason";
  }
  const std::string errors = take_errors(name_);
  if (failed || !errors.empty()) {
    throw ModelError(fmt::format("{}: Gmsh failed:{}", name_, errors.empty() ? "\n  " + reason : errors));
  }
}

void GmshSession::set_variables(const std::map<std::string, double>& values) const {
  // Variables outlive the library's finalize(); only its own language can delete them, and only from a file.
  std::string text = "Delete Variables;\n";
  for (const auto& [variable, value] : values) text += fmt::format("{} = {};\n", variable, value);
  const TemporaryGeo prelude(text);
  run([&] {
    gmsh::onelab::clear();
    gmsh::merge(prelude.path());
  });
}

}  // namespace creepcontact::io
