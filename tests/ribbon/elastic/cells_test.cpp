#include "ribbon/elastic/cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "ribbon/system/cord_parts.h"

namespace ribbon {
namespace {

/// A straight ribbon of three columns and two rows.
CordParts straight_ribbon() {
  CordDef def;
  def.points = 3;
  def.rows = 2;
  def.length = 2.0;
  def.width = 0.5;
  def.stretch_stiffness = 1e3;
  def.area_stiffness = 1.0;
  return CordParts(def);
}

/// The positions with the first corner inverted by this share of the area of its cell.
std::vector<Vec2> inverted_by(const CordParts& cord, double share) {
  std::vector<Vec2> x = cord.state.positions;
  x[1] = x[0] - share * (x[1] - x[0]);
  return x;
}

TEST(Cells, KnowHowDeeplyTheyAreInverted) {
  CordParts cord = straight_ribbon();
  struct Case {
    double share;
    bool inverted;
    bool deeply;
  };
  for (const auto& [share, inverted, deeply] :
       {Case{-1.0, false, false}, Case{-0.001, false, false}, Case{0.0, true, false}, Case{0.005, true, false},
        Case{0.02, true, true}, Case{1.0, true, true}}) {
    const std::vector<Vec2> x = inverted_by(cord, share);
    cord.elasticity->lock();
    EXPECT_EQ(cord.elasticity->unlock(x), inverted) << share;
    EXPECT_EQ(cord.elasticity->has_deep_inversion(x), deeply) << share;
  }
}

TEST(Cells, ThatAreLockedForgetThatTheyWereTurnedBack) {
  CordParts cord = straight_ribbon();
  const std::vector<Vec2> inverted = inverted_by(cord, 0.005);
  const std::vector<Vec2> recovering = inverted_by(cord, -0.5);
  ASSERT_TRUE(cord.elasticity->unlock(inverted));
  EXPECT_TRUE(cord.elasticity->unlock(recovering)) << "until all of the cell has recovered";
  cord.elasticity->lock();
  const auto unlocked = cord.elasticity->unlocked();
  EXPECT_EQ(std::count(unlocked.begin(), unlocked.end(), 0), 2);
  EXPECT_FALSE(cord.elasticity->unlock(recovering));
}

}  // namespace
}  // namespace ribbon
