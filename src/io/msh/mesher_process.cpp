#include "mesher_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/platform/child_process.hpp"
#include "creepcontact/platform/companions.hpp"
#include "mesher_log.hpp"

namespace creepcontact::io {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

const char* const remedy_by_hand =
    "Or mesh the file with Gmsh yourself (gmsh -3, for a section -2, FILE.geo -format msh41 -o FILE.msh) and name the "
    ".msh in mesh.file";

class Mesher {
 public:
  Mesher(const MesherRequest& request, double time_limit)
      : request_(request),
        time_limit_(time_limit),
        process_({find_mesher(),
                  request.arguments(),
                  {{log_pipe_.writing_end(), STDOUT_FILENO},
                   {log_pipe_.writing_end(), STDERR_FILENO},
                   {mesh_pipe_.writing_end(), mesher::mesh_descriptor}},
                  SIGKILL}) {
    log_pipe_.close_writing_end();
    mesh_pipe_.close_writing_end();
    ::fcntl(log_pipe_.reading_end(), F_SETFL, O_NONBLOCK);
  }
  ~Mesher() { process_.kill(); }
  Mesher(const Mesher&) = delete;
  Mesher& operator=(const Mesher&) = delete;

  std::string mesh() {
    const auto deadline = Clock::now() + std::chrono::duration<double>(time_limit_);
    while (receive_mesh(time_limit_ > 0 ? std::optional(deadline) : std::nullopt)) {
    }
    const int status = process_.wait();
    receive_log();
    log_.end();
    if (status == mesher::done && log_.errors().empty() && !bytes_.empty()) {
      for (const std::string& text : log_.warnings()) log::warning("{}: Gmsh: {}", request_.file.string(), text);
      return std::move(bytes_);
    }
    fail(status);
  }

 private:
  using Deadline = std::optional<std::chrono::time_point<Clock, std::chrono::duration<double>>>;

  /// Waits for the next bytes of either kind. @returns false when the mesher has closed its end
  bool receive_mesh(const Deadline& deadline) {
    constexpr int forever = -1;
    int wait = forever;
    if (deadline) {
      const double left = std::chrono::duration<double>(*deadline - Clock::now()).count();
      if (left <= 0) fail_in_time();
      constexpr double longest = 1e6;  // milliseconds
      wait = static_cast<int>(std::min(longest, 1000 * left)) + 1;
    }
    std::array<pollfd, 2> ends{
        {{mesh_pipe_.reading_end(), POLLIN, 0}, {log_is_open_ ? log_pipe_.reading_end() : -1, POLLIN, 0}}};
    if (::poll(ends.data(), ends.size(), wait) <= 0) return true;
    if (ends[1].revents != 0) receive_log();
    if (ends[0].revents == 0) return true;
    const ssize_t count = ::read(mesh_pipe_.reading_end(), buffer_.data(), buffer_.size());
    if (count > 0) bytes_.append(buffer_.data(), static_cast<std::size_t>(count));
    return count > 0 || (count < 0 && errno == EINTR);
  }

  void receive_log() {
    ssize_t count = 0;
    while ((count = ::read(log_pipe_.reading_end(), buffer_.data(), buffer_.size())) > 0)
      log_.add({buffer_.data(), static_cast<std::size_t>(count)});
    if (count == 0) log_is_open_ = false;
  }

  template <typename... Args>
  [[noreturn]] void refuse(fmt::format_string<Args...> format, Args&&... args) const {
    std::string text = fmt::format("{}: {}", request_.file.string(), fmt::format(format, std::forward<Args>(args)...));
    const std::vector<std::string> warnings = log_.warnings();
    if (!warnings.empty()) text += fmt::format("\n  Gmsh warned before:\n    {}", fmt::join(warnings, "\n    "));
    throw ModelError(text);
  }

