#pragma once
/// The fuzz targets of a program that replays their corpora.

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

using FuzzTarget = int (*)(const std::uint8_t* data, std::size_t size);
/// By name. Defined in a source that CMake writes.
extern const std::map<std::string, FuzzTarget> fuzz_targets;
