#include "ribbon/box2d/leaf_search.h"

#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/engine/coupling/tree_oracle.h"
#include "tests/support/dice.h"

// The search of the broad phase's tree finds what queries of Box2D find.

namespace ribbon::box2d {
namespace {

using test_support::Dice;
using tree_oracle::box;
using tree_oracle::found_by_box2d;
using tree_oracle::Pairs;
using tree_oracle::search_boxes;

b2AABB any_box(Dice& dice) { return box(dice(-9.0, 9.0), dice(-9.0, 9.0), dice(0.0, 3.0), dice(0.0, 3.0)); }

Pairs found_by_search(const b2BroadPhase& broad_phase, const std::vector<b2AABB>& boxes) {
  Pairs pairs;
  LeafSearch().find(BroadPhaseTree(broad_phase), search_boxes(boxes), [&](int leaf, BoxSet set) {
    for_each_box(set, [&](std::size_t k) { EXPECT_TRUE(pairs.insert({k, leaf}).second) << "found twice"; });
  });
  return pairs;
}

TEST(LeafSearch, FindsWhatQueriesFind) {
  Dice dice(3);
  b2BroadPhase broad_phase;
  std::vector<int> proxies;
  for (int round = 0; round < 200; ++round) {
    // The first proxies go first, so that the first nodes of the tree become free.
    if (round % 3 == 2 && !proxies.empty()) {
      broad_phase.DestroyProxy(proxies.front());
      proxies.erase(proxies.begin());
    }
    for (int k = 0; k < round % 5; ++k) proxies.push_back(broad_phase.CreateProxy(any_box(dice), nullptr));
    std::vector<b2AABB> boxes(1 + static_cast<std::size_t>(round) % LeafSearch::max_boxes);
    for (b2AABB& aabb : boxes) aabb = any_box(dice);
    EXPECT_EQ(found_by_search(broad_phase, boxes), found_by_box2d(broad_phase, boxes)) << "round " << round;
  }
}

/// It is a cheap test, so it may be wrong in one direction only.
TEST(LeafSearch, WhereNoLeafMayOverlapQueriesFindNothing) {
  Dice dice(8);
  int certain = 0;
  int found = 0;
  for (int round = 0; round < 400; ++round) {
    b2BroadPhase broad_phase;
    for (int k = 0; k < round % 40; ++k) broad_phase.CreateProxy(any_box(dice), nullptr);
    const std::vector<b2AABB> boxes{any_box(dice)};
    const bool finds = !found_by_box2d(broad_phase, boxes).empty();
    found += finds ? 1 : 0;
    if (may_overlap_leaf(BroadPhaseTree(broad_phase), SearchBox(boxes.front()))) continue;
    ++certain;
    EXPECT_FALSE(finds) << "round " << round;
  }
  EXPECT_GT(certain, 100);
  EXPECT_GT(found, 100);
}

TEST(LeafSearch, MayOverlapNoLeafBetweenTwoHeaps) {
  b2BroadPhase broad_phase;
  for (int k = 0; k < 50; ++k) {
    broad_phase.CreateProxy(box(-100.0 + 0.5 * k, 0.0, 1.0, 1.0), nullptr);
    broad_phase.CreateProxy(box(100.0 - 0.5 * k, 0.0, 1.0, 1.0), nullptr);
  }
  EXPECT_FALSE(may_overlap_leaf(BroadPhaseTree(broad_phase), SearchBox(box(0.0, 0.0, 1.0, 1.0))));
  EXPECT_TRUE(may_overlap_leaf(BroadPhaseTree(broad_phase), SearchBox(box(99.5, 0.5, 1.0, 1.0))));
}

TEST(LeafSearch, FindsNothingInAnEmptyTree) {
  b2BroadPhase broad_phase;
  const std::vector<b2AABB> boxes(3, box(-1e9, -1e9, 2e9, 2e9));
  EXPECT_TRUE(found_by_search(broad_phase, boxes).empty());
  const int only = broad_phase.CreateProxy(box(0.0, 0.0, 1.0, 1.0), nullptr);
  EXPECT_EQ(found_by_search(broad_phase, boxes).size(), 3U);
  broad_phase.DestroyProxy(only);
  EXPECT_TRUE(found_by_search(broad_phase, boxes).empty());
}

TEST(LeafSearch, BoxesOverlapAsInBox2D) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const float limit = std::numeric_limits<float>::max();
  std::vector<b2AABB> boxes{box(0.0, 0.0, 1.0, 1.0),        box(1.0, 0.0, 1.0, 1.0),   box(0.0, 1.0, 0.0, 0.0),
                            box(1.0 + 1e-6, 0.0, 1.0, 1.0), box(-3.0, -3.0, 9.0, 9.0), box(-0.0, -5.0, 0.0, 10.0)};
  boxes.push_back(boxes[0]);
  boxes.back().lowerBound.x = nan;
  boxes.push_back(boxes[0]);
  boxes.back().upperBound.y = -infinity;
  boxes.push_back(boxes[0]);
  boxes.back().lowerBound.x = -limit;
  boxes.back().upperBound.x = limit;
  for (const b2AABB& a : boxes) {
    for (const b2AABB& b : boxes) EXPECT_EQ(SearchBox(a).overlaps(b), b2TestOverlap(a, b));
  }
}

TEST(LeafSearch, BoxesMayShrinkDuringASearch) {
  b2BroadPhase broad_phase;
  for (int k = 0; k < 100; ++k) broad_phase.CreateProxy(box(k, 0.0, 0.5, 0.5), nullptr);
  std::vector<SearchBox> boxes{SearchBox(box(0.0, 0.0, 100.0, 1.0))};
  int found = 0;
  LeafSearch().find(BroadPhaseTree(broad_phase), boxes, [&](int, BoxSet) {
    ++found;
    boxes[0] = SearchBox(box(200.0, 0.0, 1.0, 1.0));
  });
  EXPECT_EQ(found, 1);
}

}  // namespace
}  // namespace ribbon::box2d
