// Long runs of the thesis's cord under its conditions A to D.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

#include "tests/support/thesis_scenes.h"

namespace ribbon {
namespace {

using test_support::earth_gravity;
using test_support::frame_dt;
using test_support::thesis_conditions;

class LongConditions : public testing::TestWithParam<test_support::ThesisCondition> {};

TEST_P(LongConditions, APinnedCordFallsSwingsAndComesToRest) {
  ThesisDef def = test_support::thesis_def(GetParam());
  def.pins = {def.h / 2};
  ThesisCord cord(def);
  double furthest_left = 0.0;
  double highest_speed = 0.0;
  for (int frame = 0; frame < 25 * 60; ++frame) {
    cord.step(frame_dt, earth_gravity);
    furthest_left = std::min(furthest_left, cord.positions().back().x);
    highest_speed = std::max(highest_speed, test_support::fastest(cord));
  }
  const double length = (def.w - 1) * def.spacing;
  EXPECT_LT(furthest_left, -0.3 * length);  // it swung through to the other side
  EXPECT_LT(highest_speed, 4.0 * std::sqrt(2.0 * 9.81 * length));
  EXPECT_LT(test_support::fastest(cord), 1e-3);
  EXPECT_LT(test_support::centre_of_mass(cord).y, -0.45 * length);
  EXPECT_EQ(test_support::inverted_triangles(cord), 0);
}

/// Drags the cord's last point at 20 m/s, with a new direction every few frames, below the pins and within the cord's
/// length.
/// (If a cord in the plane is dragged around its anchor, it stays wound around it, as it should.)
class Yank {
 public:
  Yank(Vec2 start, double length, unsigned seed) : random_(seed), at_(start), length_(length) {}

  Vec2 next() {
    if (left_-- == 0) {
      left_ = static_cast<int>(random_() % 6);
      const double angle = static_cast<double>(random_() % 6283) / 1000.0;
      way_ = {std::cos(angle), std::sin(angle)};
    }
    Vec2 next = at_ + (20.0 * frame_dt) * way_;
    if (length(next) > 0.9 * length_ || next.y > 0.0) {
      const Vec2 inwards = Vec2{0.0, -0.45 * length_} - at_;
      way_ = (1.0 / length(inwards)) * inwards;
      next = at_ + (20.0 * frame_dt) * way_;
    }
    return at_ = next;
  }

