#include <CLI/CLI.hpp>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include "engine/draw/video_writer.h"
#include "game/program/run_table.h"
#include "game/simulation/run.h"

namespace {

constexpr int status_unusable = 2;  // bad arguments or files

/// Throws if a path is a pipe or two options have the same file.
void check_paths(const game::RunOptions& options) {
  namespace fs = std::filesystem;
  const std::pair<const char*, std::string> named[] = {
      {"--level", options.level && options.level->ends_with(".tmj") ? *options.level : std::string()},
      {"--replay", options.replay},
      {"--ghost", options.ghost},
      {"--record", options.record},
      {"--screenshot", options.screenshot},
      {"--video", options.video}};
  std::map<fs::path, const char*> seen;
  for (const auto& [option, path] : named) {
    if (path.empty()) continue;
    std::error_code ignored;
    if (fs::is_fifo(path, ignored) || fs::is_socket(path, ignored)) {
      throw std::runtime_error(std::string(option) + " " + path + " is a pipe; accepted is a file");
    }
    fs::path canonical = fs::weakly_canonical(path, ignored);
    if (canonical.empty()) canonical = path;  // cannot be resolved: opening it later reports why
    const auto [other, is_new] = seen.emplace(canonical, option);
    if (!is_new) {
      throw std::runtime_error(std::string(other->second) + " and " + option + " are both " + path +
                               "; accepted are different files");
    }
  }
}

/// Reads a size such as 640x360. Throws std::runtime_error for other texts.
void read_video_size(const std::string& text, game::RunOptions& options) {
  const std::size_t cross = text.find('x');
  const auto number = [&text](std::size_t from, std::size_t to) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data() + from, text.data() + to, value);
    return error == std::errc() && end == text.data() + to && value >= 16 && value <= 4096 ? value : 0;
  };
  const int width = cross == std::string::npos ? 0 : number(0, cross);
  const int height = width == 0 ? 0 : number(cross + 1, text.size());
  if (height == 0) {
    throw std::runtime_error("--video-size " + text +
                             " is not accepted; accepted is WIDTHxHEIGHT, 16 to 4096 each, as 480x270");
  }
  options.video_width = width;
  options.video_height = height;
}

int run(const game::RunOptions& options) {
  check_paths(options);
  if (options.lab && options.ticks && !options.headless) {
    throw std::runtime_error("the lab in a window runs until it is closed; accepted with --ticks is --headless");
  }
  const int status = !options.table.empty() ? game::print_table(options.table)
                     : !options.headless    ? game::run_in_window(options)
                     : options.lab          ? game::run_lab_headless(options)
                                            : game::run_headless(options);
  if (std::fflush(stdout) != 0) throw std::runtime_error("cannot write the output");
  return status;
}

void add_options(CLI::App& app, game::RunOptions& options, std::string& video_size) {
  const CLI::Validator named([](const std::string& text) { return text.empty() ? "is empty" : ""; }, "NAME");
  app.add_option("--level", options.level, "A level's name, or a Tiled map (.tmj)")->check(named);
  auto* headless = app.add_flag("--headless", options.headless, "Run without a window at full speed");
  auto* replay = app.add_option("--replay", options.replay, "Play the inputs of this recording")->check(named);
  auto* verify = app.add_flag("--verify", options.verify, "Compare every tick with the recording")->needs(replay);
  auto* record = app.add_option("--record", options.record, "Record the run to this file as it happens")->check(named);
  app.add_option("--seek", options.seek, "Start after this many ticks of the recording")
      ->check(CLI::Range(0, 1'000'000'000))
      ->needs(replay)
      ->excludes(verify)
      ->excludes(record);
  app.add_option("--ticks", options.ticks, "Stop after this many ticks of 1/60 s")
      ->check(CLI::Range(0, 1'000'000'000))
      ->excludes(verify);
  auto* video = app.add_option("--video", options.video, "Write a video of the run, .gif or .mp4; with --headless")
                    ->check(named)
                    ->needs(headless);
  app.add_option("--video-size", video_size, "Width and height of the video in pixels; default 480x270")->needs(video);
  app.add_option("--screenshot", options.screenshot, "Write a PNG screenshot of the last tick")->check(named);
  auto* bad_ticks = app.add_option("--record-bad-ticks", options.record_bad_ticks,
                                   "Write ticks that did not converge to this folder, for flight")
                        ->check(named);
  app.add_option("--work", options.bad_work, "Also write ticks with more work than this")
      ->check(CLI::Range(std::int64_t{0}, std::int64_t{1'000'000'000'000}))
      ->needs(bad_ticks);
}

/// Adds the options that compare recordings. Call it after add_options.
void add_comparisons(CLI::App& app, game::RunOptions& options) {
  const CLI::Validator named([](const std::string& text) { return text.empty() ? "is empty" : ""; }, "NAME");
  auto* ghost = app.add_option("--ghost", options.ghost, "Race against this recording of the level")->check(named);
  auto* table = app.add_option("--table", options.table, "Verify the recordings of this folder and list their times")
                    ->check(named);
  for (const char* const name : {"--headless", "--replay"}) ghost->excludes(app.get_option(name));
  for (const char* const name : {"--level", "--replay", "--record", "--ticks", "--screenshot", "--record-bad-ticks"}) {
    table->excludes(app.get_option(name));
  }
  table->excludes(ghost);
}

/// Adds the option for the lab, which excludes all that is about runs. Call it last.
void add_lab(CLI::App& app, game::RunOptions& options) {
  auto* lab = app.add_option_function<std::string>(
                     "--lab", [&options](const std::string& scene) { options.lab = scene; },
                     "Open the lab, with one of its scenes")
                  ->type_name("[SCENE]")
                  ->expected(0, 1);
  for (const char* const name :
       {"--level", "--replay", "--record", "--video", "--record-bad-ticks", "--ghost", "--table"})
    lab->excludes(app.get_option(name));
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a recording above the size limit is an error to report, not the end of the game
  CLI::App app{"Swing from rope to rope to the flag."};
  game::RunOptions options;
  std::string video_size;
  add_options(app, options, video_size);
  add_comparisons(app, options);
  add_lab(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : status_unusable;
  }
  try {
    if (!video_size.empty()) read_video_size(video_size, options);
    if (!options.video.empty()) engine::check_video_name(options.video);
    return run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ropeswing: %s\n", error.what());
    return status_unusable;
  }
}
