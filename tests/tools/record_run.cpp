// Records the autopilot's winning run of first_swing: assets/replays/first_swing.replay is made by
//   build/release/bin/record_run assets/replays/first_swing.replay
// and has to be made anew whenever the physics or the level changes on purpose, and the picture with it:
//   build/release/bin/ropeswing --headless --replay assets/replays/first_swing.replay --ticks 230
//     --screenshot assets/pictures/first_swing.png
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "engine/replay.h"
#include "game/simulation.h"
#include "tests/support/autopilot.h"

namespace {

constexpr int most_ticks = 60 * 60;
constexpr int ticks_after_goal = 30;

int record(const std::string& path) {
  const game::Level level = game::load_level("first_swing");
  game::Simulation simulation(level);
  test_support::Autopilot autopilot;
  engine::ReplayWriter writer(path, game::Simulation::replay_header(level));
  int left = most_ticks;
  while (left-- > 0) {
    engine::TickInput input;
    if (!simulation.goal_ticks()) input.buttons = autopilot.buttons(simulation);
    simulation.tick(input);
    writer.write(input, simulation.hash());
    if (simulation.goal_ticks())
      left = std::min(left, *simulation.goal_ticks() + ticks_after_goal - simulation.run_ticks());
  }
  writer.finish();
  if (!simulation.goal_ticks()) {
    std::fprintf(stderr, "record_run: the goal was not reached in %d ticks\n", most_ticks);
    return 1;
  }
  std::printf("%s: goal after %d ticks\n", path.c_str(), *simulation.goal_ticks());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Records the autopilot's winning run of first_swing."};
  std::string path;
  app.add_option("file", path, "The replay to write")->required();
  CLI11_PARSE(app, argc, argv);
  try {
    return record(path);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "record_run: %s\n", error.what());
    return 1;
  }
}
