#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "game/run.h"

namespace {

constexpr int status_unusable = 2;  // bad arguments or files

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Swing from cord to cord to the flag."};
  game::RunOptions options;
  app.add_option("--level", options.level, "A level's name, or a Tiled map (.tmj)");
  app.add_flag("--headless", options.headless, "Run without a window, as fast as it goes");
  auto* replay = app.add_option("--replay", options.replay, "Play the inputs of this recording");
  auto* verify = app.add_flag("--verify", options.verify, "Compare every tick with the recording's")->needs(replay);
  app.add_option("--record", options.record, "Record the run to this file as it happens");
  app.add_option("--ticks", options.ticks, "Stop after so many ticks of 1/60 s")
      ->check(CLI::Range(0, 1'000'000'000))
      ->excludes(verify);
  app.add_option("--screenshot", options.screenshot, "Write a PNG picture of the last moment");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : status_unusable;
  }
  try {
    return options.headless ? game::run_headless(options) : game::run_in_window(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ropeswing: %s\n", error.what());
    return status_unusable;
  }
}
