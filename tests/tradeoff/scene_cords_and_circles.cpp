#include "tests/support/contact_scenes.h"
#include "tests/tradeoff/contact_run.h"
#include "tests/tradeoff/scenes_contact.h"

namespace tradeoff {
namespace {

using test_support::CoupledWorld;

constexpr int circle_ticks = 300;
constexpr double target_us = 8000.0;  // µs

std::vector<Variant> cords_and_circles_variants() {
  std::vector<Variant> list;
  for (const NamedMethod& method : together(presets({"fast", "balanced"}), chains({1, 4}))) {
    list.push_back(
        variant({method,
                 "",
                 [](CoupledWorld& world) { test_support::hang_hall(world); },
                 false,
                 {0.0, -9.81},
                 [](CoupledWorld& world) { return figures_of(world, run(world, circle_ticks), target_us); }}));
  }
  return list;
}

}  // namespace

Scene cords_and_circles_scene() {
  return {"cords_and_circles", "100 cords of 50 points, and 200 balls that fall and roll among them", circle_ticks,
          cords_and_circles_variants, contact_columns()};
}

}  // namespace tradeoff
