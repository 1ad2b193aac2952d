#include "ribbon/linear/block_ldlt.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "tests/support/dense.h"

namespace ribbon {
namespace {

Eigen::Index row(int slot) { return 2 * static_cast<Eigen::Index>(slot); }

/// The same matrix as BlockLdlt and as a dense one of Eigen's.
struct MatrixPair {
  BlockLdlt sparse;
  Eigen::MatrixXd dense;
};

/// A chain of n slots, some of them coupled with far ones, some held, eliminated in a random order. Each slot k with k
/// mod `scalar_every` = 1 is a scalar multiplier.
MatrixPair random_pair(int n, int far, std::mt19937& random, int scalar_every = 0) {
  const auto is_scalar = [scalar_every](int k) { return scalar_every > 0 && k % scalar_every == 1; };
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  std::uniform_int_distribution<int> slot(0, n - 1);
  std::vector<int> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  std::vector<std::pair<int, int>> couplings;
  for (int k = 0; k + 1 < n; ++k) couplings.emplace_back(k, k + 1);
  for (int k = 0; k < far; ++k) couplings.emplace_back(slot(random), slot(random));

  MatrixPair pair;
  pair.sparse.begin_pattern(order);
  for (const auto& [a, b] : couplings) pair.sparse.couple(a, b);
  pair.sparse.end_pattern();
  pair.sparse.set_zero();
  pair.dense = Eigen::MatrixXd::Zero(row(n), row(n));
  const double dominant = 2.0 * (far + 4.0);
  for (int k = 0; k < n; ++k) {
    const double xy = entry(random);
    if (is_scalar(k)) {
      pair.sparse.make_scalar_dual(k);
      pair.sparse.add(k, -dominant, 0.0, -1.0);
      pair.dense.block<2, 2>(row(k), row(k)) << -dominant, 0.0, 0.0, -1.0;
      continue;
    }
    pair.sparse.add(k, dominant, xy, dominant);
    pair.dense.block<2, 2>(row(k), row(k)) << dominant, xy, xy, dominant;
  }
  for (const auto& [a, b] : couplings) {
    if (a == b) continue;
    Eigen::Matrix2d block;
    block << entry(random), entry(random), entry(random), entry(random);
    if (is_scalar(a)) block.row(1).setZero();
    if (is_scalar(b)) block.col(1).setZero();
    pair.sparse.add(a, b, block(0, 0), block(0, 1), block(1, 0), block(1, 1));
    pair.dense.block<2, 2>(row(a), row(b)) += block;
    pair.dense.block<2, 2>(row(b), row(a)) += block.transpose();
  }
  return pair;
}

void expect_as_eigen(MatrixPair pair, int n, int held, std::mt19937& random) {
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  std::vector<Vec2> b(static_cast<std::size_t>(n));
  for (Vec2& value : b) value = {entry(random), entry(random)};
  if (held >= 0) {
    pair.sparse.hold(held);
    b[static_cast<std::size_t>(held)] = {};
    pair.dense.middleRows(row(held), 2).setZero();
    pair.dense.middleCols(row(held), 2).setZero();
    pair.dense.block<2, 2>(row(held), row(held)).setIdentity();
  }
  Eigen::VectorXd right(row(n));
  for (int k = 0; k < n; ++k)
    right.segment<2>(row(k)) << b[static_cast<std::size_t>(k)].x, b[static_cast<std::size_t>(k)].y;
  const Eigen::VectorXd expected = test_support::solve_dense(pair.dense, right);
  ASSERT_TRUE(pair.sparse.solve(b));
  for (int k = 0; k < n; ++k) {
    EXPECT_NEAR(b[static_cast<std::size_t>(k)].x, expected(row(k)), 1e-12);
    EXPECT_NEAR(b[static_cast<std::size_t>(k)].y, expected(row(k) + 1), 1e-12);
  }
}

TEST(BlockLdlt, AgreesWithEigenForAnyCouplingsAndConstraints) {
  std::mt19937 random(11);
  for (const int n : {1, 2, 7, 40}) {
    for (const int far : {0, 1, 5, 60}) {
      for (const int held : {-1, 0, n / 2}) expect_as_eigen(random_pair(n, far, random), n, held, random);
    }
  }
}

/// Scalar multipliers are eliminated without their second component, alone and between rows that have the same columns.
TEST(BlockLdlt, AgreesWithEigenForScalarMultipliers) {
  std::mt19937 random(12);
  for (const int every : {2, 3, 4, 5}) {
    for (const int far : {0, 5, 60, 400}) {
      for (const int held : {-1, 0, 21}) expect_as_eigen(random_pair(40, far, random, every), 40, held, random);
    }
  }
}

TEST(BlockLdlt, PredictsTheFillOfElimination) {
  BlockLdlt matrix;
  matrix.begin_pattern(std::vector<int>{0, 1, 2, 3});
  matrix.couple(0, 2);
  matrix.couple(3, 0);
  matrix.couple(0, 2);
  matrix.end_pattern();
  EXPECT_TRUE(matrix.is_coupled(0, 2));
  EXPECT_TRUE(matrix.is_coupled(3, 2));
  EXPECT_FALSE(matrix.is_coupled(0, 1));
  EXPECT_EQ(matrix.off_diagonal_blocks(), 3U);
  matrix.begin_pattern(std::vector<int>{2, 3, 0, 1});
  matrix.couple(0, 2);
  matrix.couple(0, 3);
  matrix.end_pattern();
  EXPECT_EQ(matrix.off_diagonal_blocks(), 2U);  // 0 last of them: nothing fills
}

TEST(BlockLdlt, RefusesMatricesThatAreNotPositiveDefinite) {
  const auto solves = [](double diagonal, double off) {
    BlockLdlt matrix;
    matrix.begin_pattern(std::vector<int>{0, 1});
    matrix.couple(0, 1);
    matrix.end_pattern();
    matrix.set_zero();
    matrix.add(0, diagonal, 0.0, diagonal);
    matrix.add(1, diagonal, 0.0, diagonal);
    matrix.add(0, 1, off, 0.0, 0.0, 0.0);
    std::vector<Vec2> b(2, {1.0, 1.0});
    return matrix.solve(b);
  };
  EXPECT_TRUE(solves(2.0, 1.0));
  EXPECT_FALSE(solves(1.0, 2.0));
  EXPECT_FALSE(solves(1.0, 1.0));
  EXPECT_FALSE(solves(-1.0, 0.0));
}

/// A band among other slots, as a rope among bodies that touch it.
void expect_to_take_a_band(const std::vector<int>& order) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  constexpr int first = 2;
  constexpr int points = 5;
  for (const int reach : {1, 2}) {
    BandedMatrix band(2 * points, 5);
    BlockLdlt sparse;
    sparse.begin_pattern(order);
    sparse.couple(0, 2);
    sparse.couple(0, 3);
    sparse.couple(5, 1);
    for (int p = 0; p < points; ++p) {
      for (int k = 1; k <= reach && p + k < points; ++k) sparse.couple(first + p, first + p + k);
    }
    sparse.end_pattern();
    sparse.set_zero();
    Eigen::MatrixXd dense = 12.0 * Eigen::MatrixXd::Identity(row(7), row(7));
    for (int r = 0; r < 2 * points; ++r) {
      const int last = std::min(2 * (r / 2 + reach) + 1, 2 * points - 1);
      for (int c = r; c <= last; ++c) {
        band.row(r)[c - r] = entry(random) + (r == c ? 12.0 : 0.0);
        dense(row(first) + r, row(first) + c) = dense(row(first) + c, row(first) + r) = band.at(r, c);
      }
    }
    for (const int other : {0, 1}) sparse.add(other, 12.0, 0.0, 12.0);
    sparse.add_band(first, band, reach);

    std::vector<Vec2> x(7);
    Eigen::VectorXd b(row(7));
    for (int slot = 0; slot < 7; ++slot) {
      x[static_cast<std::size_t>(slot)] = {entry(random), entry(random)};
      b.segment<2>(row(slot)) << x[static_cast<std::size_t>(slot)].x, x[static_cast<std::size_t>(slot)].y;
    }
    ASSERT_TRUE(sparse.solve(x));
    const Eigen::VectorXd expected = test_support::solve_dense(dense, b);
    for (int slot = 0; slot < 7; ++slot) {
      EXPECT_NEAR(x[static_cast<std::size_t>(slot)].x, expected(row(slot)), 1e-13) << "reach " << reach;
      EXPECT_NEAR(x[static_cast<std::size_t>(slot)].y, expected(row(slot) + 1), 1e-13) << "reach " << reach;
    }
  }
}

TEST(BlockLdlt, AcceptsABandWithAscendingSlots) { expect_to_take_a_band({2, 3, 0, 4, 5, 1, 6}); }

TEST(BlockLdlt, AcceptsABandWithSlotsInAnyOrder) {
  expect_to_take_a_band({6, 5, 4, 3, 2, 1, 0});
  expect_to_take_a_band({3, 0, 6, 2, 5, 1, 4});
}

TEST(BlockLdlt, SolvesTheSameInAnotherOrder) {
  std::mt19937 random(3);
  BlockLdlt matrix;
  const std::vector<int> order{2, 0, 4, 1, 3};
  matrix.begin_pattern(order);
  const std::vector<std::pair<int, int>> couplings{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {0, 4}};
  for (const auto& [a, b] : couplings) matrix.couple(a, b);
  matrix.end_pattern();
  const auto solved = [&] {
    matrix.set_zero();
    for (int k = 0; k < 5; ++k) matrix.add(k, 9.0 + k, 0.5, 8.0);
    for (const auto& [a, b] : couplings) matrix.add(a, b, 1.0, 0.3 * a, -0.2 * b, 0.7);
    std::vector<Vec2> x{{1.0, 2.0}, {0.0, -1.0}, {3.0, 0.5}, {-2.0, 1.0}, {0.3, 0.0}};
    EXPECT_TRUE(matrix.solve(x));
    return x;
  };
  const std::vector<Vec2> before = solved();
  for (int k = 0; k < 10; ++k) {
    std::vector<int> other = order;
    std::shuffle(other.begin(), other.end(), random);
    matrix.reorder(other);
    for (const auto& [a, b] : couplings) EXPECT_TRUE(matrix.is_coupled(a, b));
    const std::vector<Vec2> after = solved();
    for (std::size_t i = 0; i < 5; ++i) EXPECT_LT(length(after[i] - before[i]), 1e-14);
  }
}

}  // namespace
}  // namespace ribbon
