#pragma once
/// Binary arrays as VTK's XML files hold them: compressed block by block by zlib.

#include <cstddef>
#include <span>
#include <string>

namespace creepcontact::io {

/// Header (UInt64: number of blocks, size of a block, of the last one if smaller, compressed sizes) and data.
/// Source: "VTK File Formats", Kitware, section on XML formats.
std::string vtk_encode(std::span<const std::byte> bytes);

}  // namespace creepcontact::io
