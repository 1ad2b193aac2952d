#include "tests/tradeoff/scenes.h"

#include <algorithm>
#include <limits>
#include <memory>

#include "tests/support/heavy_swing.h"
#include "tests/support/thesis_scenes.h"
#include "tests/tradeoff/dense_inverse.h"

namespace tradeoff {
namespace {

using ribbon::ThesisCord;
using test_support::earth_gravity;
using test_support::frame_dt;

Contestant contestant(const char* method, const ribbon::ThesisDef& def, std::unique_ptr<ribbon::LinearSolver> solver) {
  const auto cord = std::make_shared<ThesisCord>(def, std::move(solver));
  return {method, "substeps=" + std::to_string(def.substeps), cord->mesh().size(),
          [cord] { cord->step(frame_dt, earth_gravity); }};
}

/// The thesis's step, with our banded solve and with its dense inverse: a hanging cord, self-collision on.
template <int Row>
std::vector<Contestant> thesis_condition() {
  const ribbon::ThesisDef def = test_support::hanging(test_support::thesis_conditions[Row]);
  std::vector<Contestant> both;
  both.push_back(contestant("banded", def, std::make_unique<ribbon::BandedLdlt>()));
  both.push_back(contestant("dense_inverse", def, std::make_unique<DenseInverse>()));
  return both;
}

/// The same material, longer and longer, without collision: what a point costs.
std::vector<Contestant> scaling() {
  std::vector<Contestant> lengths;
  for (const int w : {25, 250, 2500}) {
    test_support::ThesisCondition condition = test_support::thesis_conditions[0];
    condition.w = w;
    ribbon::ThesisDef def = test_support::hanging(condition);
    def.self_collision = false;
    lengths.push_back(contestant("banded", def, std::make_unique<ribbon::BandedLdlt>()));
  }
  return lengths;
}

/// The direct solver with 70 kg on 1 kg of cord, by substeps, cords that do not stretch.
std::vector<Contestant> heavy_swing() {
  std::vector<Contestant> settings;
  for (const int substeps : {1, 2, 4, 8}) {
    const auto rope = std::make_shared<ribbon::Cord>(test_support::heavy_swing(
        std::numeric_limits<double>::infinity(), {ribbon::Integrator::tr_bdf2, substeps, 8, 5e-4}));
    settings.push_back({"rope", "substeps=" + std::to_string(substeps), rope->def().points,
                        [rope] { rope->step(frame_dt, earth_gravity); }});
  }
  return settings;
}

}  // namespace

const std::vector<Scene>& scenes() {
  static const std::vector<Scene> all = {
      {"thesis_a", "25 x 2 points, 8 substeps, self-collision: banded against dense inverse", 20, thesis_condition<0>},
      {"thesis_b", "10 x 5 points, 8 substeps, self-collision: banded against dense inverse", 20, thesis_condition<1>},
      {"thesis_c", "35 x 2 points, 8 substeps, self-collision: banded against dense inverse", 20, thesis_condition<2>},
      {"thesis_d", "35 x 2 points, 4 substeps, self-collision: banded against dense inverse", 20, thesis_condition<3>},
      {"heavy_swing", "51 points and a load of 70 times their weight, swinging: the direct solver by substeps", 300,
       heavy_swing},
      {"scaling", "25, 250 and 2500 x 2 points, no collision: cost a point", 10, scaling},
  };
  return all;
}

const Scene* find_scene(const std::string& name) {
  const auto found = std::find_if(scenes().begin(), scenes().end(), [&](const Scene& s) { return s.name == name; });
  return found == scenes().end() ? nullptr : &*found;
}

}  // namespace tradeoff
