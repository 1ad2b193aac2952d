#include "engine/replay/solver_step.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <limits>
#include <string>

#include "tests/support/constants.h"
#include "tests/support/refusal.h"

namespace engine {
namespace {

using constants::infinity;

/// A rope on a circle and a segment, held by a body.
SolverStep some_step() {
  SolverStep step;
  step.dt = 1.0 / 60.0;
  step.gravity = {0.0, -9.81};
  step.bodies.resize(2);
  step.bodies[1].inverse_mass = 1.0 / 3.0;
  SolverStep::Cord cord;
  cord.def.points = 5;
  cord.def.pins = {0};
  cord.state = ribbon::Cord(cord.def).save();
  cord.state.velocities[1] = {-0.0, 1e-310};
  cord.state.velocities[2] = {0.1 + 0.2, 123456789012345680.0};
  cord.circles.push_back({0, {0.1, -0.2}, 0.3, 0.4, 0.5, 6});
  cord.segments.push_back({0, {0.1, -0.2}, {0.3, 0.4}, 0.0, 0.4, 0.5, 7, -1.5});
  cord.grips.push_back({4, 1, {0.0, 0.1}});
  cord.supports.push_back({1, {0.1, -0.2}, {0.0, 1.0}, 0.003, -0.5, 0, {0.3, 0.4}});
  cord.id = (std::uint64_t{1} << 63U) + 1;
  step.cords.push_back(cord);
  step.outcome = {"a \"reason\"\n", std::int64_t{1} << 60, 2, 0xffff'ffff'ffff'ffffU};
  return step;
}

/// Returns the text of some_step with one piece replaced.
std::string text_with(const std::string& from, const std::string& to) {
  std::string text = to_text(some_step());
  const std::size_t found = text.find(from);
  EXPECT_NE(found, std::string::npos) << from;
  return found == std::string::npos ? text : text.replace(found, from.size(), to);
}

std::string refusal(const std::string& text) {
  return test_support::refusal<SolverStepError>([&] { (void)read_solver_step(text, "bad.json"); });
}

TEST(SolverStep, IsReadBackToTheBit) {
  const SolverStep step = some_step();
  const std::string text = to_text(step);
  const SolverStep read = read_solver_step(text, "a text");
  EXPECT_EQ(to_text(read), text);
  EXPECT_TRUE(read.cords[0].state == step.cords[0].state);
  EXPECT_TRUE(read.cords[0].def == step.cords[0].def);
  EXPECT_TRUE(std::signbit(read.cords[0].state.velocities[1].x));
  EXPECT_EQ(read.cords[0].grips[0].strength, infinity);
  EXPECT_TRUE(read.cords[0].supports[0] == step.cords[0].supports[0]);
  EXPECT_EQ(read.cords[0].id, step.cords[0].id);
  EXPECT_EQ(read.outcome.why, step.outcome.why);
  EXPECT_EQ(read.outcome.work, step.outcome.work);
  EXPECT_EQ(read.outcome.positions, step.outcome.positions);
}

TEST(SolverStep, RefusesInvalidTextWithAMessage) {
  EXPECT_EQ(refusal("").find("bad.json: not valid JSON: "), 0U);
  EXPECT_EQ(refusal("{\"solver_step\": 2,").find("bad.json: not valid JSON: "), 0U);
  EXPECT_EQ(refusal("[]"), "bad.json: the file is an array; accepted is an object");
  EXPECT_EQ(refusal("{}"), "bad.json: solver_step is missing; accepted is a file with all fields");
  EXPECT_EQ(refusal(text_with("\"solver_step\": 14", "\"solver_step\": 15")),
            "bad.json: solver_step is version 15; accepted is 14");
  EXPECT_EQ(refusal(std::string(100, '[')), "bad.json: nested more than the 8 levels deep accepted");
}

TEST(SolverStep, RefusesMissingAndUnknownFields) {
  EXPECT_EQ(refusal(text_with("\"radius\": 0.01,", "")),
            "bad.json: cords[0].def.radius is missing; accepted is a file with all fields");
  EXPECT_EQ(refusal(text_with("\"radius\": 0.3,", "\"radius\": 0.3, \"colour\": 1,")),
            "bad.json: cords[0].circles[0]: there is no field \"colour\"; accepted are body, offset, radius, friction, "
            "restitution, id, tangent_speed");
}

TEST(SolverStep, RefusesValuesOfOtherTypes) {
  EXPECT_EQ(refusal(text_with("\"points\": 5", "\"points\": 5.5")),
            "bad.json: cords[0].def.points is 5.5; accepted is a whole number from -2147483648 to 2147483647");
  EXPECT_EQ(refusal(text_with("\"points\": 5", "\"points\": 5000000000")).find("bad.json: cords[0].def.points is 5"),
            0U);
  EXPECT_EQ(refusal(text_with("\"gravity\": [0.0, -9.81]", "\"gravity\": [0.0]")),
            "bad.json: gravity is an array; accepted is an array of two numbers");
  EXPECT_EQ(refusal(text_with("\"gravity\": [0.0, -9.81]", "\"gravity\": [0.0, \"down\"]")),
            "bad.json: gravity.y is \"down\"; accepted is a number, or \"infinity\" or \"-infinity\"");
  EXPECT_EQ(refusal(text_with("\"gravity\": [0.0, -9.81]", "\"gravity\": [0.0, null]")),
            "bad.json: gravity.y is null; accepted is a number");
  EXPECT_EQ(refusal(text_with("\"tr_bdf2\"", "\"rk4\"")),
            "bad.json: cords[0].def.accuracy.integrator is \"rk4\"; accepted is tr_bdf2, implicit_euler");
  EXPECT_EQ(refusal(text_with("\"tension_only\": false", "\"tension_only\": 0")),
            "bad.json: cords[0].def.tension_only is 0; accepted is true or false");
  EXPECT_EQ(refusal(text_with("\"circles\": [", "\"circles\": [7, ")),
            "bad.json: cords[0].circles[0] is 7; accepted is an object");
}

TEST(SolverStep, RefusesNumbersOutOfRangeAndStatesThatDoNotFit) {
  EXPECT_EQ(refusal(text_with("\"gravity\": [0.0, -9.81]", "\"gravity\": [0.0, \"infinity\"]"))
                .find("bad.json: gravity is (0, inf); accepted are coordinates"),
            0U);
  EXPECT_EQ(refusal(text_with("\"points\": 5", "\"points\": 1")).find("bad.json: cords[0]: points is 1; accepted"), 0U);
  EXPECT_EQ(refusal(text_with("\"points\": 5", "\"points\": 6")),
            "bad.json: cords[0]: state.positions has 5 entries; accepted is one a point: 6");
  EXPECT_EQ(refusal(text_with("\"points\": 5", "\"points\": 1000000")),
            "bad.json: cords[0]: state.positions has 5 entries; accepted is one a point: 1000000");
  SolverStep slack = some_step();
  slack.cords[0].state.rest.pop_back();
  EXPECT_EQ(refusal(to_text(slack)),
            "bad.json: cords[0]: state is of another cord; accepted is one of 5 x 1 points with the same terms");
  EXPECT_EQ(refusal(text_with("\"body\": 0,", "\"body\": 2,")),
            "bad.json: cords[0]: circles[0].body is 2; accepted is an index below 2");
  EXPECT_EQ(refusal(text_with("\"inverse_mass\": 0.3", "\"inverse_mass\": -0.3")).find("bad.json: bodies[1].inverse_"),
            0U);
  SolverStep twins = some_step();
  twins.cords.push_back(twins.cords[0]);
  EXPECT_EQ(refusal(to_text(twins)),
            "bad.json: two cords have the id 9223372036854775809; accepted is another one for each");
  SolverStep lost = some_step();
  lost.cords[0].state.positions[2].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(to_text(lost)).find("bad.json: cords[0].state.positions[2].x is \"nan\"; accepted is a number"),
            0U);
}

/// A text that is cut at any byte is refused.
TEST(SolverStep, RefusesEveryTruncatedText) {
  const std::string text = to_text(some_step());
  for (std::size_t end = 0; end + 2 < text.size(); end += 7) {
    ASSERT_EQ(refusal(text.substr(0, end)).find("bad.json: not valid JSON"), 0U) << end;
  }
}

TEST(SolverStep, IsSavedToAFileAndLoaded) {
  const std::string path = testing::TempDir() + "solver_step_test.json";
  std::remove(path.c_str());
  EXPECT_TRUE(save_solver_step(some_step(), path, true));
  EXPECT_FALSE(save_solver_step(some_step(), path, true)) << "it is there";
  EXPECT_TRUE(save_solver_step(some_step(), path));
  EXPECT_EQ(to_text(load_solver_step(path)), to_text(some_step()));
  std::ofstream(path, std::ios::app) << "x";
  EXPECT_THROW((void)load_solver_step(path), SolverStepError);
  std::remove(path.c_str());
  EXPECT_THROW((void)load_solver_step(path), SolverStepError);
  EXPECT_THROW((void)load_solver_step(testing::TempDir()), SolverStepError);
  EXPECT_THROW(save_solver_step(some_step(), testing::TempDir() + "nowhere/step.json"), SolverStepError);
}

}  // namespace
}  // namespace engine
