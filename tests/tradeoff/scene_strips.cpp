

#include "tests/study/figures.h"
#include "tests/support/contact_scenes.h"
#include "tests/tradeoff/contact_run.h"
#include "tests/tradeoff/scenes_contact.h"

namespace tradeoff {
namespace {

using study::unavailable;
using test_support::CoupledWorld;

struct Size {
  int strips;
  int ticks;
  int counted_ticks;  // for the baseline of work
};

Scene strips(const std::string& name, const std::string& size_note, Size size, double target_us) {
  const auto variants = [size, target_us] {
    std::vector<Variant> list;
    const auto add = [&](const NamedMethod& method, bool strip_contact) {
      list.push_back(
          variant({method,
                   strip_contact ? "with contact between strips" : "with circles only",
                   [=](CoupledWorld& world) { test_support::drop_strips(world, size.strips, strip_contact); },
                   false,
                   {0.0, -9.81},
                   [=](CoupledWorld& world) { return figures_of(world, run(world, size.ticks), target_us); }}));
    };
    for (const NamedMethod& method : presets({"fast", "balanced"})) add(method, true);
    for (const NamedMethod& method : together(presets({"fast", "balanced"}), thesis_cords({8, 16}, 0.45)))
      add(method, false);
    return list;
  };
  return {
      name,
      "ribbons of 33 x 2 points that fall through a lattice of circles",
      size.ticks,
      variants,
      contact_columns(),
      {},
      {size_note,
       "The thesis's strips have contacts with circles only, not with each other, walls or the floor, and no friction.",
       "Box2D has no ribbons; a chain of a strip's middle line would be another model.", no_b2_rope},
      {"balanced"},
      5,
      size.counted_ticks};
}

}  // namespace

Scene strips_scene() { return strips("strips", "150 strips, five seconds.", {150, 300, 36}, 16000.0); }

Scene short_strips_scene() {
  return strips("strips_short", "30 strips, two seconds; `tradeoff --scene strips` has 150 for five.", {30, 120, 120},
                unavailable);
}

}  // namespace tradeoff
