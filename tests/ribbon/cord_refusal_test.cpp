#include "ribbon/cord.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>

#include "tests/support/constants.h"
#include "tests/support/refusal.h"

// Definitions, steps and arguments that a cord refuses.

namespace ribbon {
namespace {

using constants::infinity;
using constants::nan;
using test_support::refusal;
using test_support::starts_with;

void make_ribbon(CordDef& def, int rows) {
  def.rows = rows;
  def.width = 0.5;
  solid(1e6, 0.0, 0.01, def.width).apply_to(def);
}

TEST(CordDef, RibbonsOfSolidMaterialAreAccepted) {
  for (const int rows : {2, 3, 64}) {
    CordDef def;
    make_ribbon(def, rows);
    EXPECT_NO_THROW(check(def));
    def.elements = Elements::bars;
    def.bending_stiffness = 0.0;
    EXPECT_NO_THROW(check(def));
  }
  // The same strip, once given by Young's modulus, once by its stiffnesses for shear and area.
  const RibbonMaterial by_modulus = solid(2e5, 0.25, 0.1, 0.5);
  const double modulus = 2e5 * 0.1;
  const RibbonMaterial by_shear = solid_of_shear_and_area(modulus / 2.5, modulus / 1.5, 0.5);
  EXPECT_NEAR(by_shear.stretch_stiffness, by_modulus.stretch_stiffness, 1e-9 * by_modulus.stretch_stiffness);
  EXPECT_NEAR(by_shear.bending_stiffness, by_modulus.bending_stiffness, 1e-9 * by_modulus.bending_stiffness);
  EXPECT_NEAR(by_shear.poisson_ratio, 0.25, 1e-12);
  EXPECT_THROW(solid(-1.0, 0.0, 0.1, 0.5), DefinitionError);
  EXPECT_THROW(solid(1e5, 1.0, 0.1, 0.5), DefinitionError);
  EXPECT_THROW(solid(1e5, 0.0, 0.0, 0.5), DefinitionError);
  EXPECT_THROW(solid(1e5, 0.0, 0.1, nan), DefinitionError);
  EXPECT_THROW(solid_of_shear_and_area(0.0, 1.0, 0.5), DefinitionError);
}

TEST(CordDef, RefusesEachBadFieldByNameAndValue) {
  struct Bad {
    const char* field;
    std::function<void(CordDef&)> spoil;
  };
  const Bad fields[] = {
      {"points", [](CordDef& d) { d.points = 1; }},
      {"length", [](CordDef& d) { d.length = 0.0; }},
      {"length", [](CordDef& d) { d.length = nan; }},
      {"mass_per_length", [](CordDef& d) { d.mass_per_length = -1.0; }},
      {"stretch_stiffness", [](CordDef& d) { d.stretch_stiffness = 0.0; }},
      {"stretch_stiffness", [](CordDef& d) { d.stretch_stiffness = -infinity; }},
      {"accuracy.substeps", [](CordDef& d) { d.accuracy.substeps = 0; }},
      {"accuracy.tolerance", [](CordDef& d) { d.accuracy.tolerance = 0.0; }},
      {"accuracy.max_iterations", [](CordDef& d) { d.accuracy.max_iterations = 0; }},
      {"accuracy.max_work", [](CordDef& d) { d.accuracy.max_work = 0; }},
      {"accuracy.max_work", [](CordDef& d) { d.accuracy.max_work = 1'000'001; }},
      {"points", [](CordDef& d) { d.points = 1000001; }},
      {"points",
       [](CordDef& d) {
         d.rows = 2;
         d.points = 500001;
       }},
      {"rows", [](CordDef& d) { d.rows = 0; }},
      {"rows", [](CordDef& d) { d.rows = 65; }},
      {"radius", [](CordDef& d) { d.radius = -0.1; }},
      {"bending_stiffness", [](CordDef& d) { d.bending_stiffness = -1.0; }},
      {"bending_stiffness", [](CordDef& d) { d.bending_stiffness = infinity; }},
      {"damping", [](CordDef& d) { d.damping = nan; }},
      {"drag", [](CordDef& d) { d.drag = -1.0; }},
      {"drag_across", [](CordDef& d) { d.drag_across = -1.0; }},
      {"drag_along", [](CordDef& d) { d.drag_along = 1001.0; }},
      {"displaced_area", [](CordDef& d) { d.displaced_area = nan; }},
      // of a rope
      {"width", [](CordDef& d) { d.width = 0.1; }},
      {"poisson_ratio", [](CordDef& d) { d.poisson_ratio = 0.3; }},
      {"area_stiffness", [](CordDef& d) { d.area_stiffness = 1.0; }},
      {"elements", [](CordDef& d) { d.elements = Elements::bars; }},
      {"bending_stiffness",
       [](CordDef& d) {
         d.points = 2;
         d.bending_stiffness = 1.0;
       }},
      // of a ribbon
      {"width",
       [](CordDef& d) {
         make_ribbon(d, 2);
         d.width = 0.0;
       }},
      {"stretch_stiffness",
       [](CordDef& d) {
         make_ribbon(d, 2);
         d.stretch_stiffness = infinity;
       }},
      {"poisson_ratio",
       [](CordDef& d) {
         make_ribbon(d, 2);
         d.poisson_ratio = 1.0;
       }},
      {"area_stiffness",
       [](CordDef& d) {
         make_ribbon(d, 2);
         d.area_stiffness = -1.0;
       }},
      {"tension_only",
       [](CordDef& d) {
         make_ribbon(d, 2);
         d.tension_only = true;
       }},
      {"bending_stiffness",
       [](CordDef& d) {
         make_ribbon(d, 3);
         d.bending_stiffness = 0.0;
       }},
      {"bending_stiffness",
       [](CordDef& d) {
         make_ribbon(d, 3);
         d.bending_stiffness *= 1.01;
       }},
      {"bending_stiffness",
       [](CordDef& d) {
         make_ribbon(d, 2);
         d.elements = Elements::bars;
       }},
      {"positions", [](CordDef& d) { d.positions.resize(50); }},
      {"positions[3]",
       [](CordDef& d) {
         d.positions.resize(51);
         d.positions[3].x = nan;
       }},
      {"pins[0]", [](CordDef& d) { d.pins = {51}; }},
  };
  for (const Bad& bad : fields) {
    CordDef def;
    bad.spoil(def);
    EXPECT_TRUE(starts_with(refusal<DefinitionError>([&] { const Cord cord(def); }), bad.field));
  }
}

TEST(Cord, RefusesInvalidStepsAndChangesNothing) {
  Cord cord{CordDef{}};
  const Cord::State before = cord.save();
  const auto refuses = [&](double dt, Vec2 pull, const Surroundings& surroundings, const std::string& field) {
    EXPECT_TRUE(starts_with(refusal<DefinitionError>([&] { cord.step(dt, pull, surroundings); }), field + " is "));
  };
  refuses(nan, {}, {}, "dt");
  refuses(0.0, {}, {}, "dt");
  refuses(1e-10, {}, {}, "dt");
  refuses(2.0, {}, {}, "dt");
  refuses(0.01, {0.0, nan}, {}, "gravity");
  std::array bodies{RigidBody{}, RigidBody{}};
  const std::array circles{RigidCircle{1, {}, 0.1}, RigidCircle{2, {}, 0.1}};
  refuses(0.01, {}, {bodies, circles, {}, {}}, "circles[1].body");
  const std::array thin{RigidCircle{0, {}, -0.1}};
  refuses(0.01, {}, {bodies, thin, {}, {}}, "circles[0].radius");
  const std::array segments{RigidSegment{0, {}, {nan, 0.0}}};
  refuses(0.01, {}, {bodies, {}, {}, segments}, "segments[0].b");
  std::array belt{RigidSegment{0, {}, {1.0, 0.0}}};
  belt[0].tangent_speed = 1e11;
  refuses(0.01, {}, {bodies, {}, {}, belt}, "segments[0].tangent_speed");
  std::array wheel{RigidCircle{0, {}, 0.1}};
  wheel[0].tangent_speed = nan;
  refuses(0.01, {}, {bodies, wheel, {}, {}}, "circles[0].tangent_speed");
  const std::array grips{Grip{51, 0, {}}};
  refuses(0.01, {}, {bodies, {}, grips, {}}, "grips[0].point");
  const auto refuses_grip = [&](auto&& set, const std::string& field) {
    std::array held{Grip{0, 0, {}}};
    set(held[0]);
    refuses(0.01, {}, {bodies, {}, held, {}}, "grips[0]." + field);
  };
  refuses_grip([](Grip& grip) { grip.offset = {nan, 0.0}; }, "offset");
  refuses_grip([](Grip& grip) { grip.travel = {0.0, nan}; }, "travel");
  refuses_grip([](Grip& grip) { grip.along = -0.1; }, "along");
  refuses_grip([](Grip& grip) { grip.climb = infinity; }, "climb");
  refuses_grip([](Grip& grip) { grip.strength = -1.0; }, "strength");
  refuses_grip([](Grip& grip) { grip.across = {0.0, 2.0}; }, "across");
  refuses_grip([](Grip& grip) { grip.beside = {infinity, 0.0}; }, "beside");
  const auto refuses_support = [&](const Support& support, const std::string& field) {
    Surroundings supported{bodies};
    const std::array supports{support};
    supported.supports = supports;
    refuses(0.01, {}, supported, "supports[0]." + field);
  };
  refuses_support({2, {}, {0.0, 1.0}}, "body");
  refuses_support({0, {nan, 0.0}, {0.0, 1.0}}, "arm");
  refuses_support({0, {}, {0.0, 2.0}}, "normal");
  refuses_support({0, {}, {0.0, 0.5}}, "the length of normal");
  refuses_support({0, {}, {0.0, 1.0}, -1e-6}, "gap");
  refuses_support({0, {}, {0.0, 1.0}, 0.0, nan}, "speed");
  refuses_support({0, {}, {0.0, 1.0}, 0.0, 0.0, 2}, "other");
  refuses_support({0, {}, {0.0, 1.0}, 0.0, 0.0, -2}, "other");
  refuses_support({0, {}, {0.0, 1.0}, 0.0, 0.0, 0}, "other");
  refuses_support({0, {}, {0.0, 1.0}, 0.0, 0.0, 1, {nan, 0.0}}, "other_arm");
  bodies[1].pushed = {0.0, nan};
  refuses(0.01, {}, {bodies, {}, {}, {}}, "bodies[1].pushed");
  bodies[1].pushed = {};
  bodies[1].pushed_turn = infinity;
  refuses(0.01, {}, {bodies, {}, {}, {}}, "bodies[1].pushed_turn");
  bodies[1].pushed_turn = 0.0;
  bodies[1].inverse_mass = -1.0;
  refuses(0.01, {}, {bodies, {}, {}, {}}, "bodies[1].inverse_mass");
  EXPECT_EQ(cord.save(), before);
}

TEST(Cord, RefusesUnknownPointsAndBadNumbersAndChangesNothing) {
  Cord cord{CordDef{}};
  const Cord::State before = cord.save();
  EXPECT_THROW(cord.attach_mass(51, 1.0), DefinitionError);
  EXPECT_THROW(cord.attach_mass(3, -1.0), DefinitionError);
  EXPECT_THROW(cord.constrain(-1, {}), DefinitionError);
  EXPECT_THROW(cord.constrain(3, {nan, 0.0}), DefinitionError);
  EXPECT_THROW(cord.release(51), DefinitionError);
  EXPECT_THROW(cord.set_velocity(3, {0.0, 1e10}), DefinitionError);
  Cord::State other = before;
  other.tensions.pop_back();
  EXPECT_THROW(cord.restore(other), DefinitionError);
  EXPECT_EQ(cord.save(), before);
}

}  // namespace
}  // namespace ribbon
