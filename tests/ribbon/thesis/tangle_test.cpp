#include "ribbon/thesis/tangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "ribbon/thesis/mesh.h"

namespace ribbon {
namespace {

/// The tangled columns of a cord of 40 × 2 points, 0.1 m apart, laid along `path`.
std::vector<char> tangled_columns(const std::vector<Vec2>& path) {
  const Mesh mesh = make_mesh(40, 2, 0.1);
  const std::vector<Vec2> x = lay_along(path, 40, 2, 0.1);
  const std::vector<double> radii(x.size(), 0.04);
  BroadPhase near(mesh, true);
  near.reserve(x.size());
  near.update(x, x, radii);
  std::vector<char> tangled(40, 7);
  const int count = find_tangled_columns(mesh, x, near, tangled);
  EXPECT_EQ(count, std::count(tangled.begin(), tangled.end(), 1));
  EXPECT_EQ(std::count(tangled.begin(), tangled.end(), 7), 0);  // each is marked or not
  return tangled;
}

TEST(Tangle, StraightCurvedAndHairpinCordsAreNotTangled) {
  const std::vector<std::vector<Vec2>> paths = {{{0.0, 0.0}, {1.0, 0.0}},
                                                {{0.0, 0.0}, {1.5, 0.0}, {2.5, 1.0}, {2.5, 3.0}},
                                                {{0.0, 0.0}, {1.9, 0.0}, {1.9, 0.2}, {0.0, 0.2}}};
  for (const auto& path : paths) {
    const std::vector<char> tangled = tangled_columns(path);
    EXPECT_EQ(std::count(tangled.begin(), tangled.end(), 1), 0);
  }
}

TEST(Tangle, ALoopIsTangledAroundItsCrossingAndOnlyThere) {
  // Right along y = 0 to x = 1.45, up, back to x = 0.55, down across the beginning.
  const std::vector<char> tangled = tangled_columns({{0.0, 0.0}, {1.45, 0.0}, {1.45, 0.6}, {0.55, 0.6}, {0.55, -2.0}});
  // The crossing at (0.55, 0) is 0.55 m along, and 1.45 + 0.6 + 0.9 + 0.6 = 3.55 m along.
  for (const int column : {5, 6, 35, 36}) EXPECT_EQ(tangled[static_cast<std::size_t>(column)], 1) << column;
  for (const int column : {0, 1, 10, 15, 20, 25, 30}) EXPECT_EQ(tangled[static_cast<std::size_t>(column)], 0) << column;
}

}  // namespace
}  // namespace ribbon
