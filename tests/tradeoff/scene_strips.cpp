#include "tests/support/contact_scenes.h"
#include "tests/tradeoff/contact_run.h"
#include "tests/tradeoff/scenes_contact.h"

namespace tradeoff {
namespace {

using test_support::CoupledWorld;

constexpr int ticks = 300;
constexpr double bar = 16000.0;  // µs

std::vector<Contestant> contestants() {
  std::vector<Contestant> list;
  for (const bool meeting : {true, false}) {
    list.push_back(contestant({presets({"fast"}).front(),
                               meeting ? "meeting each other" : "meeting circles alone",
                               [meeting](CoupledWorld& world) { test_support::drop_strips(world, 150, meeting); },
                               false,
                               {0.0, -9.81},
                               [](CoupledWorld& world) { return figures_of(world, run(world, ticks), bar); }}));
  }
  return list;
}

}  // namespace

Scene strips_scene() {
  return {"strips", "150 ribbons of 33 x 2 points that fall through a lattice of circles", ticks, contestants,
          contact_columns()};
}

}  // namespace tradeoff
