#include "creepcontact/io/checkpoint/checkpoint.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>

#include "checkpoint_seal.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/platform/replace_file.hpp"
#include "hdf5_file.hpp"

namespace creepcontact::io {
namespace {

void write_content(const std::filesystem::path& path, const Checkpoint& checkpoint) {
  const Hdf5Silence silence;
  Hdf5Handle file = create_hdf5(path, seal_size);
  write_array(file, "fingerprint", std::span<const char>(checkpoint.fingerprint));
  write_array(file, "integrator", std::span<const char>(checkpoint.integrator));
  write_array(file, "time", std::array{checkpoint.time});
  write_array(file, "next_step", std::array{checkpoint.next_step});
  write_array(file, "state", checkpoint.state);
  {
    const Hdf5Handle counters = create_group(file, "counters");
    for (const RunCounters::Field& field : RunCounters::fields)
      write_array(counters, std::string(field.name), std::array{checkpoint.counters.*field.value});
    const Hdf5Handle arrays = create_group(file, "arrays");
    for (const auto& [name, values] : checkpoint.arrays) write_array(arrays, name, values);
  }
  file.finish("write the file");
}

Checkpoint read_content(const std::filesystem::path& path) {
  const Hdf5Silence silence;
  const Hdf5Handle file = open_hdf5(path);
  Checkpoint checkpoint;
  const std::vector<char> fingerprint = read_array<char>(file, "fingerprint");
  checkpoint.fingerprint.assign(fingerprint.begin(), fingerprint.end());
  const std::vector<char> integrator = read_array<char>(file, "integrator");
  checkpoint.integrator.assign(integrator.begin(), integrator.end());
  checkpoint.time = read_number<double>(file, "time");
  checkpoint.next_step = read_number<double>(file, "next_step");
  checkpoint.state = read_array<double>(file, "state");
  const Hdf5Handle counters = open_group(file, "counters");
  for (const RunCounters::Field& field : RunCounters::fields)
    checkpoint.counters.*field.value = read_number<std::int64_t>(counters, std::string(field.name));
  const Hdf5Handle arrays = open_group(file, "arrays");
  for (const std::string& name : member_names(arrays)) checkpoint.arrays[name] = read_array<double>(arrays, name);
  return checkpoint;
}

/// A second name for the old file, so that its own stays until the new one takes it.
void keep_previous(const std::filesystem::path& path) {
  if (!path_exists(path)) return;
  const std::filesystem::path previous = previous_checkpoint(path);
  std::error_code error;
  std::filesystem::remove(platform::aside(previous), error);
  std::filesystem::create_hard_link(path, platform::aside(previous), error);
  if (error) std::filesystem::copy_file(path, platform::aside(previous), error);  // file systems without links
  if (!error) std::filesystem::rename(platform::aside(previous), previous, error);
  if (error) throw Error(fmt::format("cannot write the checkpoint '{}': {}", previous.string(), error.message()), 4);
}

/// Removes an unfinished file, which would take what is left of a full disk.
void drop(const std::filesystem::path& part) {
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
}

}  // namespace

std::filesystem::path previous_checkpoint(const std::filesystem::path& path) {
  return path.parent_path() / (path.stem().string() + ".previous" + path.extension().string());
}

void prepare_checkpoints() noexcept {
  try {
    hdf5();
  } catch (const std::exception&) {
    return;
  }
}

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
  const std::filesystem::path part = platform::aside(path);
  errno = 0;
  try {
    write_content(part, checkpoint);
    write_seal(part);
  } catch (const Hdf5Error& error) {
    const std::string reason = errno == 0 ? "" : fmt::format(": {}", platform::write_failure(errno));
    drop(part);
    throw Error(fmt::format("cannot write the checkpoint '{}': {}{}", path.string(), error.what(), reason), 4);
  } catch (const Error&) {
    drop(part);
    throw;
  }
  keep_previous(path);
  platform::move_into_place(path);
}

Checkpoint read_checkpoint(const std::filesystem::path& path) {
  check_seal(path);
  try {
    return read_content(path);
  } catch (const Hdf5Error& error) {
    throw ConfigError(fmt::format("the checkpoint '{}' is incomplete: {}", path.string(), error.what()));
  }
}

void require_checkpoint(const std::filesystem::path& path) {
  if (!path_exists(path) && !path_exists(previous_checkpoint(path)))
    throw ConfigError(
        fmt::format("there is no checkpoint '{}' to continue from; run without --resume to start from the beginning",
                    path.string()));
}

Checkpoint read_last_checkpoint(const std::filesystem::path& path) {
  require_checkpoint(path);
  const std::filesystem::path previous = previous_checkpoint(path);
  std::string damage;
  std::optional<OtherFormat> other_format;
  try {
    return read_checkpoint(path);
  } catch (const OtherFormat& error) {
    other_format = error;
    damage = error.what();
  } catch (const ConfigError& error) {
    damage = error.what();
  }
  try {
    Checkpoint checkpoint = read_checkpoint(previous);
    log::warning("{}; the run continues from the previous one, at t = {:.6g}", damage, checkpoint.time);
    std::error_code error;
    std::filesystem::rename(previous, path, error);
    if (error)
      throw ConfigError(
          fmt::format("cannot rename '{}' to '{}': {}", previous.string(), path.string(), error.message()));
    return checkpoint;
  } catch (const ConfigError& error) {
    if (other_format) throw *other_format;
    throw ConfigError(fmt::format("{}, and {}; run without --resume to start again", damage, error.what()));
  }
}

void remove_checkpoints(const std::filesystem::path& path) {
  const std::filesystem::path previous = previous_checkpoint(path);
  for (const std::filesystem::path& file : {path, previous, platform::aside(path), platform::aside(previous)}) {
    std::error_code error;
    std::filesystem::remove(file, error);
    if (error)
      throw ConfigError(fmt::format("cannot remove the old checkpoint '{}': {}", file.string(), error.message()));
  }
}

}  // namespace creepcontact::io
