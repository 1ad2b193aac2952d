#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <fstream>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "tests/extremes/any_scene/code.h"
#include "tests/extremes/any_scene/plot.h"
#include "tests/extremes/any_scene/runs.h"
#include "tests/extremes/any_scene/shrink.h"
#include "tests/extremes/any_scene/statistics.h"
#include "tests/study/shard.h"

namespace {

using any_scene::Family;
using any_scene::Preset;
using any_scene::SceneId;

struct Options {
  std::string seeds = "0-19";
  std::string family = "all";
  std::string preset = "all";
  bool wild = false;
  std::string out;
  std::string plot;
  std::string before;
  study::Shard shard;
  int show = -1;
  int shrink = -1;
  std::string figure;
  int code = -1;
  any_scene::RunOptions run;
};

/// Parses "7" or "0-999".
std::pair<unsigned, unsigned> range_of(const std::string& seeds) {
  const std::size_t dash = seeds.find('-');
  const auto first = static_cast<unsigned>(std::stoul(seeds));
  return {first, dash == std::string::npos ? first : static_cast<unsigned>(std::stoul(seeds.substr(dash + 1)))};
}

std::vector<SceneId> wanted(const Options& options, unsigned first, unsigned last) {
  std::vector<SceneId> scenes;
  for (unsigned seed = first; seed <= last; ++seed) {
    for (const Family family : any_scene::all_families) {
      if (options.family != "all" && options.family != name(family)) continue;
      SceneId which{seed, family, options.wild ? any_scene::Difficulty::wild : any_scene::Difficulty::gentle, {}};
      if (options.preset == "all") scenes.push_back(which);
      for (const Preset preset : any_scene::all_presets) {
        if (options.preset != name(preset) && (options.preset != "each" || preset == Preset::ample)) continue;
        which.preset = preset;
        scenes.push_back(which);
      }
    }
  }
  return scenes;
}

/// Returns the sort key of a run.
std::tuple<unsigned, Family, any_scene::Difficulty, Preset> key(const SceneId& which) {
  return {which.seed, which.family, which.difficulty, which.preset.value_or(static_cast<Preset>(which.seed % 3))};
}

std::vector<any_scene::Summary> read(const std::string& path) {
  std::vector<any_scene::Summary> runs;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("family,", 0) != 0) runs.push_back(any_scene::from_csv(line));
  }
  return runs;
}

using Keys = std::set<decltype(key({}))>;

/// Returns the requested runs of the earlier solver.
std::vector<any_scene::Summary> of_before(const Options& options, const Keys& asked) {
  std::vector<any_scene::Summary> runs;
  if (options.before.empty()) return runs;
  for (const any_scene::Summary& run : read(options.before)) {
    if (asked.count(key(run.which)) != 0) runs.push_back(run);
  }
  return runs;
}

/// Runs the scenes that the file lacks, appends them, prints the table of all requested runs, and plots them.
void run(const Options& options) {
  const auto [first, last] = range_of(options.seeds);
  std::vector<SceneId> scenes;
  const std::vector<SceneId> all = wanted(options, first, last);
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (options.shard.has(k, all.size())) scenes.push_back(all[k]);
  }
  Keys asked;
  for (const SceneId& which : scenes) asked.insert(key(which));
  std::vector<any_scene::Summary> runs;
  Keys there;
  for (const any_scene::Summary& done : options.out.empty() ? std::vector<any_scene::Summary>{} : read(options.out)) {
    if (there.insert(key(done.which)).second && asked.count(key(done.which)) != 0) runs.push_back(done);
  }
  std::vector<SceneId> left;
  for (const SceneId& which : scenes) {
    if (there.count(key(which)) == 0) left.push_back(which);
  }
  std::ofstream out;
  if (!options.out.empty()) {
    out.open(options.out, std::ios::app);
    if (there.empty() && options.shard.is_first()) out << any_scene::csv_header() << '\n';
  }
  any_scene::run_all(left, options.run, [&](const any_scene::Summary& summary) {
    runs.push_back(summary);
    if (out.is_open()) out << to_csv(summary) << std::endl;
    if (runs.size() % 50 == 0) std::fprintf(stderr, "\r%zu of %zu", runs.size(), scenes.size());
  });
  print_table(runs);
  print_histogram(runs);
  if (!options.plot.empty()) draw(runs, of_before(options, asked), options.plot);
}

