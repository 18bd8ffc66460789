/// Stands in for creepcontact-mesher in tests that are not about meshing: a .geo that the mesher has meshed before,
/// with the same text and options, is not meshed again. Most of a small test is otherwise the start of Gmsh. All else
/// is left to the mesher itself: files that read others, trusted ones, what failed or was warned of.

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "creepcontact/io/msh/mesher_protocol.hpp"

namespace creepcontact::test {
namespace {

namespace fs = std::filesystem;
using io::mesher::mesh_descriptor;

const fs::path mesher = CREEPCONTACT_REAL_MESHER, gmsh = CREEPCONTACT_GMSH_LIBRARY, store = CREEPCONTACT_MESH_STORE;

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Changes whenever the file is made anew.
std::string version(const fs::path& file) {
  struct stat state {};
  ::stat(file.c_str(), &state);
  return fmt::format("{} {} {}.{}\n", file.string(), state.st_size, state.st_mtim.tv_sec, state.st_mtim.tv_nsec);
}

/// Whether Gmsh may look at another file, or around itself, for it: whether one of these is among the words.
bool looks_around(const std::string& text) {
  static const std::set<std::string, std::less<>> telling{
      "Include",    "Merge",      "MergeWithBoundingBox", "Open",
      "FileExists", "Exists",     "ShapeFromFile",        "GetEnv",
      "OnelabRun",  "CurrentDir", "CurrentDirectory",     "AbsolutePath",
      "DirName"};
  const auto in_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (auto begin = text.begin(); begin != text.end();) {
    begin = std::find_if(begin, text.end(), in_word);
    const auto end = std::find_if_not(begin, text.end(), in_word);
    if (telling.count(std::string_view(begin, end)) > 0) return true;
    begin = end;
  }
  return false;
}

/// All that the mesh depends on; empty if that may be more than the text of the file.
std::string key_of(const std::vector<std::string>& arguments) {
  const io::MesherRequest request = io::MesherRequest::from(arguments);
  std::error_code failure;
  if (request.trusted || request.needs_confinement || request.file.extension() != ".geo" ||
      !fs::is_regular_file(request.file, failure))
    return "";
  const std::string text = contents(request.file);
  if (looks_around(text)) return "";
  std::string key = version(mesher) + version(gmsh);
  for (auto argument = arguments.begin() + 1; argument != arguments.end(); ++argument) key += *argument + '\n';
  return key + text + '\0';
}

bool send(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// Replaces this process.
[[noreturn]] void become_mesher(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), mesher.string());
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  ::execv(mesher.c_str(), pointers.data());
  ::_exit(127);
}

struct Meshing {
  int status = 0;
  std::string mesh, log;
};

/// Runs the mesher; its messages are passed on as they come.
Meshing run_mesher(const std::vector<std::string>& arguments) {
  std::array<int, 2> mesh_pipe{}, log_pipe{};
  if (::pipe(mesh_pipe.data()) != 0 || ::pipe(log_pipe.data()) != 0) become_mesher(arguments);
  const pid_t child = ::fork();
  if (child < 0) become_mesher(arguments);
  if (child == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::dup2(mesh_pipe[1], mesh_descriptor);
    ::dup2(log_pipe[1], STDOUT_FILENO);
    ::dup2(log_pipe[1], STDERR_FILENO);
    for (const int end : {mesh_pipe[0], mesh_pipe[1], log_pipe[0], log_pipe[1]})
      if (end > mesh_descriptor) ::close(end);
    become_mesher(arguments);
  }
  ::close(mesh_pipe[1]);
  ::close(log_pipe[1]);
  Meshing meshing;
  std::array<pollfd, 2> ends{{{mesh_pipe[0], POLLIN, 0}, {log_pipe[0], POLLIN, 0}}};
  std::array<char, 1 << 16> buffer{};
  while (ends[0].fd >= 0 || ends[1].fd >= 0) {
    if (::poll(ends.data(), ends.size(), -1) <= 0) continue;
    for (pollfd& end : ends) {
      if (end.fd < 0 || end.revents == 0) continue;
      const ssize_t count = ::read(end.fd, buffer.data(), buffer.size());
      if (count < 0 && errno == EINTR) continue;
      const std::string_view bytes(buffer.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
      if (bytes.empty()) {
        end.fd = -1;
      } else if (&end == &ends[0]) {
        meshing.mesh += bytes;
      } else {
        meshing.log += bytes;
        send(STDOUT_FILENO, bytes);
      }
    }
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  meshing.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return meshing;
}

bool is_worth_keeping(const Meshing& meshing) {
  if (meshing.status != io::mesher::done || meshing.mesh.empty()) return false;
  for (const char* word : {"Warning", "Error", io::mesher::mark})
    if (meshing.log.find(word) != std::string::npos) return false;
  return true;
}

/// Under a name that others do not see before it is complete.
void keep(const fs::path& entry, const std::string& bytes) {
  std::error_code failure;
  fs::create_directories(store, failure);
  const fs::path unfinished = fmt::format("{}.{}", entry.string(), ::getpid());
  std::ofstream stream(unfinished, std::ios::binary);
  stream << bytes;
  stream.close();
  if (stream) fs::rename(unfinished, entry, failure);
  fs::remove(unfinished, failure);
}

int mesh(const std::vector<std::string>& arguments) {
  const std::string key = key_of(arguments);
  if (key.empty()) become_mesher(arguments);
  const fs::path entry = store / fmt::format("{:016x}", std::hash<std::string>()(key));
  const std::string kept = contents(entry);
  if (kept.starts_with(key)) return send(mesh_descriptor, std::string_view(kept).substr(key.size())) ? 0 : 2;
  const Meshing meshing = run_mesher(arguments);
  if (is_worth_keeping(meshing)) keep(entry, key + meshing.mesh);
  if (!meshing.mesh.empty()) send(mesh_descriptor, meshing.mesh);
  return meshing.status;
}

}  // namespace
}  // namespace creepcontact::test

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);
  return creepcontact::test::mesh({argv + 1, argv + argc});
}
