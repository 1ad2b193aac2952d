#include <memory>

#include "tests/support/thesis_scenes.h"
#include "tests/tradeoff/dense_inverse.h"
#include "tests/tradeoff/scene_lists.h"

namespace tradeoff {
namespace {

using ribbon::ThesisCord;
using test_support::earth_gravity;
using test_support::frame_dt;

Variant variant(const char* method, const ribbon::ThesisDef& def, std::unique_ptr<ribbon::LinearSolver> solver) {
  const auto cord = std::make_shared<ThesisCord>(def, std::move(solver));
  Variant out;
  out.method = method;
  out.setting = "substeps=" + std::to_string(def.substeps);
  out.points = cord->mesh().size();
  out.tick = [cord] { cord->step(frame_dt, earth_gravity); };
  return out;
}

/// The thesis's step, with our banded solve and with its dense inverse: a hanging cord, self-collision on.
template <int Row>
std::vector<Variant> thesis_condition() {
  const ribbon::ThesisDef def = test_support::hanging(test_support::thesis_conditions[Row]);
  std::vector<Variant> both;
  both.push_back(variant("banded", def, std::make_unique<ribbon::BandedLdlt>()));
  both.push_back(variant("dense_inverse", def, std::make_unique<DenseInverse>()));
  return both;
}

/// The same material with increasing length, without collision: the cost per point.
std::vector<Variant> scaling() {
  std::vector<Variant> lengths;
  for (const int w : {25, 250, 2500}) {
    test_support::ThesisCondition condition = test_support::thesis_conditions[0];
    condition.w = w;
    ribbon::ThesisDef def = test_support::hanging(condition);
    def.self_collision = false;
    lengths.push_back(variant("banded", def, std::make_unique<ribbon::BandedLdlt>()));
  }
  return lengths;
}

}  // namespace

std::vector<Scene> thesis_scenes() {
  const std::vector<Column> columns = {us_per_tick(), frames_per_second()};
  return {
      {"thesis_a", "25 x 2 points, 8 substeps, self-collision: banded against dense inverse", 20, thesis_condition<0>,
       columns},
      {"thesis_b", "10 x 5 points, 8 substeps, self-collision: banded against dense inverse", 20, thesis_condition<1>,
       columns},
      {"thesis_c", "35 x 2 points, 8 substeps, self-collision: banded against dense inverse", 20, thesis_condition<2>,
       columns},
      {"thesis_d", "35 x 2 points, 4 substeps, self-collision: banded against dense inverse", 20, thesis_condition<3>,
       columns},
      thesis_trade_scene(),
      {"scaling", "25, 250 and 2500 x 2 points of the thesis's cord, no collision: cost a point", 10, scaling, columns},
  };
}

}  // namespace tradeoff
