#pragma once
/// Faces as keys of hash tables: the sorted corner nodes, so that order and orientation of a cell do not matter.

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <span>

#include "creepcontact/mesh/cell_type.hpp"

namespace creepcontact::mesh {

/// Corner nodes, ascending; a triangle has -1 in front.
using FaceKey = std::array<std::int64_t, 4>;

struct FaceKeyHash {
  std::size_t operator()(const FaceKey& key) const {
    std::size_t seed = 0;
    for (std::int64_t node : key) seed = seed * 0x9E3779B97F4A7C15ull + std::hash<std::int64_t>{}(node) + (seed >> 29);
    return seed;
  }
};

/// Key of the surface cell of this type whose i-th node is node(i).
template <typename Node>
FaceKey face_key(CellType type, Node&& node) {
  FaceKey key{-1, -1, -1, -1};
  for (int i = 0; i < n_corners(type); ++i) key[i] = node(i);
  std::sort(key.begin(), key.end());
  return key;
}

inline FaceKey face_key(CellType type, std::span<const std::int64_t> nodes) {
  return face_key(type, [&](int i) { return nodes[i]; });
}

}  // namespace creepcontact::mesh
