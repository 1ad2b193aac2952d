#include "tests/peers/scenes.h"

#include <algorithm>

#include "tests/study/text.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/exact_chain.h"

namespace peers {
namespace {

using test_support::CoupledWorld;
namespace heavy = test_support::heavy;

constexpr double inextensible = std::numeric_limits<double>::infinity();

void hang_heavy_swing(CoupledWorld& world) {
  ribbon::CordDef def;
  def.points = heavy::links + 1;
  def.length = heavy::length;
  def.mass_per_length = heavy::rope_mass / heavy::length;
  def.pins = {0};
  const int cord = world.add(def);
  constexpr double inertia = 0.1 * heavy::load_mass;  // no effect: the cord holds the load at its centre
  world.hold(cord, heavy::links, world.add_load(b2_dynamicBody, {heavy::length, 0.0}, heavy::load_mass, inertia));
}

double load_error(const Figures& /*figures*/, const Recording& recording) {
  static const std::vector<ribbon::Vec2> exact = test_support::exact_heavy_load();
  return path_error(recording, exact);
}

double stretch_error(const Figures& figures, const Recording& /*recording*/) {
  return std::max(0.0, figures.stretch_m);
}

double contact_error(const Figures& figures, const Recording& /*recording*/) {
  return std::max({0.0, figures.penetration, figures.stretch_m});
}

double resting_error(const Figures& figures, const Recording& recording) {
  return std::max(contact_error(figures, recording), figures.drift);
}

double depth_error(const Figures& figures, const Recording& /*recording*/) {
  return std::max(0.0, figures.penetration);
}

std::vector<Scene> all() {
  std::vector<Scene> list;
  list.push_back({"heavy_swing", "", "a load of 70 kg on a rope of 10 m and 1 kg, let go from the horizontal", false,
                  hang_heavy_swing, 0, heavy::ticks, "distance of the load from the exact path, RMS [m]", load_error});
  for (const double ratio : {168.0, 1000.0, 1e6}) {
    list.push_back({"mass_ratio", "ratio=" + study::significant(ratio, 4),
                    "a load that hangs still on a rope of 3 m and 31 points, so many times as heavy", false,
                    [ratio](CoupledWorld& world) { test_support::hang_load(world, ratio, inextensible); }, 0, 600,
                    "stretch [m]", stretch_error});
  }
  for (const double ratio : {0.01, 1.0, 100.0}) {
    list.push_back({"bridge", "ratio=" + study::significant(ratio, 4),
                    "a ball that rests on a cord between two pins for ten seconds, so many times as heavy", true,
                    [ratio](CoupledWorld& world) { test_support::hang_bridge(world, ratio, 0); }, 600, 600,
                    "drift, overlap or stretch [m]", resting_error});
  }
  list.push_back({"drape", "", "a cord of 50 points that falls over 20 static circles, for two seconds", true,
                  [](CoupledWorld& world) { test_support::lay_over_circles(world, 0.5); }, 0, 120,
                  "overlap or stretch [m]", contact_error});
  list.push_back({"cords_and_circles", "", "100 cords of 50 points, and 200 balls that fall and roll among them", true,
                  [](CoupledWorld& world) { test_support::hang_hall(world); }, 0, 300, "overlap or stretch [m]",
                  contact_error});
  list.push_back({"strips", "", "30 ribbons of 33 × 2 points that fall on circles and each other, for two seconds",
                  true, [](CoupledWorld& world) { test_support::drop_strips(world, 30); }, 0, 120, "overlap [m]",
                  depth_error});
  return list;
}

}  // namespace

const std::vector<Scene>& scenes() {
  static const std::vector<Scene> list = all();
  return list;
}

}  // namespace peers
