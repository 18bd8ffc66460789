#include "creepcontact/platform/memory.hpp"

#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>

namespace creepcontact::platform {
namespace {

constexpr double kilobyte = 1024;
constexpr double no_limit = 1e18;  // what a control group without a limit says is of this order

void keep_smaller(Room& room, double bytes, const std::string& reason) {
  if (bytes < room.bytes) room = {std::max(bytes, 0.0), reason};
}

/// The number in a line of a file that begins so. @param begin  empty: the first line
std::optional<double> number_in(const std::filesystem::path& file, std::string_view begin) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with(begin)) continue;
    const std::size_t digits = line.find_first_of("0123456789", begin.size());
    if (digits == std::string::npos) return std::nullopt;
    double value = 0;
    std::from_chars(line.data() + digits, line.data() + line.size(), value);
    return value;
  }
  return std::nullopt;
}

void consider_limit(Room& room, int resource, const char* name, const char* line_of_status) {
  rlimit limit{};
  const auto taken = number_in("/proc/self/status", line_of_status);
  if (getrlimit(static_cast<__rlimit_resource>(resource), &limit) != 0 || limit.rlim_cur == RLIM_INFINITY || !taken)
    return;
  const auto bytes = static_cast<double>(limit.rlim_cur);
  keep_smaller(room, bytes - kilobyte * *taken,
               fmt::format("the limit of the {} is {}, of which {} are in use", name, memory_text(bytes),
                           memory_text(kilobyte * *taken)));
}

/// A control group and those around it.
void consider_group(Room& room, const std::filesystem::path& mount, std::filesystem::path group, const char* limit,
                    const char* usage, const char* reclaimable) {
  for (;; group = group.parent_path()) {
    const std::filesystem::path directory = mount / group.relative_path();
    const auto bytes = number_in(directory / limit, ""), taken = number_in(directory / usage, "");
    if (bytes && taken && *bytes < no_limit) {
      const double file_cache = number_in(directory / "memory.stat", reclaimable).value_or(0);
      keep_smaller(room, *bytes - (*taken - file_cache),
                   fmt::format("the control group '{}' has a limit of {}, of which {} are in use", group.string(),
                               memory_text(*bytes), memory_text(*taken - file_cache)));
    }
    if (!group.has_relative_path()) return;
  }
}

void consider_groups(Room& room, const std::filesystem::path& root) {
  std::ifstream stream(root / "proc/self/cgroup");
  for (std::string line; std::getline(stream, line);) {
    std::istringstream fields(line);
    std::string number, controllers, path;
    std::getline(fields, number, ':');
    std::getline(fields, controllers, ':');
    std::getline(fields, path);
    if (number == "0" && controllers.empty())
      consider_group(room, root / "sys/fs/cgroup", path, "memory.max", "memory.current", "inactive_file ");
    else if (("," + controllers + ",").find(",memory,") != std::string::npos)
      consider_group(room, root / "sys/fs/cgroup/memory", path, "memory.limit_in_bytes", "memory.usage_in_bytes",
                     "total_inactive_file ");
  }
}

}  // namespace

Room address_space() {
  Room room;
  consider_limit(room, RLIMIT_AS, "address space (ulimit -v)", "VmSize:");
  consider_limit(room, RLIMIT_DATA, "data (ulimit -d)", "VmData:");
  return room;
}

Room free_memory(const std::filesystem::path& root) {
  Room room;
  const std::filesystem::path of_machine = root / "proc/meminfo";
  if (const auto available = number_in(of_machine, "MemAvailable:")) {
    const double bytes = kilobyte * (*available + number_in(of_machine, "SwapFree:").value_or(0));
    keep_smaller(room, bytes, fmt::format("the machine has {} left", memory_text(bytes)));
  }
  consider_groups(room, root);
  return room;
}

double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return kilobyte * static_cast<double>(usage.ru_maxrss);
}

std::string memory_text(double bytes) {
  return bytes < 1e10 ? fmt::format("{:.0f} MB", bytes / 1e6) : fmt::format("{:.1f} GB", bytes / 1e9);
}

void return_large_blocks() {
  constexpr int megabyte = 1 << 20;
  ::mallopt(M_MMAP_THRESHOLD, megabyte);
}

}  // namespace creepcontact::platform
