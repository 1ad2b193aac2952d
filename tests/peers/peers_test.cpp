#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "tests/peers/figures.h"
#include "tests/peers/recording.h"
#include "tests/peers/runners.h"
#include "tests/peers/scenes.h"
#include "tests/peers/table.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/refusal.h"

namespace peers {
namespace {

using ribbon::Vec2;
using test_support::CoupledWorld;

constexpr double inextensible = std::numeric_limits<double>::infinity();

const Scene& scene(const std::string& name) {
  for (const Scene& s : scenes()) {
    if (s.name == name) return s;
  }
  throw std::invalid_argument("no scene is named " + name);
}

Plan plan_for(const Scene& s) { return plan_of(s.set_up, s.settling_ticks, s.ticks); }

Vec2 end_of(const BodyPlan& link, double side) {
  return link.position + side * link.half_length * Vec2{std::cos(link.angle), std::sin(link.angle)};
}

/// Returns a frame with all objects at their start.
Frame at_start(const Plan& plan) {
  Frame frame;
  frame.us = 1.0;
  for (const CordPlan& cord : plan.cords) frame.cords.push_back(cord.def.positions);
  for (const int moving_body : plan.moving_bodies())
    frame.moving_bodies.push_back(plan.bodies[static_cast<std::size_t>(moving_body)].position);
  return frame;
}

TEST(PeersPlan, AChainHasTheShapeAndMassOfItsCord) {
  for (const Scene& s : scenes()) {
    const Plan plan = plan_for(s);
    for (const CordPlan& cord : plan.cords) {
      if (cord.def.rows > 1) continue;
      ASSERT_EQ(cord.links.size() + 1, cord.def.positions.size()) << s.name;
      double mass = 0.0;
      for (std::size_t k = 0; k < cord.links.size(); ++k) {
        const BodyPlan& link = plan.bodies[static_cast<std::size_t>(cord.links[k])];
        EXPECT_NEAR(length(end_of(link, -1.0) - cord.def.positions[k]), 0.0, 2e-6) << s.name;
        EXPECT_NEAR(length(end_of(link, 1.0) - cord.def.positions[k + 1]), 0.0, 2e-6) << s.name;
        EXPECT_NEAR(link.inertia, link.mass * link.half_length * link.half_length, 1e-6 * link.inertia) << s.name;
        mass += link.mass;
      }
      EXPECT_NEAR(mass, cord.def.mass_per_length * cord.def.length, 1e-5 * mass) << s.name;
    }
  }
}

TEST(PeersPlan, EveryLinkHasHingesToItsNeighboursPinsAndHolders) {
  for (const Scene& s : scenes()) {
    const Plan plan = plan_for(s);
    std::size_t hinges = 0;
    for (const CordPlan& cord : plan.cords) {
      if (cord.def.rows == 1) hinges += cord.links.size() - 1 + cord.def.pins.size() + cord.held.size();
    }
    EXPECT_EQ(plan.hinges.size(), hinges) << s.name;
    for (const HingePlan& hinge : plan.hinges) {
      const BodyPlan& link = plan.bodies[static_cast<std::size_t>(hinge.b)];
      const double from_ends =
          std::min(length(end_of(link, -1.0) - hinge.place), length(end_of(link, 1.0) - hinge.place));
      EXPECT_NEAR(from_ends, 0.0, 2e-6) << s.name;
    }
  }
}

TEST(PeersPlan, ListsTheBodiesThatHoldACord) {
  const Plan plan = plan_of([](CoupledWorld& world) { test_support::hang_load(world, 168.0, inextensible); }, 0, 1);
  ASSERT_EQ(plan.cords.size(), 1U);
  ASSERT_EQ(plan.cords[0].held.size(), 1U);
  EXPECT_EQ(plan.cords[0].held[0].first, 30);
  EXPECT_EQ(plan.cords[0].held[0].second, plan.moving_bodies().back());
  EXPECT_NEAR(plan.bodies[static_cast<std::size_t>(plan.moving_bodies().back())].mass, 168.0, 1e-9);
  EXPECT_EQ(plan.cords[0].def.pins, std::vector<int>{0});
}

TEST(PeersPlan, RefusesPolygons) {
  const auto set_up = [](CoupledWorld& world) {
    b2PolygonShape box;
    box.SetAsBox(1.0F, 1.0F);
    world.add_load(b2_staticBody, {}, 0.0, 0.0).CreateFixture(&box, 0.0F);
  };
  EXPECT_THROW(plan_of(set_up, 0, 1), std::invalid_argument);
}

TEST(PeersPlan, JsonHasAllFieldsThatARunnerReads) {
  const nlohmann::json json = nlohmann::json::parse(to_json(plan_for(scene("bridge"))));
  EXPECT_EQ(json["settlingTicks"], 600);
  EXPECT_EQ(json["cords"].size(), 1U);
  EXPECT_EQ(json["cords"][0]["links"].size(), 40U);
  EXPECT_EQ(json["cords"][0]["positions"].size(), 41U);
  EXPECT_EQ(json["hinges"].size(), 41U);
  EXPECT_EQ(json["movingBodies"].size(), 1U);
  const nlohmann::json& ball = json["bodies"][json["movingBodies"][0].get<std::size_t>()];
  EXPECT_EQ(ball["radius"], 0.25);
  EXPECT_EQ(ball["dynamic"], true);
}

TEST(PeersFigures, ACordAtItsStartHasNoStretchAndNoPenetration) {
  const Scene& drape = scene("drape");
  const Plan plan = plan_for(drape);
  const Figures figures = figures_of(drape.set_up, plan, {at_start(plan)});
  EXPECT_EQ(figures.blew_up, 0);
  EXPECT_NEAR(figures.stretch, 0.0, 1e-12);
  EXPECT_EQ(figures.penetration, 0.0);
}

TEST(PeersFigures, ALinkThatIsPulledOutCountsAsStretch) {
  const Scene& drape = scene("drape");
  const Plan plan = plan_for(drape);
  Frame frame = at_start(plan);
  frame.cords[0].back().x += 0.5;
  const Figures figures = figures_of(drape.set_up, plan, {at_start(plan), frame, at_start(plan)});
  EXPECT_NEAR(figures.stretch_m, 0.5, 1e-9);
  EXPECT_NEAR(figures.stretch, 0.1, 1e-9);
}

TEST(PeersFigures, ABallThatSinksInAndReturnsHasPenetrationDriftAndJitter) {
  const Scene& bridge = scene("bridge");
  const Plan plan = plan_for(bridge);
  const Frame start = at_start(plan);
  Frame lower = start;
  lower.moving_bodies[0].y -= 0.03;
  const Figures above = figures_of(bridge.set_up, plan, {start});
  const Figures pressed = figures_of(bridge.set_up, plan, {start, lower, start});
  EXPECT_GT(pressed.penetration, above.penetration + 0.01);
  EXPECT_NEAR(pressed.drift, 0.03, 1e-9);
  EXPECT_NEAR(pressed.jitter, 0.03, 1e-9);
  EXPECT_FALSE(pressed.tunnelled);
}

TEST(PeersFigures, ABallBelowItsCordHasTunnelled) {
  const Scene& bridge = scene("bridge");
  const Plan plan = plan_for(bridge);
  Frame below = at_start(plan);
  below.moving_bodies[0].y -= 10.0;
  EXPECT_TRUE(figures_of(bridge.set_up, plan, {below}).tunnelled);
}

TEST(PeersFigures, ANaNOrADistantPointCountsAsBlownUp) {
  const Scene& bridge = scene("bridge");
  const Plan plan = plan_for(bridge);
  for (const double value : {std::nan(""), 1e5}) {
    Frame wild = at_start(plan);
    wild.cords[0][7].x = value;
    EXPECT_EQ(figures_of(bridge.set_up, plan, {at_start(plan), wild}).blew_up, 2);
  }
}

TEST(PeersFigures, CountsCrossingsOfOverlappingRibbons) {
  const Scene& strips = scene("strips");
  const Plan plan = plan_for(strips);
  Frame frame = at_start(plan);
  EXPECT_EQ(figures_of(strips.set_up, plan, {frame}).crossings, 0);
  for (Vec2& p : frame.cords[1])
    p = frame.cords[0][33] + Vec2{p.y - frame.cords[1][0].y, frame.cords[1][0].x - p.x} + Vec2{0.0, 0.8};
  EXPECT_GE(figures_of(strips.set_up, plan, {frame}).crossings, 4);
}

TEST(PeersFigures, ARecordingThatEndsEarlyHasAnInfinitePathError) {
  EXPECT_TRUE(std::isinf(path_error({}, {{0.0, 0.0}})));
}

class PeersRecording : public testing::Test {
 protected:
  void write(const std::vector<double>& numbers) const {
    std::ofstream out(path, std::ios::binary);
    out.write(reinterpret_cast<const char*>(numbers.data()),
              static_cast<std::streamsize>(numbers.size() * sizeof(double)));
  }
  ~PeersRecording() override { std::remove(path.c_str()); }