 private:
  std::mt19937 random_;
  Vec2 at_;
  Vec2 way_{1.0, 0.0};
  double length_;
  int left_ = 0;
};

struct YankResult {
  bool finite = true;
  double most_energy = 0.0;
};

YankResult yank(ThesisCord& cord, Vec2 gravity, unsigned seed) {
  const int point = cord.mesh().size() - 1;
  Yank drag(cord.positions().back(), (cord.mesh().w - 1) * cord.mesh().spacing, seed);
  YankResult result;
  for (int frame = 0; frame < 10'000; ++frame) {
    cord.operate(point, drag.next());
    cord.step(frame_dt, gravity);
    result.finite = result.finite && test_support::all_finite(cord);
    result.most_energy = std::max(result.most_energy, test_support::kinetic_energy(cord));
  }
  cord.release(point);
  for (int frame = 0; frame < 3'000; ++frame) cord.step(frame_dt, gravity);
  return result;
}

/// Points at 20 m/s have 0.4 J per gram; much more would be spurious energy.
double plausible_energy(const ThesisCord& cord) {
  return 10.0 * 0.5 * cord.mesh().size() * cord.def().point_mass * 20.0 * 20.0;
}

constexpr std::array<unsigned, 2> yank_seeds = {2017, 2018};

TEST_P(LongConditions, YankedAboutWithoutGravityEveryLengthComesBack) {
  double worst = 0.0;
  for (const unsigned seed : yank_seeds) {
    ThesisCord cord(test_support::hanging(GetParam()));
    const YankResult result = yank(cord, {}, seed);
    EXPECT_TRUE(result.finite);
    EXPECT_LT(result.most_energy, plausible_energy(cord));
    EXPECT_EQ(test_support::inverted_triangles(cord), 0);
    worst = std::max(worst, test_support::worst_stretch(cord));
  }
  EXPECT_LT(worst, 0.03);
  RecordProperty("worst_stretch", std::to_string(worst));
}

/// Returns the largest |length ratio − 1| between the same connections of two cords.
double worst_difference(const ThesisCord& cord, const ThesisCord& undisturbed) {
  double worst = 0.0;
  for (const Connection& bar : cord.mesh().connections) {
    const auto a = static_cast<std::size_t>(bar.a);
    const auto b = static_cast<std::size_t>(bar.b);
    const double now = length(cord.positions()[b] - cord.positions()[a]);
    const double then = length(undisturbed.positions()[b] - undisturbed.positions()[a]);
    worst = std::max(worst, std::abs(now / then - 1.0));
  }
  return worst;
}

/// Under gravity the material stretches: every length returns to that of a cord that was never dragged.
TEST_P(LongConditions, YankedAboutUnderGravityItHangsAsBefore) {
  ThesisCord undisturbed(test_support::hanging(GetParam()));
  for (int frame = 0; frame < 3'000; ++frame) undisturbed.step(frame_dt, earth_gravity);
  double worst = 0.0;
  for (const unsigned seed : yank_seeds) {
    ThesisCord cord(test_support::hanging(GetParam()));
    const YankResult result = yank(cord, earth_gravity, seed);
    EXPECT_TRUE(result.finite);
    EXPECT_LT(result.most_energy, plausible_energy(cord));
    EXPECT_EQ(test_support::inverted_triangles(cord), 0);
    worst = std::max(worst, worst_difference(cord, undisturbed));
  }
  EXPECT_LT(worst, 0.03);
  RecordProperty("worst_length_against_calm", std::to_string(worst));
  RecordProperty("undisturbed_length_ratio", std::to_string(test_support::length_ratio(undisturbed)));
}

INSTANTIATE_TEST_SUITE_P(Thesis, LongConditions, testing::ValuesIn(thesis_conditions),
                         [](const auto& condition) { return std::string(condition.param.name); });

TEST(LongCord, DroppedOnACircleItComesToRestAroundIt) {
  ThesisDef def = test_support::thesis_def(thesis_conditions[0]);
  def.positions = lay_along(std::array{Vec2{-0.6, 0.4}, Vec2{0.6, 0.4}}, def.w, def.h, def.spacing);
  def.pins = {0, 1, 48, 49};
  ThesisCord cord(def);
  for (const int p : {0, 1}) cord.constrain(p, cord.positions()[static_cast<std::size_t>(p)] + Vec2{0.25, 0.0});
  for (const int p : {48, 49}) cord.constrain(p, cord.positions()[static_cast<std::size_t>(p)] - Vec2{0.25, 0.0});
  std::array<RigidBody, 1> bodies;
  const std::array<RigidCircle, 1> circles = {RigidCircle{0, {0.0, 0.0}, 0.2}};
  StepReport report;
  for (int frame = 0; frame < 25 * 60; ++frame) report = cord.step(frame_dt, earth_gravity, {bodies, circles, {}});
  EXPECT_GT(report.circle_contacts, 0);
  EXPECT_LT(test_support::fastest(cord), 1e-3);
  EXPECT_EQ(test_support::inverted_triangles(cord), 0);
  double nearest = 1.0;
  for (const Vec2 p : cord.positions()) nearest = std::min(nearest, length(p));
  EXPECT_GT(nearest, 0.2 - 1e-3);
  EXPECT_LT(nearest, 0.2 + 1e-2);
}

TEST(LongCord, AFreeCordAndAFreeCircleThatCollideConserveMomentum) {
  ThesisDef def = test_support::thesis_def(thesis_conditions[0]);
  def.drag = 0.0;
  ThesisCord cord(def);
  for (int p = 0; p < cord.mesh().size(); ++p) cord.set_velocity(p, {0.0, -1.0});
  RigidBody body;
  body.position = {0.5, -0.4};
  body.velocity = {0.3, 0.8};
  body.angular_velocity = 2.0;
  body.inverse_mass = 1.0 / 0.05;
  body.inverse_inertia = 1.0 / (0.05 * 0.01);
  std::array<RigidBody, 1> bodies = {body};
  // Two circles on one body, off its centre.
  std::array<RigidCircle, 2> circles = {RigidCircle{0, {0.1, 0.0}, 0.08}, RigidCircle{0, {-0.1, 0.05}, 0.1}};
  const auto momentum = [&] { return test_support::momentum(cord) + 0.05 * bodies[0].velocity; };
  const Vec2 before = momentum();
  int contacts = 0;
  for (int frame = 0; frame < 600; ++frame) {
    contacts += cord.step(frame_dt, {}, {bodies, circles, {}}).circle_contacts;
    bodies[0].velocity += bodies[0].inverse_mass * bodies[0].impulse;
    bodies[0].angular_velocity += bodies[0].inverse_inertia * bodies[0].angular_impulse;
    bodies[0].position += frame_dt * bodies[0].velocity;
    const double turn = frame_dt * bodies[0].angular_velocity;
    for (RigidCircle& circle : circles) {
      circle.offset = {std::cos(turn) * circle.offset.x - std::sin(turn) * circle.offset.y,
                       std::sin(turn) * circle.offset.x + std::cos(turn) * circle.offset.y};
    }
    bodies[0].impulse = {};
    bodies[0].angular_impulse = 0.0;
    EXPECT_NEAR(length(momentum() - before), 0.0, 1e-9 * length(before));
  }
  EXPECT_GT(contacts, 10);
  EXPECT_GT(length(bodies[0].velocity - body.velocity), 0.1);
  EXPECT_TRUE(test_support::all_finite(cord));
}

TEST(LongCord, FoldedOnItselfItComesToRestWhereItsCentreOfMassGoes) {
  ThesisDef def = test_support::thesis_def(thesis_conditions[0]);
  // A hairpin: the two halves are side by side, a few millimetres apart, and run into each other.
  def.positions = lay_along(std::array{Vec2{0.0, 0.0}, Vec2{0.575, 0.0}, Vec2{0.575, 0.085}, Vec2{-1.0, 0.085}}, def.w,
                            def.h, def.spacing);
  ThesisCord cord(def);
  for (int p = 0; p < cord.mesh().size(); ++p) {
    cord.set_velocity(p, {0.2, cord.positions()[static_cast<std::size_t>(p)].y > 0.0425 ? -0.4 : 0.5});
  }
  Vec2 momentum = test_support::momentum(cord);
  Vec2 centre = test_support::centre_of_mass(cord);
  const double mass = cord.mesh().size() * def.point_mass;
  const double substep = frame_dt / def.substeps;
  int contacts = 0;
  int limited = 0;
  for (int frame = 0; frame < 20 * 60; ++frame) {
    const StepReport report = cord.step(frame_dt, {});
    contacts += report.self_contacts;
    limited += report.motion_limited;
    for (int n = 0; n < def.substeps; ++n) {  // drag is the only external force
      momentum = (1.0 / (1.0 + def.drag * substep)) * momentum;
      centre += (substep / mass) * momentum;
    }
    EXPECT_NEAR(length(test_support::momentum(cord) - momentum), 0.0, 1e-9 * 0.1);
    EXPECT_NEAR(length(test_support::centre_of_mass(cord) - centre), 0.0, 1e-9);
  }
  EXPECT_EQ(limited, 0);
  EXPECT_GT(contacts, 50);
  EXPECT_LT(test_support::fastest(cord), 1e-3);
  EXPECT_EQ(test_support::inverted_triangles(cord), 0);
}

}  // namespace
}  // namespace ribbon
