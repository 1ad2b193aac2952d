#include <box2d/box2d.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "engine/replay/replay.h"
#include "game/simulation/simulation.h"
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
      def.position.Set(2000.0F + static_cast<float>(k % 100), static_cast<float>(k / 100));
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

}  // namespace

std::vector<Scene> back_scenes() {
  return {{"save",
           "each level in the middle of its recorded run: Coupling::save and restore",
           saves,
           saved_levels,
           {us_per_tick(),
            {"save_us", 2, [](const Row& row) { return row.timing.share_us; }},
            {"restore_us", 2, [](const Row& row) { return row.timing.rest_us; }},
            figure("bodies", 0)}}};
}

}  // namespace tradeoff