void show(const Options& options) {
  const auto seed = static_cast<unsigned>(options.show);
  for (const SceneId& which : wanted(options, seed, seed)) {
    std::printf("%s, seed %u, %s\n", std::string(name(which.family)).c_str(), seed,
                std::string(name(generate(which).preset)).c_str());
    print_ticks(any_scene::play(generate(which), 1e9));
  }
}

void print_code(const Options& options) {
  const auto seed = static_cast<unsigned>(options.code);
  for (const SceneId& which : wanted(options, seed, seed)) {
    std::printf("%s", any_scene::to_code(generate(which), "scene").c_str());
  }
}

/// Returns the requested figure's limit, or the first limit that the run exceeds.
const any_scene::Limit* exceeded_limit(const Options& options, const any_scene::Summary& run) {
  if (options.figure.empty()) return first_exceeded(run);
  for (const any_scene::Limit& limit : any_scene::limits()) {
    if (limit.figure == options.figure && !(limit.value(run) <= limit.most)) return &limit;
  }
  return nullptr;
}

void shrink(const Options& options) {
  const auto seed = static_cast<unsigned>(options.shrink);
  for (const SceneId& which : wanted(options, seed, seed)) {
    const any_scene::Scene scene = generate(which);
    const auto play = [&](const any_scene::Scene& played) {
      return any_scene::run_guarded(which, played, options.run.max_seconds);
    };
    const any_scene::Limit* limit = exceeded_limit(options, play(scene));
    const std::string family(name(which.family));
    if (limit == nullptr) {
      std::printf("// %s, seed %u: nothing is above its limit\n", family.c_str(), seed);
      continue;
    }
    const bool clear = which.difficulty == any_scene::Difficulty::gentle;
    const any_scene::Scene small = any_scene::shrink(scene, [&](const any_scene::Scene& played) {
      return (!clear || any_scene::starts_clear(played)) && !(limit->value(play(played)) <= limit->most);
    });
    std::printf("// %s, seed %u: %s is %g, above %g\n%s", family.c_str(), seed, std::string(limit->figure).c_str(),
                limit->value(play(small)), limit->most, any_scene::to_code(small, "shrunk_scene").c_str());
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Scenes made at random by seed: plays them and prints what became of them, by family and preset"};
  Options options;
  std::vector<std::string> families = {"all"};
  for (const Family family : any_scene::all_families) families.emplace_back(name(family));
  std::vector<std::string> figures;
  for (const any_scene::Limit& limit : any_scene::limits()) figures.emplace_back(limit.figure);
  app.add_option("--seeds", options.seeds, "SEED or FIRST-LAST");
  app.add_option("--family", options.family, "One family")->check(CLI::IsMember(families));
  app.add_option("--preset", options.preset,
                 "fast, balanced, accurate, ample (balanced with a budget of work of 20,000); all: one of the first "
                 "three a seed; each: these three a seed")
      ->check(CLI::IsMember({"fast", "balanced", "accurate", "ample", "all", "each"}));
  app.add_flag("--wild,!--gentle", options.wild,
               "With overlaps, kinematic bodies, drags, reels, climbers, motors and speed");
  app.add_option("--out,--csv", options.out, "Appends a line of CSV a scene, and skips what is there");
  auto* plot = app.add_option("--plot", options.plot, "Draws work and what was left unsolved into this .svg file");
  app.add_option("--before", options.before, "A file of --out, of another solver, that is drawn beside")
      ->needs(plot)
      ->check(CLI::ExistingFile);
  app.add_option_function<std::string>(
      "--shard", [&options](const std::string& text) { options.shard = study::shard_of(text); },
      "K/N: only the K-th of N parts of the scenes; with --jobs 1, the files of --out, one behind the other, are that "
      "of all");
  app.add_option("--jobs", options.run.jobs, "Scenes at a time");
  app.add_option("--max-seconds-per-scene", options.run.max_seconds, "Time limit of a scene");
  app.add_option("--show", options.show, "Plays the scene of this seed and prints each tick; takes one --family");
  app.add_option("--code", options.code, "Prints the scene of this seed as C++");
  app.add_option("--shrink", options.shrink,
                 "Makes the scene of this seed as small as still fails, and prints it as C++");
  app.add_option("--figure", options.figure, "That is above its limit in what --shrink looks for; otherwise the first")
      ->check(CLI::IsMember(figures));
  try {
    app.parse(argc, argv);
    if (options.show >= 0) {
      show(options);
    } else if (options.code >= 0) {
      print_code(options);
    } else if (options.shrink >= 0) {
      shrink(options);
    } else {
      run(options);
    }
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "any_scene: %s\n", error.what());
    return 2;
  }
  return 0;
}
