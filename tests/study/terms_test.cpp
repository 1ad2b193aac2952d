#include "tests/study/terms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/study/level_study_fixture.h"

namespace study {
namespace {

TEST_F(LevelStudy, AnUnneededTermIsReported) {
  const Terms terms = try_terms(LevelFile(level_path), replay_path, [](double) {});
  const auto result = [&](const std::string& term) {
    return *std::find_if(terms.results.begin(), terms.results.end(), [&](const auto& r) { return r.term == term; });
  };
  EXPECT_EQ(result("cord_contact").first_difference, 0U);  // its cords do not touch in a third of a second
  EXPECT_EQ(result("cord_contact").change.greatest_length(), 0.0);
  EXPECT_NE(verdict(result("cord_contact")).find("not needed"), std::string::npos);
  EXPECT_GT(result("bending_stiffness").first_difference, 0U);
  EXPECT_NE(verdict(result("bending_stiffness")).find("from tick"), std::string::npos);
  ASSERT_EQ(terms.missing.size(), 1U);  // links of the falling bridge push
  EXPECT_EQ(terms.missing[0].term, "tension_only");
  const TermResult self = result("self_contact");  // no cord declares it
  EXPECT_FALSE(self.declared);
  EXPECT_EQ(self.first_difference, 0U);
  EXPECT_GT(self.cost_share, 0.0);
  EXPECT_NE(verdict(self).find("not needed: with it"), std::string::npos);
  EXPECT_TRUE(result("tension_only").can_be_built);
  EXPECT_FALSE(result("area_stiffness").can_be_built);  // the level has no ribbons
  EXPECT_NE(verdict(result("area_stiffness")).find("not applicable"), std::string::npos);
}

TEST_F(LevelStudy, FindsCompressedLinksOfElasticRopes) {
  change_level(level_path, [](Json& cord) {
    cord["polyline"] = {{{"x", 0}, {"y", 0}}, {{"x", 1}, {"y", -160}}};  // upwards from its pin
    cord["properties"].push_back({{"name", "stretch_stiffness"}, {"type", "float"}, {"value", 1e4}});
  });
  record(replay_path, 10);
  const Terms terms = try_terms(LevelFile(level_path), replay_path, [](double) {});
  ASSERT_EQ(terms.missing.size(), 1U);
  EXPECT_EQ(terms.missing[0].term, "tension_only");
  EXPECT_LE(terms.missing[0].first_tick, 3U);
  EXPECT_GE(terms.missing[0].ticks, 5U);
  const auto tension_only = std::find_if(terms.results.begin(), terms.results.end(),
                                         [](const TermResult& r) { return r.term == "tension_only"; });
  ASSERT_NE(tension_only, terms.results.end());
  EXPECT_TRUE(tension_only->can_be_built);
  EXPECT_GT(tension_only->first_difference, 0U);
  EXPECT_NE(verdict(*tension_only).find("with it a position differs by 1 cm"), std::string::npos);

  const game::Level held = *LevelFile(level_path).switched_on("tension_only", true);
  game::Simulation simulation(held);
  for (int k = 0; k < 10; ++k) simulation.tick({});
  EXPECT_FALSE(pushes(simulation.scene().coupling().cord(0).direct(), 9.81));
}

/// The first cord is a rope; the others have two rows and are not.
TEST_F(LevelStudy, ATermIsSwitchedOnWhereItIsApplicable) {
  int cords = 0;
  change_level(level_path, [&cords](Json& cord) {
    if (cords++ == 0) return;
    cord["properties"].push_back({{"name", "rows"}, {"type", "int"}, {"value", 2}});
    cord["properties"].push_back({{"name", "stretch_stiffness"}, {"type", "float"}, {"value", 1e4}});
  });
  const auto tension_only = LevelFile(level_path).switched_on("tension_only", true)->make_scene();
  const auto area = LevelFile(level_path).switched_on("area_stiffness", 1.0)->make_scene();
  for (int c = 0; c < cords; ++c) {
    EXPECT_EQ(tension_only->coupling().cord(c).direct().def().tension_only, c == 0) << c;
    EXPECT_EQ(area->coupling().cord(c).direct().def().area_stiffness, c == 0 ? 0.0 : 1.0) << c;
  }
}

}  // namespace
}  // namespace study
