#include "creepcontact/plot/vtk_process.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <string_view>

#include "creepcontact/base/error.hpp"
#include "creepcontact/platform/child_process.hpp"
#include "creepcontact/platform/replace_file.hpp"

// picture.py, embedded by assets.S
extern "C" const char creepcontact_picture_script_begin[];
extern "C" const char creepcontact_picture_script_end[];

namespace creepcontact::plot {
namespace {

/// The system's Python has its VTK; another one on the PATH may have its own.
std::filesystem::path python() {
  for (const char* place : {"/usr/bin/python3", "/usr/local/bin/python3"})
    if (::access(place, X_OK) == 0) return place;
  throw ConfigError(
      "pictures of bodies are drawn by VTK in Python, which is not installed (Debian: apt-get install "
      "python3-vtk9 xvfb)");
}

}  // namespace

void draw_by_vtk(const std::string& jobs, const std::filesystem::path& place) {
  platform::replace_file(place / "jobs.json", jobs);
  // Isolated (-I), and in a directory of its own: neither modules that lie in the working directory or in a directory
  // of results nor those of the user's settings and environment are imported.
  platform::Pipe pipe;
  platform::ChildProcess process(
      {.program = python(),
       .arguments = {"-I", "-c", std::string(creepcontact_picture_script_begin, creepcontact_picture_script_end),
                     (place / "jobs.json").string()},
       .descriptors = {{pipe.writing_end(), STDOUT_FILENO}, {pipe.writing_end(), STDERR_FILENO}},
       .directory = place});
  pipe.close_writing_end();
  std::string messages = platform::read_to_end(pipe);
  if (process.wait() == 0) return;
  while (!messages.empty() && messages.back() == '\n') messages.pop_back();
  const std::string last = messages.substr(messages.rfind('\n') + 1);
  if (messages.find("apt-get install") != std::string::npos) throw ConfigError(fmt::format("no picture: {}", last));
  throw Error(fmt::format("no picture: the process that draws it failed: {}", last.empty() ? "no message" : last), 4);
}

}  // namespace creepcontact::plot
