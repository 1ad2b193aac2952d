#include "ribbon/linear/fill_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "ribbon/linear/block_ldlt.h"

namespace ribbon {
namespace {

using Couplings = std::vector<std::pair<int, int>>;

std::vector<int> found(FillOrder& fill_order, int count, const Couplings& couplings) {
  fill_order.begin(static_cast<std::size_t>(count));
  for (const auto& [a, b] : couplings) fill_order.couple(a, b);
  const std::span<const int> order = fill_order.find();
  return {order.begin(), order.end()};
}

std::vector<int> found(int count, const Couplings& couplings) {
  FillOrder fill_order;
  return found(fill_order, count, couplings);
}

/// Returns the number of blocks right of the diagonal after elimination in this order.
std::size_t blocks(const std::vector<int>& order, const Couplings& couplings) {
  BlockLdlt matrix;
  matrix.begin_pattern(order);
  for (const auto& [a, b] : couplings) matrix.couple(a, b);
  matrix.end_pattern();
  return matrix.off_diagonal_blocks();
}

std::vector<int> natural(int count) {
  std::vector<int> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  return order;
}

/// A square of n × n, each coupled with its neighbours.
Couplings grid(int n) {
  Couplings couplings;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      if (j + 1 < n) couplings.emplace_back(n * i + j, n * i + j + 1);
      if (i + 1 < n) couplings.emplace_back(n * i + j, n * (i + 1) + j);
    }
  }
  return couplings;
}

TEST(FillOrder, EliminatesEachVariableOnceForAnyCouplings) {
  std::mt19937 random(5);
  FillOrder fill_order;
  for (const int count : {0, 1, 2, 9, 60}) {
    for (const int far : {0, 3, 200}) {
      Couplings couplings;
      std::uniform_int_distribution<int> any(0, std::max(0, count - 1));
      for (int k = 0; k < (count > 0 ? far : 0); ++k) couplings.emplace_back(any(random), any(random));
      std::vector<int> order = found(fill_order, count, couplings);
      EXPECT_EQ(order, found(count, couplings)) << "memory of what it ordered before";
      std::sort(order.begin(), order.end());
      EXPECT_EQ(order, natural(count));
    }
  }
}

TEST(FillOrder, HasNoFillInStarsAndTrees) {
  Couplings star;
  Couplings tree;
  for (int k = 1; k < 40; ++k) {
    star.emplace_back(0, k);
    tree.emplace_back((k - 1) / 3, k);
  }
  EXPECT_EQ(blocks(found(40, star), star), star.size());
  EXPECT_EQ(blocks(found(40, tree), tree), tree.size());
  EXPECT_GT(blocks(natural(40), star), 10 * star.size());
}

TEST(FillOrder, HasLessFillInAGridThanRowOrder) {
  const Couplings couplings = grid(30);
  EXPECT_LT(2 * blocks(found(900, couplings), couplings), blocks(natural(900), couplings));
}

TEST(FillOrder, HasLittleMoreFillThanExactMinimumDegree) {
  // Elimination by exact degrees on random graphs has this fill; a tenth more is accepted.
  std::mt19937 random(8);
  std::uniform_int_distribution<int> any(0, 79);
  for (int graph = 0; graph < 20; ++graph) {
    Couplings couplings;
    for (int k = 0; k < 160; ++k) couplings.emplace_back(any(random), any(random));
    std::vector<std::vector<char>> coupled(80, std::vector<char>(80, 0));
    for (const auto& [a, b] : couplings) {
      if (a == b) continue;
      coupled[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] = 1;
      coupled[static_cast<std::size_t>(b)][static_cast<std::size_t>(a)] = 1;
    }
    std::vector<int> by_degree;
    std::vector<char> gone(80, 0);
    for (int step = 0; step < 80; ++step) {
      std::size_t best = 80;
      std::ptrdiff_t least = 81;
      for (std::size_t i = 0; i < 80; ++i) {
        const std::ptrdiff_t degree = std::count(coupled[i].begin(), coupled[i].end(), 1);
        if (gone[i] != 0 || degree >= least) continue;
        best = i;
        least = degree;
      }
      gone[best] = 1;
      by_degree.push_back(static_cast<int>(best));
      for (std::size_t i = 0; i < 80; ++i) {
        if (coupled[best][i] == 0) continue;
        coupled[i][best] = 0;
        for (std::size_t j = 0; j < 80; ++j) {
          if (j != i && coupled[best][j] != 0) coupled[i][j] = 1;
        }
      }
    }
    EXPECT_LE(static_cast<double>(blocks(found(80, couplings), couplings)),
              1.1 * static_cast<double>(blocks(by_degree, couplings)));
  }
}

}  // namespace
}  // namespace ribbon
