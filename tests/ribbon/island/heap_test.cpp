#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "ribbon/direct_solver.h"
#include "ribbon/linear/index.h"
#include "tests/support/constants.h"

// Many cords that lie on each other, with soft contacts: each step is a few linear systems.

namespace ribbon {
namespace {

using constants::dt;
constexpr int count = 10;
constexpr double width = 0.05;   // m, of a ribbon
constexpr double radius = 0.01;  // m
constexpr int max_systems = 8;   // of a truncated solve: two active sets of each of four linearisations

CordDef ribbon_at(double height, const Accuracy& accuracy) {
  CordDef def;
  def.points = 11;
  def.rows = 2;
  def.length = 1.0;
  def.width = width;
  def.radius = radius;
  def.friction = 0.5;
  def.area_stiffness = 1.0;
  def.self_contact = def.cord_contact = true;
  def.accuracy = accuracy;
  solid(1e5, 0.3, 0.01, width).apply_to(def);
  for (int i = 0; i < def.points; ++i) {
    for (int j = 0; j < def.rows; ++j) def.positions.push_back({0.1 * i, height + width * j});
  }
  return def;
}

/// Ribbons that fall upon each other, and upon a floor at height 0.
struct Heap {
  std::vector<Cord> cords;
  std::vector<RigidBody> bodies{RigidBody{}};
  RigidSegment floor{0, {-1.0, 0.0}, {2.0, 0.0}, 0.0, 0.5, 0.0, 100};
  DirectSolver solver;
  std::vector<CordReport> reports = std::vector<CordReport>(at(count));

  explicit Heap(const Accuracy& accuracy = Accuracy::fast()) {
    for (int k = 0; k < count; ++k) cords.emplace_back(ribbon_at(0.05 + 0.1 * k, accuracy));
  }
  void step() {
    std::vector<IslandCord> list;
    for (std::size_t k = 0; k < cords.size(); ++k) list.push_back({&cords[k], {{}, {}, {}, {&floor, 1}}, k + 1});
    solver.step(list, bodies, dt, {0.0, -9.81}, reports);
  }
  bool leaves_out_newton() const {
    return std::all_of(cords.begin(), cords.end(), [](const Cord& cord) { return cord.save().newton_pause > 1; });
  }
  double top() const {
    double highest = 0.0;
    for (const Vec2 x : cords.back().positions()) highest = std::max(highest, x.y);
    return highest;
  }
  double fastest() const {
    double fastest = 0.0;
    for (const Cord& cord : cords) {
      for (const Vec2 v : cord.velocities()) fastest = std::max(fastest, length(v));
    }
    return fastest;
  }
};

TEST(Heap, ComesToRestWithFewSystemsAStep) {
  Heap heap;
  int most = 0;
  int unconverged_at_rest = 0;
  for (int k = 0; k < 240; ++k) {
    heap.step();
    // While they fall the ribbons are islands by themselves.
    if (heap.solver.islands() == 1) most = std::max(most, heap.solver.total().iterations);
    if (k >= 180) unconverged_at_rest += heap.solver.total().unconverged;
  }
  EXPECT_EQ(heap.solver.islands(), 1);
  EXPECT_GT(most, 0);
  EXPECT_LE(most, max_systems);
  EXPECT_EQ(unconverged_at_rest, 0);
  EXPECT_LE(heap.fastest(), 0.05);
  const double thickness = width + 2.0 * radius;
  EXPECT_NEAR(heap.top(), count * thickness - radius, 0.1 * thickness);
}

/// Without soft contacts Newton's method is tried first. Where it fails it is left out.
TEST(Heap, LeavesOutNewtonsMethodWhereItFails) {
  Heap heap(Accuracy::balanced());
  int left_out = 0;
  for (int k = 0; k < 120; ++k) {
    const bool leaves_out = heap.leaves_out_newton();
    heap.step();
    if (!leaves_out || heap.solver.islands() > 1) continue;
    ++left_out;
    EXPECT_LE(heap.solver.total().iterations, max_systems) << k;
  }
  EXPECT_GE(left_out, 15);
}

/// Cords that failed before they lay in the heap take the heap's solve, and not the whole of the linearised one.
TEST(Heap, IsTruncatedWhereNewtonsMethodIsLeftOut) {
  Heap heap;
  for (int k = 0; k < 60; ++k) heap.step();
  ASSERT_EQ(heap.solver.islands(), 1);
  for (Cord& cord : heap.cords) {
    Cord::State state = cord.save();
    state.newton_pause = 3;
    cord.restore(state);
  }
  heap.step();
  EXPECT_LE(heap.solver.total().iterations, max_systems);
  EXPECT_EQ(heap.solver.total().posed, 0);
}

}  // namespace
}  // namespace ribbon