  const Plan plan = plan_for(scene("bridge"));
  const std::string path = testing::TempDir() + "peers_recording";
};

TEST_F(PeersRecording, IsReadAsItWasWritten) {
  std::vector<double> numbers(2 * (1 + 2 * 42));
  std::iota(numbers.begin(), numbers.end(), 0.0);
  write(numbers);
  const Recording recording = read_recording(path, plan);
  ASSERT_EQ(recording.size(), 2U);
  EXPECT_EQ(recording[0].us, 0.0);
  EXPECT_EQ(recording[0].cords[0][0], (Vec2{1.0, 2.0}));
  EXPECT_EQ(recording[0].moving_bodies[0], (Vec2{83.0, 84.0}));
  EXPECT_EQ(recording[1].us, 85.0);
}

TEST_F(PeersRecording, OfAnotherPlanIsRefused) {
  write(std::vector<double>(7, 1.0));
  EXPECT_TRUE(test_support::says(test_support::refusal<std::runtime_error>([&] { read_recording(path, plan); }),
                                 "has 56 bytes; accepted are frames of 680"));
  std::remove(path.c_str());
  EXPECT_THROW(read_recording(path, plan), std::runtime_error);
}

TEST(PeersRunners, OurCordFollowsTheExactPathOfAHeavyLoad) {
  const Scene& swing = scene("heavy_swing");
  const Plan plan = plan_for(swing);
  const Recording recording = run_coupled(swing.set_up, plan, test_support::CordMethod{});
  ASSERT_EQ(recording.size(), 300U);
  EXPECT_LT(swing.error(figures_of(swing.set_up, plan, recording), recording), 0.05);
}

TEST(PeersRunners, AChainIsRecordedByTheEndsOfItsLinks) {
  const Scene& swing = scene("heavy_swing");
  const Plan plan = plan_for(swing);
  test_support::CordMethod how;
  how.chain = true;
  how.substeps = 64;
  const Recording recording = run_coupled(swing.set_up, plan, how);
  ASSERT_EQ(recording.front().cords[0].size(), 51U);
  ASSERT_EQ(recording.front().moving_bodies.size(), 1U);
  EXPECT_LT(swing.error(figures_of(swing.set_up, plan, recording), recording), 1.0);
}

Result result(const std::string& engine, const std::string& setting, double cost_us, double error_m) {
  Result made;
  made.engine = engine;
  made.setting = setting;
  made.cost_us = cost_us;
  made.error_m = error_m;
  return made;
}

TEST(PeersTable, ACellHasTheCheapestAndTheMostAccurateOfAFront) {
  Result failed = result("Other", "substeps=1", 1.0, 0.0);
  failed.failure = "blew up in tick 3";
  Result also_failed = failed;
  also_failed.engine = "Third";
  const Results results = {{"drape",
                            {result(our_name, compared_setting, 10.0, 2.5e-5), failed, also_failed,
                             result("Other", "substeps=4", 23.0, 0.031), result("Other", "substeps=8", 24.0, 0.04),
                             result("Other", "substeps=16", 2345.0, 0.0)}}};
  const std::string table = table_of(
      {{our_name, "1.0", "native"}, {"Other", "2", "WebAssembly"}, {"Third", "3", "native"}}, {"drape"}, results);
  EXPECT_NE(table.find("| Other | 2 | WebAssembly |"), std::string::npos) << table;
  EXPECT_NE(table.find("| ours | 0.025 mm ×1 |"), std::string::npos) << table;
  EXPECT_NE(table.find("| Other | 3.1 cm ×2.3 … 0 ×230 |"), std::string::npos) << table;
  EXPECT_NE(table.find("| Third | fails |"), std::string::npos) << table;
}

TEST(PeersTable, TheCsvHasALinePerSettingWithTheReasonOfItsFailure) {
  Result failed = result("Other", "substeps=1", 1.0, 0.0);
  failed.failure = "tunnelled: the ball is below the cord";
  failed.group = "ratio=100";
  const std::string csv = csv_of({"bridge"}, {{"bridge", {failed}}});
  EXPECT_EQ(
      csv.substr(0, csv.find('\n')),
      "scene,group,engine,setting,us_per_tick,p99_us,error_m,stretch_pct,penetration_m,drift_m,jitter_m,crossings,"
      "failure");
  EXPECT_NE(csv.find("bridge,ratio=100,Other,substeps=1,1,"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",0,tunnelled: the ball is below the cord\n"), std::string::npos) << csv;
}

}  // namespace
}  // namespace peers
