#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <fstream>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "tests/extremes/any_scene/runs.h"
#include "tests/extremes/any_scene/statistics.h"

namespace {

using any_scene::Family;
using any_scene::Preset;
using any_scene::Which;

struct Options {
  std::string seeds = "0-19";
  std::string family = "all";
  std::string preset = "all";
  bool wild = false;
  std::string out;
  int show = -1;
  any_scene::RunOptions run;
};

/// "7" or "0-999".
std::pair<unsigned, unsigned> range_of(const std::string& seeds) {
  const std::size_t dash = seeds.find('-');
  const auto first = static_cast<unsigned>(std::stoul(seeds));
  return {first, dash == std::string::npos ? first : static_cast<unsigned>(std::stoul(seeds.substr(dash + 1)))};
}

std::vector<Which> wanted(const Options& options, unsigned first, unsigned last) {
  std::vector<Which> scenes;
  for (unsigned seed = first; seed <= last; ++seed) {
    for (const Family family : any_scene::all_families) {
      if (options.family != "all" && options.family != name(family)) continue;
      Which which{seed, family, options.wild ? any_scene::Mood::wild : any_scene::Mood::gentle, {}};
      if (options.preset == "all") scenes.push_back(which);
      for (const Preset preset : {Preset::fast, Preset::balanced, Preset::accurate}) {
        if (options.preset != name(preset) && options.preset != "each") continue;
        which.preset = preset;
        scenes.push_back(which);
      }
    }
  }
  return scenes;
}

/// What tells one run from another.
std::tuple<unsigned, Family, any_scene::Mood, Preset> key(const Which& which) {
  return {which.seed, which.family, which.mood, which.preset.value_or(static_cast<Preset>(which.seed % 3))};
}

std::vector<any_scene::Summary> read(const std::string& path) {
  std::vector<any_scene::Summary> runs;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    if (line != any_scene::csv_header()) runs.push_back(any_scene::from_csv(line));
  }
  return runs;
}

/// Runs what is not in the file yet, appends it, and prints the table of all that was asked for.
void run(const Options& options) {
  const auto [first, last] = range_of(options.seeds);
  const std::vector<Which> scenes = wanted(options, first, last);
  std::set<decltype(key(scenes[0]))> asked;
  for (const Which& which : scenes) asked.insert(key(which));
  std::vector<any_scene::Summary> runs;
  std::set<decltype(key(scenes[0]))> there;
  for (const any_scene::Summary& done : options.out.empty() ? std::vector<any_scene::Summary>{} : read(options.out)) {
    if (there.insert(key(done.which)).second && asked.count(key(done.which)) != 0) runs.push_back(done);
  }
  std::vector<Which> left;
  for (const Which& which : scenes) {
    if (there.count(key(which)) == 0) left.push_back(which);
  }
  std::ofstream out;
  if (!options.out.empty()) {
    out.open(options.out, std::ios::app);
    if (there.empty()) out << any_scene::csv_header() << '\n';
  }
  any_scene::run_all(left, options.run, [&](const any_scene::Summary& summary) {
    runs.push_back(summary);
    if (out.is_open()) out << to_csv(summary) << std::endl;
    if (runs.size() % 50 == 0) std::fprintf(stderr, "\r%zu of %zu", runs.size(), scenes.size());
  });
  print_table(runs);
  print_histogram(runs);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Scenes made at random by seed: plays them and prints what became of them, by family and preset"};
  Options options;
  std::vector<std::string> families = {"all"};
  for (const Family family : any_scene::all_families) families.emplace_back(name(family));
  app.add_option("--seeds", options.seeds, "SEED or FIRST-LAST");
  app.add_option("--family", options.family, "One family")->check(CLI::IsMember(families));
  app.add_option("--preset", options.preset, "fast, balanced, accurate; all: one a seed; each: all three a seed")
      ->check(CLI::IsMember({"fast", "balanced", "accurate", "all", "each"}));
  app.add_flag("--wild,!--gentle", options.wild, "With overlaps, kinematic bodies, drags, reels, climbers and speed");
  app.add_option("--out,--csv", options.out, "Appends a line of CSV a scene, and skips what is there");
  app.add_option("--jobs", options.run.jobs, "Scenes at a time");
  app.add_option("--max-seconds-per-scene", options.run.max_seconds, "After which a scene is cut");
  app.add_option("--show", options.show, "Plays the scene of this seed and prints each tick; takes one --family");
  CLI11_PARSE(app, argc, argv);
  try {
    if (options.show < 0) {
      run(options);
      return 0;
    }
    const auto seed = static_cast<unsigned>(options.show);
    for (const Which& which : wanted(options, seed, seed)) {
      std::printf("%s, seed %u\n", std::string(name(which.family)).c_str(), seed);
      print_ticks(play(generate(which), 1e9));
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "any_scene: %s\n", error.what());
    return 2;
  }
  return 0;
}
