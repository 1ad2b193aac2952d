// Every scene of the lab, without a window.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <tuple>
#include <vector>

#include "game/lab/experiment.h"
#include "game/lab/figures.h"
#include "game/lab/history.h"
#include "game/simulation/buttons.h"
#include "ribbon/definition.h"
#include "tests/game/lab/cords_of.h"

namespace game::lab {
namespace {

constexpr int ten_seconds = 600;  // ticks

int unconverged_in(const Bench& bench) {
  int sum = 0;
  for (const ribbon::box2d::CordId id : bench.coupling().cords())
    sum += bench.coupling().cord(id).island_total().unconverged;
  return sum;
}

struct Run {
  std::string scene;
  int preset;
};
void PrintTo(const Run& run, std::ostream* out) { *out << run.scene << ", preset " << run.preset; }

/// Returns the scenes with all their presets: those that take long, which are large ones with another preset than the
/// fast one, or all others.
std::vector<Run> runs(bool long_ones) {
  std::vector<Run> all;
  for (const Scene& scene : scenes()) {
    const bool is_large = scene.name == "pile" || scene.name == "strips" || scene.name == "lamps";
    const int presets = range_of(scene, Knob::preset) == nullptr ? 1 : 3;
    for (int preset = 0; preset < presets; ++preset) {
      if ((is_large && preset > 0) == long_ones) all.push_back({std::string(scene.name), preset});
    }
  }
  return all;
}

std::string name_of(const testing::TestParamInfo<Run>& run) {
  return run.param.scene + "_preset_" + std::to_string(run.param.preset);
}
class LabScenes : public testing::TestWithParam<Run> {};
INSTANTIATE_TEST_SUITE_P(All, LabScenes, testing::ValuesIn(runs(false)), name_of);
class LongLabScenes : public testing::TestWithParam<Run> {};
INSTANTIATE_TEST_SUITE_P(All, LongLabScenes, testing::ValuesIn(runs(true)), name_of);

/// The bound of the stretch of a scene, relative.
double most_stretch(const std::string& scene) {
  if (scene == "heavy_load" || scene == "bridge" || scene == "buckling" || scene == "lamps") return 1e-3;
  if (scene == "capstan") return 2e-3;
  return 0.5;  // rubber, and the springs of the thesis
}

void run_ten_seconds(const Run& run) {
  const auto& [name, preset] = run;
  Experiment experiment(scene_named(name));
  if (range_of(experiment.scene(), Knob::preset) != nullptr) experiment.set(Knob::preset, preset);
  double stretch = 0.0;
  for (int tick = 0; tick < ten_seconds; ++tick) {
    experiment.tick();
    ASSERT_TRUE(is_finite(cords_of(experiment))) << tick;
    stretch = std::max(stretch, greatest_stretch(cords_of(experiment)));
  }
  EXPECT_LT(stretch, most_stretch(name));
  EXPECT_EQ(experiment.ticks(), ten_seconds);
  const bool heap = name == "pile" || name == "strips";
  if (!heap) {
    EXPECT_EQ(unconverged_in(cords_of(experiment)), 0);
  }
}

TEST_P(LabScenes, RunTenSecondsWithinTheirBounds) { run_ten_seconds(GetParam()); }
TEST_P(LongLabScenes, RunTenSecondsWithinTheirBounds) { run_ten_seconds(GetParam()); }

TEST(Lab, RefusesAnUnknownSceneWithTheNamesOfAll) {
  try {
    scene_named("nonsense");
    FAIL();
  } catch (const std::runtime_error& error) {
    const std::string sentence = error.what();
    EXPECT_NE(sentence.find("'nonsense'"), std::string::npos) << sentence;
    for (const Scene& scene : scenes()) EXPECT_NE(sentence.find(scene.name), std::string::npos) << scene.name;
  }
}

TEST(Lab, RefusesValuesOutOfRangeAndChangesNothing) {
  Experiment experiment(scene_named("bridge"));
  const KnobValues before = experiment.values();
  EXPECT_THROW(experiment.set(Knob::friction, -1.0), ribbon::DefinitionError);
  EXPECT_THROW(experiment.set(Knob::friction, std::nan("")), ribbon::DefinitionError);
  EXPECT_THROW(experiment.set(Knob::turns, 1.0), ribbon::CallError);
  EXPECT_EQ(experiment.values(), before);
}

class LabScene : public testing::TestWithParam<std::string> {};
std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const Scene& scene : scenes()) all.emplace_back(scene.name);
  return all;
}
INSTANTIATE_TEST_SUITE_P(All, LabScene, testing::ValuesIn(names()), [](const auto& name) { return name.param; });

