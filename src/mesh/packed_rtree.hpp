#pragma once
/// Boost's R-tree with numbered entries. For sources alone: its headers take seconds to compile.

#define BOOST_ALLOW_DEPRECATED_HEADERS  // Boost.Geometry 1.74 includes one itself, and says so in every compilation
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cstddef>
#include <utility>

#include "creepcontact/base/tensor.hpp"

namespace creepcontact::mesh {

using RtreePoint = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
using RtreeBox = boost::geometry::model::box<RtreePoint>;

/// Made from a range of entries, which packs it.
template <typename Geometry>
using PackedRtree = boost::geometry::index::rtree<std::pair<Geometry, std::size_t>, boost::geometry::index::rstar<16>>;

inline RtreePoint rtree_point(const Vector3& x) {
  return {x[0], x[1], x[2]};
}

}  // namespace creepcontact::mesh