  [[noreturn]] void fail_in_time() {
    process_.kill();
    receive_log();
    log_.end();
    refuse(
        "meshing took longer than mesh.time_limit = {} s and was stopped{}\n  Check the file for "
        "an endless loop; if the mesh is just large, raise mesh.time_limit or make the mesh coarser",
        time_limit_, log_.last_words());
  }

  [[noreturn]] void fail(int status) const {
    if (status == mesher::reached_out || status == 128 + SIGSYS) {
      refuse(
          "the geometry tried more than to define a mesh, and meshing was stopped:{}\n  Geometry files may not run "
          "programs, write files or use the network; if you trust this file, add --trust-geometry",
          log_.own_words().empty() ? "\n  the file tried to start a program" : log_.own_words());
    }
    if (status == mesher::ended_by_file)
      refuse("the file ended Gmsh by Exit before there was a mesh:{}\n  Remove the statement", log_.own_words());
    if (status == mesher::out_of_memory || log_.lacks_memory()) {
      refuse(
          "meshing needs more memory than mesh.memory_limit_mb = {} or the system allows{}{}\n  "
          "Make the mesh coarser, or raise mesh.memory_limit_mb",
          request_.memory_limit_mb, log_.last_words(), log_.own_words());
    }
    if (status == mesher::not_confined) {
      refuse(
          "this system has no seccomp, so the file cannot be prevented from running programs, and it has statements "
          "that may do so unseen: names that it computes, plugins, files or texts that are too long to look into, or "
          "words such as 'SystemCall' or 'Include' in comments and texts; remove them or, if you trust the file, add "
          "--trust-geometry. {}",
          remedy_by_hand);
    }
    if (!log_.errors().empty()) refuse("Gmsh failed:{}", log_.errors());
    if (status > 128) {
      refuse("Gmsh crashed ({}){}{}\n  Simplify the geometry near that place{}. {}", signal_text(status - 128),
             log_.last_words(), log_.own_words(),
             status == 128 + SIGKILL
                 ? ", or make the mesh coarser: a system that runs out of memory ends programs like this"
                 : "",
             remedy_by_hand);
    }
    constexpr int not_started = 127;
    refuse("Gmsh made no mesh (creepcontact-mesher ended with status {}){}{}\n  {}{}", status, log_.last_words(),
           log_.own_words(),
           status == not_started ? "Its libraries need about 600 MB of address space: allow the program more memory if "
                                   "it is limited (ulimit -v). "
                                 : "",
           remedy_by_hand);
  }

  static std::string signal_text(int signal) { return fmt::format("signal {}, {}", signal, ::strsignal(signal)); }

  const MesherRequest& request_;
  double time_limit_;
  MesherLog log_;
  platform::Pipe mesh_pipe_, log_pipe_;
  platform::ChildProcess process_;
  std::string bytes_;
  std::array<char, 1 << 16> buffer_;
  bool log_is_open_ = true;
};

}  // namespace

fs::path find_mesher() {
  if (const char* given = std::getenv("CREEPCONTACT_MESHER"); given != nullptr && *given != '\0') {
    if (::access(given, X_OK) == 0) return given;
    throw ModelError(
        fmt::format("CREEPCONTACT_MESHER names '{}', which cannot be started: {}; set it to the path of "
                    "creepcontact-mesher, or unset it",
                    given, std::strerror(errno)));
  }
  const std::string name = "creepcontact-mesher";
  if (fs::path found = platform::find_companion(name, true); !found.empty()) return found;
  std::string names;
  for (const fs::path& place : platform::companion_places(name)) names += (names.empty() ? "" : ", ") + place.string();
  throw ModelError(
      fmt::format("creepcontact-mesher, which meshes .geo files, was not found as any of {}; install it again, or give "
                  "its path in the environment variable CREEPCONTACT_MESHER. {}",
                  names, remedy_by_hand));
}

std::string run_mesher(const MesherRequest& request, double time_limit) {
  return Mesher(request, time_limit).mesh();
}

}  // namespace creepcontact::io