TEST_P(LabScene, HasTheSameBitsInTwoRunsAndAfterARestart) {
  Experiment one(scene_named(GetParam()));
  Experiment other(scene_named(GetParam()));
  const std::uint64_t first = one.hash();
  EXPECT_EQ(other.hash(), first);
  std::vector<std::uint64_t> hashes;
  for (int tick = 0; tick < 60; ++tick) {
    one.tick();
    other.tick();
    ASSERT_EQ(one.hash(), other.hash()) << tick;
    hashes.push_back(one.hash());
  }
  EXPECT_NE(one.hash(), first) << "something moves";
  one.restart();
  EXPECT_EQ(one.hash(), first);
  EXPECT_EQ(one.ticks(), 0);
  for (int tick = 0; tick < 60; ++tick) {
    one.tick();
    ASSERT_EQ(one.hash(), hashes[static_cast<std::size_t>(tick)]) << tick;
  }
}

/// Returns a drag of the last point of the first cord to a place near its first one, which folds the cords of the
/// thesis.
engine::TickInput fold(const Experiment& experiment) {
  const auto x = cords_of(experiment).coupling().cord(0).positions();
  engine::TickInput input;
  input.buttons = button_drag;
  engine::set_pointer(input, experiment.ticks() == 0 ? x.back() : x.front() + ribbon::Vec2{0.02, -0.2});
  return input;
}

/// Every slider of a scene changes its motion: a second later the state differs from that of a run without it.
TEST_P(LabScene, EverySliderChangesTheMotion) {
  const Scene& scene = scene_named(GetParam());
  for (const KnobRange& range : scene.knobs) {
    Experiment plain(scene);
    Experiment changed(scene);
    // Few cords: the preset fast takes a heap of eight or more in one step, however many substeps are asked for.
    if (range_of(scene, Knob::count) != nullptr) {
      const double few = std::max(range_of(scene, Knob::count)->min, 6.0);
      for (Experiment* each : {&plain, &changed}) each->set(Knob::count, few);
    }
    for (int tick = 0; tick < 20; ++tick) {
      plain.tick(fold(plain));
      changed.tick(fold(changed));
    }
    // Away from where it is, within the range: towards the end that is farther.
    const double place = range.position_of(range.initial);
    const double value = range.value_at(place > 0.5 ? 0.1 : 0.9);
    changed.set(range.knob, value);
    EXPECT_EQ(changed.values()[range.knob], value);
    EXPECT_EQ(changed.ticks(), range.rebuilds ? 0 : 20);
    for (int tick = 0; tick < 60; ++tick) {
      plain.tick(fold(plain));
      changed.tick(fold(changed));
    }
    EXPECT_NE(plain.hash(), changed.hash()) << scene.name << ", knob " << static_cast<int>(range.knob);
    EXPECT_TRUE(is_finite(cords_of(changed)));
  }
}

