#include "tests/support/contact_scenes.h"
#include "tests/tradeoff/contact_run.h"
#include "tests/tradeoff/scenes_contact.h"

namespace tradeoff {
namespace {

using test_support::CoupledWorld;

constexpr double coil_friction = 0.3;
constexpr double pull = 20.0;  // N
constexpr int tightening_ticks = 24;

/// Numbers of ticks.
struct Length {
  int timed;
  int figures;
  int counted;  // for the baseline of work
};

void add(std::vector<Variant>& list, const NamedMethod& method, int rows, Length length) {
  const std::string name = rows > 1 ? "ribbon" : "rope";
  const auto figures = [length](CoupledWorld& world) { return figures_of(world, run(world, length.figures)); };
  list.push_back(variant({method,
                          name + " wound",
                          [rows](CoupledWorld& world) {
                            test_support::wind_coil(world, rows, coil_friction);
                            test_support::pull_coil(world, pull);
                          },
                          false,
                          {},
                          figures}));
  list.push_back(variant({method,
                          name + " pile",
                          [rows](CoupledWorld& world) { test_support::stand_in_bucket(world, rows, coil_friction); },
                          false,
                          {0.0, -9.81},
                          figures}));
}

/// Adds a coil so loose that hauling it tight takes longer than the timed ticks.
void add_tightened(std::vector<Variant>& list, const NamedMethod& method, int rows) {
  constexpr double looseness = 2.5;
  constexpr double speed = 3.0;  // m/s
  list.push_back(variant({method,
                          rows > 1 ? "ribbon" : "rope",
                          [rows](CoupledWorld& world) {
                            test_support::wind_coil(world, rows, coil_friction, looseness);
                            test_support::haul_coil(world, speed);
                          },
                          false,
                          {},
                          [](CoupledWorld& world) { return figures_of(world, run(world, tightening_ticks)); }}));
}

Scene coil(const std::string& name, const std::string& length_note, Length length) {
  const auto variants = [length] {
    std::vector<Variant> list;
    for (const NamedMethod& method : together(presets({"fast", "balanced"}), chains({1, 4, 16}, true)))
      add(list, method, 1, length);
    for (const NamedMethod& method : presets({"fast", "balanced"})) add(list, method, 2, length);
    return list;
  };
  return {
      name,
      "a rope or ribbon wound four turns around a circle and pulled, and one that falls into a pile",
      length.timed,
      variants,
      contact_columns(),
      {},
      {length_note,
       "The thesis's cord is not included: it has no friction, no forces on points and no contacts with edges, and its "
       "square cells are wider than the distance of the turns.",
       "Box2D has no ribbons.", no_b2_rope},
      {"balanced", "substeps=16"},
      5,
      length.counted};
}

}  // namespace

Scene coil_scene() {
  return coil("coil", "Five seconds of each, of which the first two, the most expensive, are timed.", {120, 300, 120});
}

Scene short_coil_scene() {
  return coil("coil_short", "The first second and a half of each; `tradeoff --scene coil` runs for five.",
              {90, 90, 20});
}

Scene tightened_coil_scene() {
  const auto variants = [] {
    std::vector<Variant> list;
    for (const NamedMethod& method : together(presets({"fast", "balanced"}), chains({1, 4, 16}, true)))
      add_tightened(list, method, 1);
    for (const NamedMethod& method : presets({"fast", "balanced"})) add_tightened(list, method, 2);
    return list;
  };
  return {"coil_tightened",
          "a rope or ribbon wound loosely, four turns around a circle, and hauled tight at 3 m/s",
          tightening_ticks,
          variants,
          contact_columns(),
          {},
          {"The ticks end before the rope is tight.", "Box2D has no ribbons.", no_b2_rope},
          {},
          5};
}

}  // namespace tradeoff
