#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "game/run.h"

namespace {

constexpr int status_unusable = 2;  // bad arguments or files

/// Files that are read and files that are written must all be different ones.
void check_paths(const game::RunOptions& options) {
  namespace fs = std::filesystem;
  const std::pair<const char*, std::string> named[] = {
      {"--level", options.level && options.level->ends_with(".tmj") ? *options.level : std::string()},
      {"--replay", options.replay},
      {"--record", options.record},
      {"--screenshot", options.screenshot}};
  std::map<fs::path, const char*> seen;
  for (const auto& [option, path] : named) {
    if (path.empty()) continue;
    std::error_code ignored;
    if (fs::is_fifo(path, ignored) || fs::is_socket(path, ignored)) {
      throw std::runtime_error(std::string(option) + " " + path + " is a pipe; accepted is a file");
    }
    fs::path canonical = fs::weakly_canonical(path, ignored);
    if (canonical.empty()) canonical = path;  // nowhere that can be looked at: whoever opens it says why
    const auto [other, is_new] = seen.emplace(canonical, option);
    if (!is_new) {
      throw std::runtime_error(std::string(other->second) + " and " + option + " are both " + path +
                               "; accepted are different files");
    }
  }
}

int run(const game::RunOptions& options) {
  check_paths(options);
  const int status = options.headless ? game::run_headless(options) : game::run_in_window(options);
  if (std::fflush(stdout) != 0) throw std::runtime_error("cannot write the output");
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a recording that gets too long is an error to tell, not the end of the game
  CLI::App app{"Swing from cord to cord to the flag."};
  game::RunOptions options;
  const CLI::Validator named([](const std::string& text) { return text.empty() ? "is empty" : ""; }, "NAME");
  app.add_option("--level", options.level, "A level's name, or a Tiled map (.tmj)")->check(named);
  app.add_flag("--headless", options.headless, "Run without a window, as fast as it goes");
  auto* replay = app.add_option("--replay", options.replay, "Play the inputs of this recording")->check(named);
  auto* verify = app.add_flag("--verify", options.verify, "Compare every tick with the recording's")->needs(replay);
  auto* record = app.add_option("--record", options.record, "Record the run to this file as it happens")->check(named);
  app.add_option("--seek", options.seek, "Begin after so many ticks of the recording")
      ->check(CLI::Range(0, 1'000'000'000))
      ->needs(replay)
      ->excludes(verify)
      ->excludes(record);
  app.add_option("--ticks", options.ticks, "Stop after so many ticks of 1/60 s")
      ->check(CLI::Range(0, 1'000'000'000))
      ->excludes(verify);
  app.add_option("--screenshot", options.screenshot, "Write a PNG picture of the last moment")->check(named);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : status_unusable;
  }
  try {
    return run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ropeswing: %s\n", error.what());
    return status_unusable;
  }
}
