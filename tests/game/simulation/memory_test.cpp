// No tick of the game allocates memory, in the recorded winning run of every level.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "engine/replay/replay.h"
#include "game/simulation/simulation.h"
#include "tests/support/allocations.h"

namespace game {
namespace {

constexpr int warm_up = 60;  // ticks in which everything occurs for the first time

/// Separates ticks with something new, which may allocate, from steady ones.
class Novelty {
 public:
  /// Returns whether in the last tick a cord was created, an island changed, a grip or a contact began or ended, a
  /// cord was cut, or more bodies were near a cord than ever before.
  bool is_new(const Simulation& simulation) {
    const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
    const int islands = coupling.last_step().islands();
    const bool holds = coupling.body(simulation.player().body()).held_place().has_value();
    bool found = islands != islands_ || !coupling.last_step().cut_events().empty() || holds != holds_ ||
                 simulation.player().line().is_new() || !coupling.last_step().touch_events().empty();
    islands_ = islands;
    holds_ = holds;
    const auto ids = coupling.cords();
    most_near_.resize(ids.empty() ? 0 : static_cast<std::size_t>(ids.back()) + 1);
    for (const ribbon::box2d::CordId c : ids) {
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
  int steady = 0;             ///< number of ticks without anything new
  std::vector<int> growing;   ///< steady ticks that allocate
  std::vector<int> new_ones;  ///< other ticks that allocate
  int longest = 0;            ///< longest sequence of ticks, none of which was steady and allocated
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
    stretch = takes_memory && !is_new ? 0 : stretch + 1;
    ticks.longest = std::max(ticks.longest, stretch);
    if (!is_new) ++ticks.steady;
    if (takes_memory) (is_new ? ticks.new_ones : ticks.growing).push_back(simulation.ticks());
  }
  return ticks;
}

class EveryWinningRun : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Memory, EveryWinningRun, testing::ValuesIn(level_names()),
                         [](const auto& level) { return level.param; });

/// The candidate pairs of a cord are not visible here. Their lists have a capacity of 64 at first and then double, and
/// the pattern of the linear solve doubles with them, one island after the other. Only that growth is allowed.
TEST_P(EveryWinningRun, AllocatesNothingInATickWithoutNewObjects) {
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
