#include "ribbon/thesis/thesis_def.h"

#include <gtest/gtest.h>

#include <functional>

#include "ribbon/thesis/thesis_cord.h"
#include "tests/support/constants.h"
#include "tests/support/refusal.h"

namespace ribbon {
namespace {

using constants::infinity;
using constants::nan;

struct BadField {
  const char* field;
  std::function<void(ThesisDef&)> spoil;
  const char* value;
};

/// The message names the field, the value and what is accepted.
TEST(ThesisDef, RefusesEachBadFieldByNameAndValue) {
  const BadField fields[] = {
      {"w", [](ThesisDef& d) { d.w = 1; }, "1"},
      {"w", [](ThesisDef& d) { d.w = -3; }, "-3"},
      {"w", [](ThesisDef& d) { d.w = 2'000'000; }, "2e+06"},
      {"h", [](ThesisDef& d) { d.h = 1; }, "1"},
      {"h", [](ThesisDef& d) { d.h = 0; }, "0"},
      {"h", [](ThesisDef& d) { d.h = 65; }, "65"},
      {"spacing", [](ThesisDef& d) { d.spacing = 0.0; }, "0"},
      {"spacing", [](ThesisDef& d) { d.spacing = -1.0; }, "-1"},
      {"spacing", [](ThesisDef& d) { d.spacing = nan; }, "nan"},
      {"point_mass", [](ThesisDef& d) { d.point_mass = 0.0; }, "0"},
      {"point_mass", [](ThesisDef& d) { d.point_mass = -2.0; }, "-2"},
      {"point_mass", [](ThesisDef& d) { d.point_mass = infinity; }, "inf"},
      {"spring_stiffness", [](ThesisDef& d) { d.spring_stiffness = -1.0; }, "-1"},
      {"spring_stiffness", [](ThesisDef& d) { d.spring_stiffness = 1e16; }, "1e+16"},
      {"bar_damping", [](ThesisDef& d) { d.bar_damping = nan; }, "nan"},
      {"drag", [](ThesisDef& d) { d.drag = -0.5; }, "-0.5"},
      {"area_stiffness", [](ThesisDef& d) { d.area_stiffness = 1.5; }, "1.5"},
      {"area_floor", [](ThesisDef& d) { d.area_floor = 1.0; }, "1"},
      {"radius", [](ThesisDef& d) { d.radius = 0.6 * d.spacing; }, "0.03"},
      {"radius", [](ThesisDef& d) { d.radius = -1.0; }, "-1"},
      {"substeps", [](ThesisDef& d) { d.substeps = 0; }, "0"},
      {"positions", [](ThesisDef& d) { d.positions.resize(3); }, "3 entries"},
      {"positions[7]",
       [](ThesisDef& d) {
         d.positions.resize(50);
         d.positions[7].y = nan;
       },
       "nan"},
      {"pins[1]",
       [](ThesisDef& d) {
         d.pins = {0, 50};
       },
       "50"},
      {"pins[0]", [](ThesisDef& d) { d.pins = {-1}; }, "-1"},
  };
  for (const BadField& bad : fields) {
    ThesisDef def;
    bad.spoil(def);
    const std::string message = test_support::refusal<DefinitionError>([&] { const ThesisCord cord(def); });
    EXPECT_TRUE(test_support::starts_with(message, bad.field));
    EXPECT_TRUE(test_support::says(message, bad.value));
    EXPECT_TRUE(test_support::says(message, "accepted"));
  }
}

TEST(ThesisDef, AcceptsItsLimits) {
  ThesisDef def;
  def.w = 2;
  def.h = 2;
  def.spacing = 1e-6;
  def.point_mass = 1e9;
  def.radius = 0.5 * def.spacing;
  def.pins = {0, 3};
  EXPECT_NO_THROW(ThesisCord{def});
}

TEST(ThesisCord, RefusesUnknownPointsAndChangesNothing) {
  ThesisCord cord{ThesisDef{}};
  const ThesisCord::State before = cord.save();
  EXPECT_THROW(cord.operate(50, {0.0, 0.0}), DefinitionError);
  EXPECT_THROW(cord.constrain(-1, {0.0, 0.0}), DefinitionError);
  EXPECT_THROW(cord.release(1000), DefinitionError);
  EXPECT_THROW(cord.operate(3, {nan, 0.0}), DefinitionError);
  EXPECT_THROW(cord.operate(3, {1e200, 0.0}), DefinitionError);
  EXPECT_THROW(cord.set_velocity(3, {0.0, infinity}), DefinitionError);
  EXPECT_THROW(cord.set_velocity(3, {0.0, -2e9}), DefinitionError);
  ThesisCord::State spoilt = before;
  spoilt.velocities[4].x = nan;
  EXPECT_THROW(cord.restore(spoilt), DefinitionError);
  ThesisCord::State other = before;
  other.positions.pop_back();
  EXPECT_THROW(cord.restore(other), DefinitionError);
  EXPECT_EQ(cord.save(), before);
}

}  // namespace
}  // namespace ribbon
