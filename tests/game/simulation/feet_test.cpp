// What carries the feet of a player: ground, and cords that are solid; not the end of a rope that is caught at a ledge.

#include <gtest/gtest.h>

#include <vector>

#include "engine/replay/replay.h"
#include "game/simulation/buttons.h"
#include "game/simulation/footing.h"
#include "game/simulation/saved_tick.h"
#include "game/simulation/simulation.h"
#include "tests/game/simulation/press.h"

namespace game {
namespace {

/// From a run that swings over to a ledge, the player goes down its rope, or lets go and catches it again: the rope is
/// below its feet, over the edge, and between both.
TEST(Feet, AreNotCarriedByARopeThatIsNotSolid) {
  const Level level = load_level("in_rhythm");
  const engine::Replay replay = engine::load_replay(assets_folder() + "/replays/in_rhythm.replay");
  Simulation simulation(level);
  SavedTick saved;
  int below = 0;  // ticks in which the rope's end is within half a metre of the soles
  for (std::size_t t = 0; t < replay.ticks.size(); ++t) {
    simulation.tick(replay.ticks[t].input);
    if (t % 60 != 0 || !simulation.player().held_place(simulation.scene().coupling())) continue;
    simulation.save(saved);
    for (const int button : {int{button_down}, int{button_right}}) {
      ASSERT_TRUE(simulation.restore(saved, nullptr));
      for (int k = 0; k < 180; ++k) {
        simulation.tick(press(k % 60 == 50 ? button : button | button_grab));
        const Player& player = simulation.player();
        const Footing footing = find_footing(player.body(), simulation.scene().coupling(), player.tuning());
        ASSERT_FALSE(footing.is_cord) << "tick " << t << " + " << k;
        const ribbon::Vec2 soles = player.position() - ribbon::Vec2{0.0, 0.5 * player.tuning().height};
        for (const std::vector<ribbon::Vec2>& cord : simulation.current().cords) {
          if (!cord.empty() && length(cord.back() - soles) < 0.5) ++below;
        }
      }
    }
    ASSERT_TRUE(simulation.restore(saved, nullptr));
  }
  EXPECT_GT(below, 20);
}

}  // namespace
}  // namespace game
