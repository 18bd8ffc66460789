#include "linear_reconstruction.hpp"

#include <algorithm>

#include "creepcontact/base/index.hpp"
#include "creepcontact/linalg/dense.hpp"

namespace creepcontact::mechanics {
namespace {

constexpr double own_weight = 1e-3;
constexpr double not_spanned = 1e-12;  // of the largest eigenvalue: a direction in which no arm reaches

}  // namespace

LinearReconstruction::LinearReconstruction(const Blocks& blocks, const NodeEntries& entries,
                                           std::span<const Vector3> point_coordinates, std::span<const double> weights,
                                           const std::function<std::size_t(std::size_t)>& element_of)
    : positions_(point_coordinates.begin(), point_coordinates.end()), offsets_{0} {
  for (const auto& block : blocks)
    for (std::size_t e = 0; e < block->n_elements(); ++e) {
      Vector3 moment = Vector3::Zero();
      double volume = 0;
      const std::size_t first = block->start().point + e * block->n_points();
      for (std::size_t p = first; p < first + block->n_points(); ++p) {
        moment += weights[p] * positions_[p];
        volume += weights[p];
      }
      centres_.emplace_back(moment / volume);
      volumes_.push_back(volume);
    }
  std::vector<std::uint32_t> around;
  for (const auto& block : blocks)
    for (std::size_t e = 0; e < block->n_elements(); ++e) {
      around.clear();
      Matrix3 normal = Matrix3::Zero();
      if (serves(block->type())) {
        const std::size_t element = block->start().element + e;
        for (const std::int64_t node : block->nodes(e).first(mesh::n_corners(block->type())))
          for (const std::size_t entry : entries.of(node))
            around.push_back(static_cast<std::uint32_t>(element_of(entry)));
        std::sort(around.begin(), around.end());
        around.erase(std::unique(around.begin(), around.end()), around.end());
        std::erase(around, static_cast<std::uint32_t>(element));
        const auto add = [&](const Vector3& position, double weight) {
          const Vector3 arm = position - centres_[element];
          normal += weight * arm * arm.transpose();
        };
        for (const std::uint32_t other : around) add(centres_[other], volumes_[other]);
        const std::size_t first = block->start().point + e * block->n_points();
        for (std::size_t p = first; p < first + block->n_points(); ++p)
          add(positions_[p], own_weight * volumes_[element]);
      }
      neighbours_.insert(neighbours_.end(), around.begin(), around.end());
      offsets_.push_back(neighbours_.size());
      inverse_.push_back(around.empty() ? Matrix3::Zero() : linalg::symmetric_pseudo_inverse(normal, not_spanned));
    }
}

LinearReconstruction::Rows LinearReconstruction::gradient(const ElementBlock& block, std::size_t e,
                                                          std::span<const double> means,
                                                          const Eigen::Ref<const Rows>& own) const {
  const std::size_t element = block.start().element + e, width = own.cols();
  const double* const mean = &means[element * width];
  Rows right = Rows::Zero(3, own.cols());
  double *x = right.data(), *y = x + width, *z = y + width;
  const auto add = [&](const Vector3& position, double weight, const double* values) {
    const Vector3 arm = weight * (position - centres_[element]);
    for (std::size_t i = 0; i < width; ++i) {
      const double difference = values[i] - mean[i];
      x[i] += arm[0] * difference;
      y[i] += arm[1] * difference;
      z[i] += arm[2] * difference;
    }
  };
  for (std::size_t k = offsets_[element]; k < offsets_[element + 1]; ++k) {
    const std::uint32_t other = neighbours_[k];
    add(centres_[other], volumes_[other], &means[other * width]);
  }
  const std::size_t first = block.start().point + e * block.n_points();
  for (std::size_t p = 0; p < block.n_points(); ++p)
    add(positions_[first + p], own_weight * volumes_[element], &own.coeffRef(static_cast<Index>(p), 0));
  return inverse_[element] * right;
}

}  // namespace creepcontact::mechanics
