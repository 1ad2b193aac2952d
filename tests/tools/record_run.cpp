// Records a winning run of a level, played by the scripted player: assets/replays/NAME.replay is made by
//   build/release/bin/record_run NAME assets/replays/NAME.replay
// Record it again after an intended change of the physics or the level (tests/tools/record_runs does so for
// all levels, and for the pictures).
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "engine/replay/replay.h"
#include "game/simulation/medals.h"
#include "game/simulation/run_header.h"
#include "game/simulation/simulation.h"
#include "tests/support/scripted_player.h"

namespace {

constexpr int most_ticks = 4 * 60 * 60;
constexpr int ticks_after_goal = 30;

void trace(const game::Simulation& simulation, std::size_t move, int number) {
  const game::Player& player = simulation.player(number);
  const b2Vec2 v = player.body().GetLinearVelocity();
  std::printf("tick %4d move %2zu at %6.2f %6.2f  v %6.2f %6.2f%s%s%s\n", simulation.run_ticks(), move,
              player.position().x, player.position().y, static_cast<double>(v.x), static_cast<double>(v.y),
              player.is_on_ground() ? " ground" : "", player.held_place(simulation.scene().coupling()) ? " holds" : "",
              player.line().state() == game::Line::State::held ? " line" : "");
}

int record(const std::string& name, const std::string& path, int trace_every) {
  const game::Level level = game::load_level(name);
  game::Simulation simulation(level);
  test_support::ScriptedPlayer player = test_support::winner_of(level.name);
  engine::ReplayWriter writer(path, game::replay_header(level));
  int left = most_ticks;
  while (left-- > 0 && !player.is_stuck()) {
    const engine::TickInput input = player.input(simulation);
    simulation.tick(input);
    writer.write(input, simulation.hash());
    for (int k = 0; trace_every > 0 && simulation.ticks() % trace_every == 0 && k < simulation.players(); ++k) {
      trace(simulation, player.move(static_cast<std::size_t>(k)), k);
    }
    if (simulation.goal_ticks())
      left = std::min(left, *simulation.goal_ticks() + ticks_after_goal - simulation.run_ticks());
    if (player.is_done() && !simulation.goal_ticks()) break;
  }
  writer.finish();
  if (!level.goal) {
    std::printf("%s: %d ticks, without a goal\n", path.c_str(), simulation.ticks());
    return player.is_done() ? 0 : 1;
  }
  if (!simulation.goal_ticks()) {
    std::fprintf(stderr, "record_run: the goal of %s was not reached: %zu moves were done in %d ticks\n", name.c_str(),
                 player.move(), simulation.ticks());
    return 1;
  }
  const game::Medals medals = game::medals_by_rule(*simulation.goal_ticks());
  std::printf("%s: goal after %d ticks; its level's medals: gold %g, silver %g, bronze %g s\n", path.c_str(),
              *simulation.goal_ticks(), medals.gold, medals.silver, medals.bronze);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Records the scripted player's winning run of a level."};
  std::string level;
  std::string path;
  int trace_every = 0;
  app.add_option("level", level, "The level's name")->required();
  app.add_option("file", path, "The replay to write")->required();
  app.add_option("--trace", trace_every, "Print where the player is, every so many ticks");
  CLI11_PARSE(app, argc, argv);
  try {
    return record(level, path, trace_every);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "record_run: %s\n", error.what());
    return 1;
  }
}
