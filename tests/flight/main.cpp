// Replays a recorded step of the direct solver:
//   build/release/bin/flight bad/1.json                       the result and figures computed without the solver
//   build/release/bin/flight bad/1.json --profile             the time that it takes
//   build/release/bin/flight bad/1.json --shrink small.json   the smallest step that does not converge
//   build/release/bin/flight bad/1.json --code                the step as a test in C++
#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>

#include "tests/flight/code.h"
#include "tests/flight/describe.h"
#include "tests/flight/replay.h"
#include "tests/flight/shrink.h"

namespace {

struct Options {
  std::string file;
  bool profile = false;
  int repeats = 25;
  std::string shrink_to;
  std::optional<std::int64_t> work;
  bool code = false;
};

flight::StillFails condition(const engine::SolverStep& step, const Options& options) {
  flight::Replay replay(step);
  replay.run();
  const bool is_unconverged = replay.total().unconverged > 0;
  const std::int64_t work = replay.total().work;
  if (options.work ? work <= *options.work : !is_unconverged) {
    throw std::runtime_error(options.file + ": the step " + (is_unconverged ? "does not converge" : "converges") +
                             " with a work of " + std::to_string(work) +
                             "; accepted is --work with less than that, or without it a step that does not converge");
  }
  return [most = options.work](const engine::SolverStep& candidate) {
    flight::Replay candidate_replay(candidate);
    candidate_replay.run();
    return most ? candidate_replay.total().work > *most : candidate_replay.total().unconverged > 0;
  };
}

void shrink(const engine::SolverStep& step, const Options& options) {
  const flight::StillFails fails = condition(step, options);
  const auto show = [](const engine::SolverStep& smallest, int tried) {
    if (tried % 16 == 0) std::fprintf(stderr, "\rtried %d, left %zu parts  ", tried, flight::size_of(smallest));
  };
  engine::SolverStep smallest = flight::shrink(step, fails, show);
  smallest.outcome.why = options.work ? "work above " + std::to_string(*options.work) : "it does not converge";
  smallest.outcome.why += ", made smaller";
  std::fprintf(stderr, "\r%40s\r", "");
  engine::save_solver_step(smallest, options.shrink_to);
  std::printf("%zu of %zu parts are left: %s\n", flight::size_of(smallest), flight::size_of(step),
              options.shrink_to.c_str());
}

void run(const Options& options) {
  const engine::SolverStep step = engine::load_solver_step(options.file);
  flight::Replay replay(step);
  if (options.code) {
    replay.run();
    const std::int64_t work = options.work.value_or(replay.total().work);
    std::fputs(flight::code_of(step, work).c_str(), stdout);
    return;
  }
  if (!options.shrink_to.empty()) {
    shrink(step, options);
    return;
  }
  flight::print_step(step);
  flight::print_replay(step, replay);
  if (options.profile) flight::print_profile(replay, options.repeats);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Takes a recorded step of the direct solver again."};
  Options options;
  app.add_option("file", options.file, "The step, as ropeswing --record-bad-ticks writes it")->required();
  auto* profile = app.add_flag("--profile", options.profile, "Also say how long it takes");
  app.add_option("--repeats", options.repeats, "How often it is taken for that; 25 unless given")
      ->check(CLI::Range(1, 1'000'000))
      ->needs(profile);
  auto* shrink_to = app.add_option("--shrink", options.shrink_to,
                                   "Write the smallest step that still does not converge, or does too much work");
  app.add_option("--work", options.work, "What is too much work: more than that")
      ->check(CLI::Range(std::int64_t{0}, std::int64_t{1'000'000'000'000}));
  app.add_flag("--code", options.code, "Print it as a test in C++, which wants no more work than --work, or than now")
      ->excludes(shrink_to)
      ->excludes(profile);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    run(options);
    if (std::fflush(stdout) != 0) throw std::runtime_error("cannot write the output");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "flight: %s\n", error.what());
    return 2;
  }
  return 0;
}
