// That a tick of the game takes no memory, in the recorded winning run of every level.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "engine/replay/replay.h"
#include "game/simulation/simulation.h"
#include "tests/support/allocations.h"

namespace game {
namespace {

constexpr int warm_up = 60;  // ticks, in which everything is there for the first time

/// Tells ticks in which something is new, and may need room, from steady ones.
class Novelty {
 public:
  /// Whether in the last tick a cord came into being, an island was joined or left, somebody took or let go a cord,
  /// began or ceased to touch one, or more came near one than ever before.
  bool is_new(const Simulation& simulation) {
    const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
    const int islands = coupling.islands();
    const bool holds = coupling.held_by(simulation.player().body()).has_value();
    bool found = islands != islands_ || holds != holds_ || simulation.player().line().is_new() ||
                 !coupling.touch_events().empty();
    islands_ = islands;
    holds_ = holds;
    most_near_.resize(static_cast<std::size_t>(coupling.size()));
    for (int c = 0; c < coupling.size(); ++c) {
      int& most = most_near_[static_cast<std::size_t>(c)];
      found = found || coupling.cord(c).near_count() > most;
      most = std::max(most, coupling.cord(c).near_count());
    }
    return found;
  }

 private:
  int islands_ = 0;
  bool holds_ = false;
  std::vector<int> most_near_;
};

struct Ticks {
  int steady = 0;             ///< in which nothing is new
  std::vector<int> growing;   ///< those of them that take memory
  std::vector<int> new_ones;  ///< others that do
  int longest = 0;            ///< of the stretches in which none does
};

Ticks ticks_of(const std::string& name) {
  const engine::Replay replay = engine::load_replay(assets_folder() + "/replays/" + name + ".replay");
  const Level level = load_level(name);
  Simulation simulation(level);
  Novelty novelty;
  Ticks ticks;
  int stretch = 0;
  for (const auto& recorded : replay.ticks) {
    const test_support::AllocationCount allocations;
    simulation.tick(recorded.input);
    const bool takes_memory = allocations.so_far() > 0;
    const bool is_new = novelty.is_new(simulation);
    if (simulation.ticks() <= warm_up) continue;
    stretch = takes_memory ? 0 : stretch + 1;
    ticks.longest = std::max(ticks.longest, stretch);
    if (!is_new) ++ticks.steady;
    if (takes_memory) (is_new ? ticks.new_ones : ticks.growing).push_back(simulation.ticks());
  }
  return ticks;
}

class EveryWinningRun : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Memory, EveryWinningRun, testing::ValuesIn(level_names()),
                         [](const auto& level) { return level.param; });

/// What is near a cord, but not yet touching it, cannot be seen from here. The lists of such pairs have room for 64
/// from the first one on and double then, and the linear solve's pattern doubles with them, one island after the other:
/// so much growth is allowed, and nothing else.
TEST_P(EveryWinningRun, TakesNoMemoryInATickInWhichNothingIsNew) {
  constexpr std::size_t most_growing = 8;
  constexpr std::size_t most_new = 16;
  const Ticks ticks = ticks_of(GetParam());
  EXPECT_GT(ticks.steady, 200);
  EXPECT_GE(ticks.longest, 2 * ticks_per_second);
  EXPECT_LE(ticks.growing.size(), most_growing) << testing::PrintToString(ticks.growing);
  EXPECT_LE(ticks.new_ones.size(), most_new) << testing::PrintToString(ticks.new_ones);
}

}  // namespace
}  // namespace game
