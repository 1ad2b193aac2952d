#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "tests/engine/coupling/gather_oracle.h"
#include "tests/support/allocations.h"
#include "tests/support/constants.h"
#include "tests/support/dice.h"
#include "tests/support/points.h"
#include "tests/support/shape_world.h"

// Gather remembers what it read of the world's tree, and searches again only where that has changed. In each tick of a
// long run it finds what a search of all fixtures finds.

namespace engine {
namespace {

using constants::dt;
using ribbon::Vec2;
using test_support::Dice;

constexpr double rope_spacing = 1.5;  // m, from cord to cord
constexpr int ropes_in_a_row = 14;

/// Ropes that hang at rest among static boxes, more than one group of them.
class HangingRopes {
 public:
  explicit HangingRopes(unsigned seed) : dice_(seed) {
    const int cords = 1 + below(dice_.coin() ? 20 : 150);
    for (int k = 0; k < cords; ++k) add_cord(k);
    for (int k = below(300); k > 0; --k) add_box();
  }

  /// Changes little, so that most of what was remembered is as it was.
  void disturb() {
    if (boxes_.empty()) return add_box();
    const auto k = static_cast<std::size_t>(below(static_cast<int>(boxes_.size())));
    b2Body& box = *boxes_[k];
    switch (below(9)) {
      case 0: add_box(); break;
      case 1: destroy(k); break;
      case 2:
        destroy(k);
        add_box();  // often at the address, and in the nodes of the tree, of the last one
        break;
      case 3: box.SetTransform(box.GetPosition() + b2Vec2(0.01F, 0.0F), 0.0F); break;  // often in its box in the tree
      case 4: box.SetTransform(ribbon::box2d::to_float(place()), 1.0F); break;
      case 5: box.SetEnabled(!box.IsEnabled()); break;
      case 6: box.SetType(box.GetType() == b2_staticBody ? b2_dynamicBody : b2_staticBody); break;
      case 7: push(below(coupling.size())); break;
      default: throw_ball();
    }
  }

  b2World world{b2Vec2(0.0F, -9.81F)};
  ribbon::box2d::Coupling coupling;

 private:
  int below(int n) { return std::min(n - 1, static_cast<int>(dice_() * n)); }
  Vec2 place() { return {dice_(-1.0, rope_spacing * ropes_in_a_row), dice_(-3.0, 16.0)}; }
  void add_cord(int k) {
    ribbon::CordDef def;
    def.points = 6;
    def.length = 1.0;
    def.radius = 0.02;
    def.allow_sleep = dice_.coin();
    const int row = k / ropes_in_a_row;
    const Vec2 pin{rope_spacing * (k % ropes_in_a_row), rope_spacing * row};
    def.positions = test_support::equally_spaced(def.points, pin, {0.0, -0.2});
    def.pins = {0};
    coupling.add(ribbon::Cord(def));
  }
  void add_box() {
    b2BodyDef def;
    def.position = ribbon::box2d::to_float(place());
    b2Body* const body = world.CreateBody(&def);
    const b2PolygonShape shape = test_support::box(dice_(0.05, 0.3), dice_(0.05, 0.3));
    body->CreateFixture(&shape, 1.0F);
    boxes_.push_back(body);
  }
  void destroy(std::size_t k) {
    world.DestroyBody(boxes_[k]);
    boxes_.erase(boxes_.begin() + static_cast<std::ptrdiff_t>(k));
  }
  void push(ribbon::box2d::CordId cord) { coupling.cord(cord).direct().set_velocity(5, {dice_(-3.0, 3.0), 0.0}); }
  void throw_ball() {
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position = ribbon::box2d::to_float(place());
    def.linearVelocity.Set(static_cast<float>(dice_(-40.0, 40.0)), 0.0F);
    b2Body* const body = world.CreateBody(&def);
    const b2CircleShape shape = test_support::circle(0.1);
    body->CreateFixture(&shape, 1.0F);
    boxes_.push_back(body);
  }

