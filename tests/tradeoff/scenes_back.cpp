#include <box2d/box2d.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "engine/replay/replay.h"
#include "game/simulation/simulation.h"
#include "tests/support/rollback.h"
#include "tests/tradeoff/measure.h"
#include "tests/tradeoff/scene_lists.h"

namespace tradeoff {
namespace {

constexpr int many_bodies = 1000;
constexpr int saves = 200;  // per repeat

/// A level in the middle of its recorded run, whose coupling is saved and restored.
class SavedLevel {
 public:
  explicit SavedLevel(const std::string& name) : level_(game::load_level(name)), simulation_(level_) {
    const engine::Replay replay = engine::load_replay(game::assets_folder() + "/replays/" + name + ".replay");
    const std::size_t half = replay.ticks.size() / 2;
    for (std::size_t k = 0; k < half; ++k) simulation_.tick(replay.ticks[k].input);
    save();
  }

  /// Adds sleeping bodies far away until the world has so many.
  void fill(int bodies) {
    b2CircleShape circle;
    circle.m_radius = 0.1F;
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.awake = false;
    while (world().GetBodyCount() < bodies) {
      const int k = world().GetBodyCount();
      const int row = k / 100;
      def.position.Set(2000.0F + static_cast<float>(k % 100), static_cast<float>(row));
      world().CreateBody(&def)->CreateFixture(&circle, 10.0F);
    }
    save();
  }
  void save() { coupling().save(world(), state_); }
  void restore() { coupling().restore(state_, world()); }
  int points() {
    int sum = 0;
    for (const int cord : coupling().cords()) sum += static_cast<int>(coupling().cord(cord).positions().size());
    return sum;
  }
  int bodies() { return world().GetBodyCount(); }

 private:
  b2World& world() { return simulation_.scene().world(); }
  ribbon::box2d::Coupling& coupling() { return simulation_.scene().coupling(); }

  game::Level level_;
  game::Simulation simulation_;
  ribbon::box2d::Coupling::State state_;
};

Variant save_and_restore(const std::string& setting, const std::shared_ptr<SavedLevel>& level) {
  return {"coupling",
          setting,
          level->points(),
          [] {},
          [level] { level->save(); },
          [level] { return std::vector{static_cast<double>(level->bodies())}; },
          [level] { level->restore(); }};
}

/// The heaviest level is that with the most points.
std::vector<Variant> saved_levels() {
  const std::vector<std::string> names = game::level_names();
  std::vector<std::shared_ptr<SavedLevel>> levels;
  for (const std::string& name : names) levels.push_back(std::make_shared<SavedLevel>(name));
  const auto lighter = [](const auto& a, const auto& b) { return a->points() < b->points(); };
  const auto heaviest =
      static_cast<std::size_t>(std::max_element(levels.begin(), levels.end(), lighter) - levels.begin());
  std::vector<Variant> list;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    list.push_back(save_and_restore(names[k] + (k == heaviest ? ", the heaviest" : ""), levels[k]));
  }
  const auto filled = std::make_shared<SavedLevel>(names[heaviest]);
  filled->fill(many_bodies);
  list.push_back(save_and_restore(names[heaviest] + ", 1,000 bodies", filled));
  return list;
}

constexpr int ticks_per_try = 8;  // between the ticks from which a run goes back

/// Goes back from every eighth tick of a recorded run. Returns the number of tries, how many gave the same bits,
/// largest distances of bodies and points of cords [m], and median and largest time [µs].
std::vector<double> differences(test_support::Rollback& run) {
  double same = 0.0;
  double body = 0.0;
  double cord = 0.0;
  std::vector<double> times;
  for (int tick = ticks_per_try + 1; tick <= run.size(); tick += ticks_per_try) {
    const auto difference = run.go_back(tick);
    if (!difference) continue;
    same += difference->same_bits ? 1.0 : 0.0;
    body = std::max(body, difference->body);
    cord = std::max(cord, difference->cord);
    times.push_back(difference->us);
  }
  return {static_cast<double>(times.size()), same, body, cord, quantile(times, 0.5), quantile(times, 1.0)};
}

/// The timed tick goes back and forward in the middle of the run.
Variant back_and_forward(const std::string& name) {
  const auto run = std::make_shared<test_support::Rollback>(name);
  run->seek(run->size() / 2);
  return {"WorldSnapshot",
          name,
          run->points(),
          [run] { run->seek(run->size() / 2); },
          [run] { run->back_and_forward(); },
          [run] { return differences(*run); }};
}

std::vector<Variant> recorded_runs() {
  std::vector<Variant> list;
  for (const std::string& name : test_support::recorded_runs()) list.push_back(back_and_forward(name));
  return list;
}

}  // namespace

std::vector<Scene> back_scenes() {
  return {{"save",
           "each level in the middle of its recorded run: Coupling::save and restore",
           saves,
           saved_levels,
           {us_per_tick(),
            {"save_us", 2, [](const Row& row) { return row.timing.share_us; }},
            {"restore_us", 2, [](const Row& row) { return row.timing.rest_us; }},
            figure("bodies", 0)}},
          {"back",
           "8 ticks back and forward again, with a save in each tick: the cost in the middle of each recorded run, and "
           "what differs from the run that did not go back, from every eighth tick",
           20,
           recorded_runs,
           {us_per_tick(), figure("tries", 0), figure("same_bits", 1), figure("bodies_m", 2), figure("cords_m", 3),
            figure("median_us", 4), figure("max_us", 5)}}};
}

}  // namespace tradeoff
