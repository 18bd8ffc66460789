/// Vectors whose operations are delayed, through the functions that integrators call.

#include "../../../src/ode/sundials/delayed_operations.hpp"

#include <gtest/gtest.h>
#include <sundials/sundials_context.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <vector>

#include "../../../src/ode/sundials/sundials_vector.hpp"
#include "creepcontact/base/team.hpp"

namespace creepcontact::ode {
namespace {

constexpr std::size_t size = 3 * piece_length + 7;

struct DelayedVectors : testing::Test {
  DelayedVectors() { SUNContext_Create(nullptr, &context); }
  ~DelayedVectors() override {
    vectors.clear();
    SUNContext_Free(&context);
  }
  void make(std::size_t n) {
    vectors.push_back(make_vector(team, size, context));
    while (vectors.size() < n) vectors.emplace_back(N_VClone(vectors.front().get()));
    for (std::size_t k = 0; k < n; ++k) {
      values.emplace_back(size);
      for (std::size_t i = 0; i < size; ++i) values[k][i] = std::sin(static_cast<double>(1 + 7 * k + i));
      std::ranges::copy(values[k], view(vectors[k].get(), size).begin());
    }
  }
  N_Vector at(std::size_t k) { return vectors[k].get(); }
  void linear_sum(double a, std::size_t x, double b, std::size_t y, std::size_t z) {
    N_VLinearSum(a, at(x), b, at(y), at(z));
    for (std::size_t i = 0; i < size; ++i) values[z][i] = a * values[x][i] + b * values[y][i];
  }
  void expect_equal(std::size_t k) {
    const std::span<const double> found = view(at(k), size);
    ASSERT_TRUE(std::ranges::equal(found, values[k])) << "vector " << k;
  }

  SerialTeam team;
  SUNContext context = nullptr;
  std::vector<Vector> vectors;
  std::vector<std::vector<double>> values;  // as they would be without delay
};

TEST_F(DelayedVectors, HaveTheBitsOfOperationsDoneAtOnce) {
  std::mt19937 random(1);
  make(5);
  for (int trial = 0; trial < 2000; ++trial) {
    const std::size_t x = random() % 5, y = random() % 5, z = random() % 5;
    linear_sum(0.6, x, -0.5, y, z);
    if (random() % 5 == 0) expect_equal(random() % 5);
    if (random() % 7 == 0) {
      double norm = 0;
      for (std::size_t begin = 0; begin < size; begin += piece_length)
        norm += piece(values[x].data(), begin, std::min(piece_length, size - begin)).abs().sum();
      ASSERT_EQ(N_VL1Norm(at(x)), norm);
    }
  }
  for (std::size_t k = 0; k < 5; ++k) expect_equal(k);
}

TEST_F(DelayedVectors, MayBeWrittenThroughTheirView) {
  make(3);
  linear_sum(1, 0, 1, 1, 2);  // must see vector 0 as it was
  std::ranges::fill(view(at(0), size), 5.0);
  std::ranges::fill(values[0], 5.0);
  linear_sum(2, 0, 1, 2, 1);
  for (std::size_t k = 0; k < 3; ++k) expect_equal(k);
}

TEST_F(DelayedVectors, OutliveThoseTheyWereComputedFrom) {
  make(4);
  linear_sum(1, 0, 1, 1, 2);
  linear_sum(1, 2, 1, 1, 3);
  vectors[0].reset();
  vectors[1].reset();
  expect_equal(3);
  expect_equal(2);
}

TEST_F(DelayedVectors, WorkWithVectorsThatWereMadeApart) {
  make(2);
  const Vector other = make_vector(team, size, context);
  N_VScale(2.0, at(0), at(1));
  N_VLinearSum(1.0, at(1), 1.0, at(0), other.get());
  N_VConst(0.0, at(0));
  EXPECT_DOUBLE_EQ(view(other.get(), size)[3], 3 * values[0][3]);
  N_VScale(-1.0, other.get(), other.get());
  EXPECT_NEAR(N_VDotProd(at(1), other.get()), -1.5 * N_VDotProd(at(1), at(1)), 1e-12 * size);
}

/// What nobody asks for waits: it can then be done together with more.
TEST(DelayedOperations, LeaveWhatTheWantedVectorDoesNotDependOn) {
  std::vector<double> a(size, 1), b(size, 2), c(size, 3), d(size, 4);
  DelayedOperations operations(size);
  const auto copy = [&](const std::vector<double>& x, std::vector<double>& z) {
    operations.add({.kind = Elementwise::Kind::multiple, .c = {1}, .x = x.data(), .y = x.data(), .z = z.data()});
  };
  copy(a, b);
  copy(c, d);
  operations.finish(b.data());
  EXPECT_EQ(b[0], 1);
  EXPECT_EQ(d[0], 4);
  copy(b, c);  // must not overtake d = c
  EXPECT_EQ(
      operations.finish_and_sum({c.data()}, size, [&](auto begin, auto n) { return piece(c.data(), begin, n).sum(); }),
      static_cast<double>(size));
  EXPECT_EQ(d[size - 1], 3);
}

}  // namespace
}  // namespace creepcontact::ode