/// Substeps change nothing in a heap of cords with soft contacts, and what the lab says of it is what the library
/// reports: a heap of balanced ones takes them all, and so do cords that do not touch.
TEST(Lab, TellsWhereSubstepsChangeNothing) {
  Experiment one(scene_named("pile"));
  Experiment four(scene_named("pile"));
  EXPECT_EQ(cords_in_one_step(cords_of(one)), 0);
  for (int tick = 0; tick < 150; ++tick) {
    one.tick();
    four.tick();
  }
  four.set(Knob::substeps, 4.0);
  one.tick();
  four.tick();
  EXPECT_EQ(cords_in_one_step(cords_of(one)), 0) << "one is what was asked for";
  EXPECT_EQ(cords_in_one_step(cords_of(four)), 12);
  for (const ribbon::box2d::CordId id : cords_of(one).coupling().cords()) {
    const auto x = cords_of(one).coupling().cord(id).positions();
    const auto y = cords_of(four).coupling().cord(id).positions();
    EXPECT_TRUE(std::equal(x.begin(), x.end(), y.begin(), y.end())) << id;
  }
  four.set(Knob::preset, 1.0);
  four.set(Knob::substeps, 4.0);
  four.tick();
  EXPECT_EQ(cords_in_one_step(cords_of(four)), 0);
}

/// Wherever the direct solver is at work, a scene tells what it did not solve.
TEST(Lab, EverySceneOfTheDirectSolverTellsWhatDidNotConverge) {
  for (const Scene& scene : scenes()) {
    const Experiment experiment(scene);
    const auto readings = scene.readings(cords_of(experiment), experiment.values());
    const bool tells = std::any_of(readings.begin(), readings.end(),
                                   [](const Reading& each) { return each.kind == Reading::Kind::unconverged; });
    EXPECT_EQ(tells, range_of(scene, Knob::preset) != nullptr) << scene.name;
  }
}

TEST(Lab, APresetSetsSubstepsAndTolerance) {
  Experiment experiment(scene_named("bridge"));
  experiment.set(Knob::preset, 2.0);
  EXPECT_EQ(experiment.values()[Knob::substeps], ribbon::Accuracy::accurate().substeps);
  EXPECT_EQ(cords_of(experiment).coupling().cord(0).direct().def().accuracy, ribbon::Accuracy::accurate());
  experiment.set(Knob::substeps, 7.0);
  EXPECT_EQ(cords_of(experiment).coupling().cord(0).direct().def().accuracy.substeps, 7);
}

/// What moves stays where it is while its material changes.
TEST(Lab, AChangeOfTheMaterialMovesNothing) {
  for (const auto& [scene, knob, value] : {std::tuple{"heavy_load", Knob::stretch, 1e6},
                                           {"capstan", Knob::bending, 0.1},
                                           {"pile", Knob::bending, 0.1},
                                           {"buckling", Knob::bending, 10.0},
                                           {"thesis_b", Knob::spring_share, 0.8},
                                           {"bridge", Knob::load_ratio, 1000.0}}) {
    Experiment experiment(scene_named(scene));
    for (int tick = 0; tick < 30; ++tick) experiment.tick();
    const auto x = cords_of(experiment).coupling().cord(0).positions();
    const std::vector<ribbon::Vec2> before(x.begin(), x.end());
    experiment.set(knob, value);
    const auto after = cords_of(experiment).coupling().cord(0).positions();
    EXPECT_TRUE(std::equal(before.begin(), before.end(), after.begin(), after.end())) << scene;
  }
}

TEST(Lab, HistoryKeepsTheLastSeconds) {
  Experiment experiment(scene_named("heavy_load"));
  History history;
  for (int tick = 0; tick < static_cast<int>(History::length) + 10; ++tick) {
    experiment.tick();
    history.add(experiment);
  }
  EXPECT_EQ(history.size(), History::length);
  const auto newest = history.sample(1, History::length - 1);
  EXPECT_EQ(newest.stretch, greatest_stretch(*experiment.benches()[1]));
  EXPECT_EQ(newest.energy, energy(*experiment.benches()[1]) - experiment.first_energy(1));
  experiment.restart();
  experiment.tick();
  history.add(experiment);
  EXPECT_EQ(history.size(), 1U) << "a restart begins a new history";
}

}  // namespace
}  // namespace game::lab
