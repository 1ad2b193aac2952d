#include "tests/support/contact_scenes.h"
#include "tests/tradeoff/contact_run.h"
#include "tests/tradeoff/scenes_contact.h"

namespace tradeoff {
namespace {

using test_support::CoupledWorld;

constexpr int ticks = 120;  // that are timed
constexpr int settling_ticks = 300;
constexpr double friction = 0.3;
constexpr double pull = 20.0;  // N

std::vector<double> figures(CoupledWorld& world) { return figures_of(world, run(world, settling_ticks)); }

void add(std::vector<Contestant>& list, const NamedMethod& method, int rows) {
  const std::string name = rows > 1 ? "ribbon" : "rope";
  list.push_back(contestant({method,
                             name + " wound",
                             [rows](CoupledWorld& world) {
                               test_support::wind_coil(world, rows, friction);
                               test_support::pull_coil(world, pull);
                             },
                             false,
                             {},
                             figures}));
  list.push_back(contestant({method,
                             name + " pile",
                             [rows](CoupledWorld& world) { test_support::stand_in_bucket(world, rows, friction); },
                             false,
                             {0.0, -9.81},
                             figures}));
}

/// Five seconds of each, of which the first two, the dearest, are timed.
std::vector<Contestant> contestants() {
  std::vector<Contestant> list;
  for (const NamedMethod& method : together(presets({"fast", "balanced"}), chains({1, 4, 16}, true)))
    add(list, method, 1);
  for (const NamedMethod& method : presets({"fast", "balanced"})) add(list, method, 2);
  return list;
}

}  // namespace

Scene coil_scene() {
  return {"coil", "a rope or ribbon wound four turns around a circle and pulled, and one that falls into a pile", ticks,
          contestants, contact_columns()};
}

}  // namespace tradeoff