  Dice dice_;
  std::vector<b2Body*> boxes_;
};

/// Returns the number of fixtures found.
std::size_t compare(HangingRopes& ropes) {
  const gather_oracle::Speeds speeds = gather_oracle::speeds_in(ropes.world);
  ropes.coupling.gather(ropes.world, dt);
  std::size_t all = 0;
  for (const ribbon::box2d::CordId cord : ropes.coupling.cords()) {
    const ribbon::Box box = ropes.coupling.cord(cord).swept_aabb();
    const auto wanted = gather_oracle::by_looking_at_all(ropes.world, speeds, box, {}, dt);
    EXPECT_EQ(gather_oracle::by_gather(ropes.coupling, cord), wanted) << "cord " << cord;
    all += wanted.size();
  }
  return all;
}

void check_runs(unsigned first, unsigned last) {
  std::size_t all = 0;
  for (unsigned seed = first; seed < last; ++seed) {
    HangingRopes ropes(seed);
    for (int tick = 0; tick < 60; ++tick) {
      if (tick % 4 == 3) ropes.disturb();
      all += compare(ropes);
      ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << seed << ", tick " << tick;
      ropes.coupling.step();
      ropes.coupling.apply();
      ropes.world.Step(static_cast<float>(dt), 8, 3);
    }
  }
  EXPECT_GT(all, 100U * (last - first)) << "or the runs test nothing";
}

TEST(GatherAgain, FindsTheSameAsASearchOfAllFixtures) { check_runs(0, 60); }

TEST(LongGatherAgain, FindsTheSameAsASearchOfAllFixtures) { check_runs(60, 3000); }

/// A world that is smaller than the one before it, in the same memory.
TEST(GatherAgain, AnotherWorldAtTheSameAddressIsSearched) {
  std::optional<b2World> world(std::in_place, b2Vec2(0.0F, -9.81F));
  ribbon::box2d::Coupling coupling;
  ribbon::CordDef def;
  def.points = 5;
  def.length = 1.0;
  def.positions = test_support::equally_spaced(def.points, {0.0, 0.0}, {0.0, -0.25});
  def.pins = {0};
  coupling.add(ribbon::Cord(def));
  const auto add_box = [&world](double x) {
    b2BodyDef at;
    at.position = ribbon::box2d::to_float(Vec2{x, -0.5});
    const b2PolygonShape shape = test_support::box(0.1, 0.1);
    world->CreateBody(&at)->CreateFixture(&shape, 0.0F);
  };
  for (int k = 0; k < 5000; ++k) add_box(0.15 + 0.01 * k);
  for (int tick = 0; tick < 3; ++tick) coupling.tick(*world, dt);
  EXPECT_GT(coupling.cord(0).near().size(), 1U);
  world.emplace(b2Vec2(0.0F, -9.81F));
  add_box(0.15);
  coupling.tick(*world, dt);
  EXPECT_EQ(coupling.cord(0).near().size(), 1U);
}

/// Its memory is what a tick of many cords waits for.
TEST(GatherAgain, ACordOfACouplingHasNoSolverOfItsOwn) {
  ribbon::box2d::Coupling coupling;
  coupling.add(ribbon::Cord(ribbon::CordDef{}));
  const test_support::AllocationCount count;
  coupling.add(ribbon::Cord(ribbon::CordDef{}));
  const long coupled = count.held();
  const ribbon::Cord by_itself(ribbon::CordDef{});
  EXPECT_LT(coupled, count.held() - coupled);
}

TEST(GatherAgain, ATickOfCordsAtRestAllocatesNothing) {
  HangingRopes ropes(6);
  const auto tick = [&ropes] { ropes.coupling.tick(ropes.world, dt); };
  for (int k = 0; k < 300; ++k) tick();
  const test_support::AllocationCount count;
  for (int k = 0; k < 300; ++k) tick();
  EXPECT_EQ(count.so_far(), 0);
}

}  // namespace
}  // namespace engine
