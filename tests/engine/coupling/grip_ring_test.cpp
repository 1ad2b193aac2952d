// Hands that slide along ropes: the rope runs through them as through rings.

#include <cmath>
#include <numeric>

#include "ribbon/box2d/crossing.h"
#include "ribbon/box2d/world_snapshot.h"
#include "ribbon/cord_forces.h"
#include "tests/engine/coupling/grip_world.h"

namespace engine {
namespace {

using ribbon::box2d::GripId;
using ribbon::box2d::GripState;
using ribbon::box2d::to_double;

constexpr double mass = 70.0;
const Vec2 end{10.0, -2.0};

CordDef slack_rope(const ribbon::Accuracy& accuracy, int points = 41) {
  CordDef def;
  def.points = points;
  def.length = 12.0;
  def.mass_per_length = 0.05;
  def.accuracy = accuracy;
  return def;
}

/// A body on a slack rope between two pins. As long as the rope is taut it is on an ellipse whose foci are the pins.
struct Zipline {
  GripWorld scene;
  b2Body* body = nullptr;
  GripId grip = 0;
  Vec2 start;
  double length_of_rope;

  Zipline(CordDef def, double strength) : length_of_rope(def.length) {
    const int points = def.points;
    const double whole = def.length;
    def.pins = {0, points - 1};
    const double span = length(end);
    const Vec2 axis = (1.0 / span) * end;
    const int first = static_cast<int>(std::lround(0.15 * (points - 1)));
    const double side = whole * first / (points - 1);
    const double other = whole - side;
    const double along = (side * side - other * other + span * span) / (2.0 * span);
    start = along * axis + std::sqrt(side * side - along * along) * Vec2{axis.y, -axis.x};
    for (int i = 0; i < points; ++i) {
      const double behind = static_cast<double>(i - first) / (points - 1 - first);
      def.positions.push_back(i < first ? (static_cast<double>(i) / first) * start : start + behind * (end - start));
    }
    scene.coupling.add(Cord(def));
    body = scene.add_body(start, mass);
    grip = scene.coupling.hold(*body, {.cord = 0, .arc = side, .strength = strength});
  }
  Vec2 center() const { return to_double(body->GetWorldCenter()); }
  double speed() const { return length(scene.coupling.body(*body).velocity()); }
  GripState state() const { return scene.coupling.grip(grip).state(); }
  const Cord& cord() const { return scene.coupling.cord(0).direct(); }
  /// m, from the ellipse.
  double off() const { return length(center()) + length(center() - end) - length_of_rope; }
  /// m, at which both sides of the rope rise at the same angle, whose cosine is the span across over the length.
  double lowest() const { return 0.5 * (end.y - std::sqrt(length_of_rope * length_of_rope - end.x * end.x)); }
};

/// Slid along the lines of its links, the body would get beside the rope, bounce from corner to corner, and reach 0.5
/// to 0.8 of this speed.
TEST(GripRing, SlidesOnASlackRopeAsABeadOnAnEllipse) {
  for (const ribbon::Accuracy& accuracy :
       {ribbon::Accuracy::fast(), ribbon::Accuracy::balanced(), ribbon::Accuracy::accurate()}) {
    for (const int points : {21, 41, 81}) {
      Zipline line(slack_rope(accuracy, points), 0.0);
      const double top_speed = std::sqrt(2.0 * g * (line.start.y - line.lowest()));
      double fastest = 0.0;
      double farthest = 0.0;
      for (int k = 0; k < 300; ++k) {
        line.scene.tick();
        fastest = std::max(fastest, line.speed());
        farthest = std::max(farthest, line.center().x);
        ASSERT_LE(std::abs(line.off()), 2e-2) << points << ", tick " << k;
        ASSERT_LE(length(line.state().place - line.center()), 5e-3) << points << ", tick " << k;
      }
      EXPECT_GE(fastest, 0.97 * top_speed) << points;
      EXPECT_LE(fastest, 1.001 * top_speed) << points;
      EXPECT_GE(farthest, 10.8) << points;  // as high as it began, without losses: 10.93
    }
  }
}

/// Friction takes its strength times the way along the rope, which the arc tells.
TEST(GripRing, LosesItsStrengthTimesItsWay) {
  for (const double strength : {20.0, 100.0}) {
    Zipline line(slack_rope(ribbon::Accuracy::balanced()), strength);
    Zipline without(slack_rope(ribbon::Accuracy::balanced()), 0.0);
    const double begin = line.state().arc;
    line.scene.tick(75);
    while (without.state().arc < line.state().arc) without.scene.tick();
    const auto energy = [](const Zipline& of) {
      return 0.5 * mass * of.speed() * of.speed() + mass * g * of.center().y;
    };
    const double loss = energy(without) - energy(line);
    const double way = line.state().arc - begin;
    ASSERT_GE(way, 3.0);
    EXPECT_NEAR(loss, strength * way, 0.03 * strength * way) << strength;
  }
}

/// It stays where the tensions on both sides differ by no more than it holds.
TEST(GripRing, ComesToRestWhereItHolds) {
  for (const ribbon::Accuracy& accuracy :
       {ribbon::Accuracy::fast(), ribbon::Accuracy::balanced(), ribbon::Accuracy::accurate()}) {
    Zipline line(slack_rope(accuracy), 150.0);
    line.scene.tick(900);
    EXPECT_LE(line.speed(), 1e-3);
    EXPECT_FALSE(line.state().slips);
    EXPECT_NEAR(line.state().pull.y, mass * g, 1.0);
    EXPECT_LE(std::abs(line.off()), 5e-3);
    const int point = line.state().point;
    EXPECT_EQ(line.state().along, 0.0);
    const double before = line.cord().tensions()[static_cast<std::size_t>(point) - 1];
    const double behind = line.cord().tensions()[static_cast<std::size_t>(point)];
    EXPECT_LE(std::abs(behind - before), 150.0);
  }
}

/// The point where the hand is has parts of links on both sides, which are as long as two links.
TEST(GripRing, KeepsLengthAndMassOfTheRope) {
  CordDef rope = slack_rope(ribbon::Accuracy::fast());
  rope.mass_per_length = 1.0;
  Zipline line(rope, 0.0);
  for (int k = 0; k < 120; ++k) {
    line.scene.tick();
    const Cord& cord = line.cord();
    double rest = 0.0;
    double all = 0.0;
    double shortest = 1.0;
    for (int i = 0; i < 40; ++i) {
      rest += cord.rest_length(i);
      shortest = std::min(shortest, cord.rest_length(i));
    }
    for (int p = 0; p < 41; ++p) all += cord.mass(p);
    ASSERT_NEAR(rest, 12.0, 1e-9) << k;
    ASSERT_NEAR(all, 12.0, 1e-9) << k;
    ASSERT_GE(shortest, 0.02 * 0.3) << k;
    const GripState state = line.state();
    if (k == 0) continue;  // it has begun to slide
    ASSERT_EQ(state.along, 0.0) << k;
    ASSERT_LE(length(state.place - line.center()), 1e-5) << k;
    ASSERT_NEAR(cord.rest_length(state.point - 1) + cord.rest_length(state.point), 0.6, 1e-9) << k;
    for (const int p : {state.point - 1, state.point, state.point + 1}) {
      ASSERT_NEAR(cord.mass(p), 0.5 * (cord.rest_length(p - 1) + cord.rest_length(p)), 1e-9) << k << ", " << p;
    }
  }
}

TEST(GripRing, KeepsTheMomentumOfAFreeRopeAndItsHands) {
  for (const ribbon::Accuracy& accuracy :
       {ribbon::Accuracy::fast(), ribbon::Accuracy::balanced(), ribbon::Accuracy::accurate()}) {
    GripWorld scene;
    scene.world.SetGravity({0.0F, 0.0F});
    CordDef def;
    def.points = 41;
    def.length = 8.0;
    def.mass_per_length = 0.5;
    def.accuracy = accuracy;
    for (int i = 0; i < 41; ++i) {
      const double arc = 0.2 * i;
      def.positions.push_back(i < 20 ? Vec2{-4.0 + arc, 0.0} : Vec2{0.0, arc - 4.0});
    }
    scene.coupling.add(Cord(def));
    b2Body* hand = scene.add_body({0.0, 0.0}, 40.0);
    const GripId grip = scene.coupling.hold(*hand, {.cord = 0, .strength = 5.0, .point = 20});
    b2Body* load = scene.add_body({-4.0, 0.0}, 10.0);
    scene.coupling.hold(*load, {.cord = 0, .point = 0});
    load->SetLinearVelocity({-5.0F, 1.0F});
    const auto momentum = [&] {
      const Cord& cord = scene.coupling.cord(0).direct();
      Vec2 sum = 40.0 * scene.coupling.body(*hand).velocity() + 10.0 * scene.coupling.body(*load).velocity();
      for (std::size_t p = 0; p < 41; ++p) sum += cord.mass(static_cast<int>(p)) * cord.velocities()[p];
      return sum;
    };
    const double begin = scene.coupling.grip(grip).state().arc;
    scene.tick(25);
    EXPECT_GE(scene.coupling.grip(grip).state().arc, begin + 0.5);
    // The mass of a point is lumped with the ring, and is found again behind it: 0.1 kg at 3.5 m/s. The rope that runs
    // around a right angle turns 43 kg·m/s in this time.
    EXPECT_LE(length(momentum() - Vec2{-50.0, 10.0}), 1.0);
  }
}

/// On a wheel a rope would touch nothing. The hand stops in a bend instead, and nothing is crossed.
TEST(GripRing, IsNotWhereSomethingMayTouchTheRope) {
  Zipline line(slack_rope(ribbon::Accuracy::balanced()), 0.0);
  b2BodyDef definition;
  definition.position = {4.0F, -4.2F};
  b2PolygonShape box;
  box.SetAsBox(0.4F, 0.2F);
  line.scene.world.CreateBody(&definition)->CreateFixture(&box, 0.0F);
  bool slid_on = false;
  for (int k = 0; k < 300; ++k) {
    line.scene.tick();
    ASSERT_LE(length(line.state().place - line.center()), 0.05) << k;
    for (const Vec2 x : line.cord().positions()) {
      ASSERT_FALSE(std::abs(x.x - 4.0) < 0.39 && std::abs(x.y + 4.2) < 0.19) << k;
    }
    slid_on = slid_on || line.center().x > 3.0;
  }
  EXPECT_TRUE(slid_on);
}

/// The same where another rope is in the way, which is taut between two pins: no link of one gets through the other.
TEST(GripRing, IsNotWhereAnotherRopeMayTouchTheRope) {
  CordDef rope = slack_rope(ribbon::Accuracy::balanced());
  rope.radius = 0.02;
  rope.cord_contact = true;
  Zipline line(rope, 0.0);
  CordDef def;
  def.points = 9;
  def.length = 0.8;
  def.radius = 0.02;
  def.mass_per_length = 0.5;
  def.cord_contact = true;
  def.pins = {0, 8};
  for (int i = 0; i < 9; ++i) def.positions.push_back({3.6 + 0.1 * i, -3.9});
  line.scene.coupling.add(Cord(def));
  bool slid_on = false;
  for (int k = 0; k < 300; ++k) {
    line.scene.tick();
    const auto taut = line.scene.coupling.cord(1).positions();
    const auto slack = line.cord().positions();
    for (std::size_t i = 0; i + 1 < slack.size(); ++i) {
      for (std::size_t j = 0; j + 1 < taut.size(); ++j) {
        ASSERT_FALSE(ribbon::box2d::crossing(slack[i], slack[i + 1], taut[j], taut[j + 1]))
            << k << ": " << i << ", " << j;
      }
    }
    slid_on = slid_on || line.center().x > 3.0;
  }
  EXPECT_TRUE(slid_on);
}

/// A state that is saved while the hand slides is continued with the same bits.
TEST(GripRing, ContinuesASavedStateWithTheSameBits) {
  Zipline line(slack_rope(ribbon::Accuracy::balanced()), 10.0);
  line.scene.tick(40);
  ASSERT_TRUE(line.state().slips);
  ribbon::box2d::WorldSnapshot snapshot;
  snapshot.save(line.scene.world);
  const auto saved = line.scene.coupling.save(line.scene.world);
  line.scene.tick(40);
  const auto expected = state_without_errors(line.scene);
  snapshot.restore(line.scene.world);
  line.scene.coupling.restore(saved, line.scene.world);
  line.scene.tick(40);
  EXPECT_TRUE(state_without_errors(line.scene) == expected);
}

/// A mass that is attached while the hand is between two points adds to what the rope has there.
TEST(GripRing, LeavesTheRightMassesWhereOneIsAttached) {
  CordDef rope = slack_rope(ribbon::Accuracy::fast());
  rope.mass_per_length = 1.0;
  Zipline line(rope, 0.0);
  line.scene.tick(40);
  const int point = line.state().point;
  ribbon::Cord& cord = line.scene.coupling.cord(0).direct();
  const double before = cord.mass(point + 1);
  cord.attach_mass(point + 1, 2.0);
  EXPECT_NEAR(cord.mass(point + 1), before + 2.0, 1e-12);
  line.scene.tick(80);
  double all = 0.0;
  for (int p = 0; p < 41; ++p) all += cord.mass(p);
  EXPECT_NEAR(all, 14.0, 1e-9);
}

/// Let go in a fold, the rope swings on, no faster than it was.
TEST(GripRing, LetsGoInAFoldWithoutAJolt) {
  Zipline line(slack_rope(ribbon::Accuracy::balanced()), 0.0);
  line.scene.tick(50);
  const auto energy = [&] { return energy_of(line.cord(), {0.0, -g}).total(); };
  const double before = energy();
  line.scene.coupling.grip(line.grip).release();
  for (int k = 0; k < 60; ++k) {
    line.scene.tick();
    ASSERT_LE(energy(), before + 0.1) << k;
  }
}

/// The links beside the hand are damped again after the step, at the speed at which they stretch. Were their tensions
/// those of the wheel, which is not damped, the energy of the rope would jump by 100 J.
TEST(GripRing, GainsNoEnergyOnADampedRope) {
  CordDef rope = slack_rope(ribbon::Accuracy::balanced());
  rope.stretch_stiffness = 1e5;
  rope.damping = 0.05;
  Zipline line(rope, 20.0);
  const auto energy = [&] {
    return 0.5 * mass * line.speed() * line.speed() + mass * g * line.center().y +
           energy_of(line.cord(), {0.0, -g}).total();
  };
  double before = energy();
  for (int k = 0; k < 300; ++k) {
    line.scene.tick();
    ASSERT_LE(energy(), before + 2.0) << k;
    before = energy();
  }
}

/// A body that hangs in the corner of a rope and cannot be held there slides to its lowest place, and comes to rest.
TEST(GripRing, HangsWhereBothSidesRise) {
  for (const ribbon::Accuracy& accuracy :
       {ribbon::Accuracy::fast(), ribbon::Accuracy::balanced(), ribbon::Accuracy::accurate()}) {
    GripWorld scene;
    CordDef def;
    def.points = 11;
    def.length = 10.0;
    def.mass_per_length = 0.1;
    def.pins = {0, 10};
    def.accuracy = accuracy;
    for (int i = 0; i < 11; ++i) {
      def.positions.push_back(i < 5 ? Vec2{-3.0 + 0.6 * i, -0.8 * i} : Vec2{0.6 * (i - 5), -4.0 + 0.8 * (i - 5)});
    }
    scene.coupling.add(Cord(def));
    b2Body* body = scene.add_body({-1.5, -2.0}, mass);
    const GripId grip = scene.coupling.hold(*body, {.cord = 0, .arc = 2.5, .strength = 100.0});
    scene.tick(900);
    const GripState state = scene.coupling.grip(grip).state();
    EXPECT_NEAR(state.pull.y, mass * g, 1.0);
    EXPECT_LE(length(scene.coupling.body(*body).velocity()), 1e-3);
    const Vec2 center = to_double(body->GetWorldCenter());
    EXPECT_NEAR(length(center - Vec2{-3.0, 0.0}) + length(center - Vec2{3.0, 0.0}), 10.0, 5e-3);
    // By 100 N the hand holds tensions of 429 N apart, which it has where the rope is turned by so much.
    EXPECT_NEAR(center.y, -4.0, 0.1);
  }
}

}  // namespace
}  // namespace engine
