#include "ribbon/box2d/remembered_search.h"

#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <vector>

#include "tests/engine/coupling/tree_oracle.h"
#include "tests/support/dice.h"

// A search of the broad phase's tree that is left out would have found what queries of Box2D find.

namespace ribbon::box2d {
namespace {

using test_support::Dice;
using tree_oracle::box;
using tree_oracle::found_by_box2d;
using tree_oracle::Pairs;
using tree_oracle::search_boxes;

b2AABB random_box(Dice& dice) { return box(dice(0.0, 20.0), dice(0.0, 20.0), 0.5); }

Pairs remembered(const RememberedSearch& search) {
  Pairs pairs;
  for (const RememberedSearch::Leaf& leaf : search.leaves()) {
    for_each_box(leaf.boxes, [&](std::size_t k) { EXPECT_TRUE(pairs.insert({k, leaf.node}).second) << "found twice"; });
  }
  return pairs;
}

/// A tree, and a search of it that is repeated.
struct Searched {
  explicit Searched(unsigned seed) : dice(seed), boxes(1 + seed % 64) {
    for (b2AABB& aabb : boxes) aabb = random_box(dice);
    for (int k = 0; k < 300; ++k) add();
  }
  void add() { proxies.push_back(tree.CreateProxy(random_box(dice), nullptr)); }
  int& any() { return proxies[static_cast<std::size_t>(dice(0.0, static_cast<double>(proxies.size()) - 0.5))]; }
  void remove() {
    int& removed = any();
    tree.DestroyProxy(removed);
    std::swap(removed, proxies.back());
    proxies.pop_back();
  }
  void change() {
    const double kind = dice(0.0, 4.0);
    if (kind < 1.0) add();
    if (kind < 2.0) return remove();
    if (kind < 3.0) tree.MoveProxy(any(), random_box(dice), b2Vec2_zero);
  }
  bool is_current() { return search.is_current(BroadPhaseTree(tree), search_boxes(boxes)); }
  void find() { search.search(memory, BroadPhaseTree(tree), search_boxes(boxes)); }

  Dice dice;
  b2BroadPhase tree;
  std::vector<int> proxies;
  std::vector<b2AABB> boxes;
  LeafSearch memory;
  RememberedSearch search;
};

TEST(RememberedSearch, IsCurrentOnlyIfQueriesFindTheSame) {
  int current = 0;
  int outdated = 0;
  for (unsigned seed = 0; seed < 64; ++seed) {
    Searched searched(seed);
    EXPECT_FALSE(searched.is_current()) << "nothing was searched yet";
    for (int round = 0; round < 100; ++round) {
      searched.change();
      const bool is_current = searched.is_current();
      (is_current ? current : outdated) += 1;
      if (!is_current) searched.find();
      ASSERT_EQ(remembered(searched.search), found_by_box2d(searched.tree, searched.boxes))
          << "seed " << seed << ", round " << round << (is_current ? ", current" : "");
    }
  }
  EXPECT_GT(current, 2000);
  EXPECT_GT(outdated, 500);
}

/// So a search is remembered while something moves where no box is.
TEST(RememberedSearch, IsCurrentWhileSomethingMovesFarAway) {
  Searched searched(5);
  const int far = searched.tree.CreateProxy(box(100.0, 100.0, 0.5), nullptr);
  searched.tree.MoveProxy(far, box(101.0, 100.0, 0.5), b2Vec2_zero);
  searched.find();
  for (int k = 0; k < 50; ++k) {
    searched.tree.MoveProxy(far, box(102.0 + k, 100.0, 0.5), b2Vec2_zero);
    EXPECT_TRUE(searched.is_current()) << k;
  }
}

TEST(RememberedSearch, IsCurrentForBoxesInsideThoseThatWereSearched) {
  Searched searched(9);
  searched.find();
  ASSERT_TRUE(searched.is_current());
  searched.boxes[3] = box(static_cast<double>(searched.boxes[3].lowerBound.x),
                          static_cast<double>(searched.boxes[3].lowerBound.y), 0.4);
  EXPECT_TRUE(searched.is_current());
  searched.boxes[3].upperBound.x += 0.2F;
  EXPECT_FALSE(searched.is_current());
  searched.find();
  EXPECT_TRUE(searched.is_current());
  searched.boxes.pop_back();
  EXPECT_FALSE(searched.is_current());
}

/// The boxes of the nodes above it need not change with it.
TEST(RememberedSearch, IsNotCurrentIfAProxyMovesIntoABoxInsideTheRoot) {
  for (const bool comes : {true, false}) {
    b2BroadPhase tree;
    for (const double corner : {0.0, 99.0}) tree.CreateProxy(box(corner, corner, 1.0), nullptr);
    const b2AABB out = box(20.0, 80.0, 1.0);
    const b2AABB in = box(50.0, 50.0, 1.0);
    const int moved = tree.CreateProxy(comes ? out : in, nullptr);
    const std::vector<SearchBox> boxes = search_boxes({box(49.0, 49.0, 3.0)});
    LeafSearch memory;
    RememberedSearch search;
    search.search(memory, BroadPhaseTree(tree), boxes);
    ASSERT_EQ(search.leaves().size(), comes ? 0U : 1U);
    tree.MoveProxy(moved, comes ? in : out, b2Vec2_zero);
    EXPECT_FALSE(search.is_current(BroadPhaseTree(tree), boxes));
  }
}

/// The old root is as it was.
TEST(RememberedSearch, IsNotCurrentUnderANewRoot) {
  b2BroadPhase tree;
  tree.CreateProxy(box(0.0, 0.0, 1.0), nullptr);
  const std::vector<SearchBox> boxes = search_boxes({box(5.0, 5.0, 1.0)});
  LeafSearch memory;
  RememberedSearch search;
  search.search(memory, BroadPhaseTree(tree), boxes);
  ASSERT_TRUE(search.is_current(BroadPhaseTree(tree), boxes));
  tree.CreateProxy(box(5.0, 5.0, 1.0), nullptr);
  EXPECT_FALSE(search.is_current(BroadPhaseTree(tree), boxes));
}

/// Its nodes have smaller indices: what was remembered must not be read there.
TEST(RememberedSearch, IsNotCurrentInAnotherTree) {
  Searched searched(7);
  searched.find();
  b2BroadPhase small;
  for (int k = 0; k < 3; ++k) small.CreateProxy(random_box(searched.dice), nullptr);
  EXPECT_FALSE(searched.search.is_current(BroadPhaseTree(small), search_boxes(searched.boxes)));
}

}  // namespace
}  // namespace ribbon::box2d
