// Tensors in memory of others.
#include "creepcontact/base/tensor.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace creepcontact {
namespace {

template <typename Tensor>
concept Viewable = requires(Tensor&& tensor) {
  tensor::view(std::forward<Tensor>(tensor));
};
static_assert(Viewable<Tensor6&> && Viewable<const Tensor6&>);
static_assert(!Viewable<Tensor6>, "the view would outlive the tensor");

std::vector<double> counted(std::size_t n) {
  std::vector<double> values(n);
  std::iota(values.begin(), values.end(), 0.0);
  return values;
}

TEST(TensorViews, SeeWhatStandsThere) {
  std::vector<double> values = counted(18);
  const tensor::ConstMap second = tensor::view(values, 1);
  EXPECT_EQ(second, (Tensor6() << 6, 7, 8, 9, 10, 11).finished());
  values[6] = -1;
  EXPECT_EQ(second[0], -1);
  const Tensor6 whole = Tensor6::Constant(3);
  EXPECT_EQ(tensor::view(whole).data(), whole.data());
}

TEST(TensorViews, WriteSixNumbersAndNoOther) {
  std::vector<double> values = counted(18);
  tensor::Map second = tensor::writable(values, 1);
  tensor::Map copy = second;
  copy = Tensor6::Zero();
  second[5] += 2;
  std::vector<double> expected = counted(18);
  std::fill_n(expected.begin() + 6, 6, 0.0);
  expected[11] = 2;
  EXPECT_EQ(values, expected);
  Tensor6 whole = Tensor6::Zero();
  tensor::writable(whole) += Tensor6::Ones();
  EXPECT_EQ(whole, Tensor6::Ones());
}

TEST(TensorViews, ZeroIsZero) {
  EXPECT_EQ(tensor::zero(), Tensor6::Zero());
}

}  // namespace
}  // namespace creepcontact
