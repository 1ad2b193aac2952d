#include "tests/tradeoff/standard_report.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "game/simulation/level.h"
#include "tests/study/command.h"
#include "tests/study/progress_bar.h"
#include "tests/study/report.h"
#include "tests/tradeoff/run_scene.h"
#include "tests/tradeoff/scene_report.h"
#include "tests/tradeoff/table.h"

namespace tradeoff {
namespace {

std::vector<std::string> scene_names(bool quick) {
  std::vector<std::string> names = {"heavy_swing", "held_swing", "drape", "bridge", "coil_short", "strips_short"};
  if (!quick) names.insert(names.end(), {"thesis_trade", "capstan", "mass_ratio"});
  return names;
}

void write_contents(const StandardReport& report, const std::vector<std::string>& done, std::size_t all) {
  std::vector<std::string> notes = {
      "Each mark is one setting of one method; the line joins those that no other is both cheaper and more exact than, "
      "among those that simulate the same. Each page has its numbers and further kinds of error.",
      "coil_short and strips_short are the first moments of scenes that take minutes: tradeoff --scene coil, and "
      "--scene strips."};
  if (report.quick) {
    notes.emplace_back(
        "A quick report: levels are tried with a small grid, scenes without their slowest settings, and thesis_trade, "
        "capstan and mass_ratio are left out.");
  }
  if (done.size() < all) {
    notes.push_back("Not finished: " + std::to_string(done.size()) + " of " + std::to_string(all) +
                    " pages. The same command runs scenes again, and continues in the level where it stopped.");
  }
  study::write_contents("Error against cost", notes, done, report.folder);
}

void write_scene(const StandardReport& report, const Scene& scene) {
  std::vector<Variant> variants = scene.variants();
  std::string left_out;
  if (report.quick) {
    for (const std::string& setting : scene.slow) left_out += (left_out.empty() ? "" : ", ") + setting;
    const auto is_slow = [&](const Variant& c) {
      return std::find(scene.slow.begin(), scene.slow.end(), c.setting) != scene.slow.end();
    };
    variants.erase(std::remove_if(variants.begin(), variants.end(), is_slow), variants.end());
  }
  const std::vector<Row> rows =
      run_scene(scene, variants, report.repeats.value_or(report.quick ? 1 : scene.report_repeats));
  print_table(scene, rows);
  study::Report page = report_of(scene, rows);
  if (!left_out.empty()) page.notes.push_back("A quick report: settings left out are " + left_out + ".");
  study::write_report(page, report.folder + "/" + scene.name);
}

int write_level(const StandardReport& report, const std::string& level) {
  study::Command command;
  command.level = level;
  command.quick = report.quick;
  command.repeats = report.repeats;
  if (report.quick && !command.repeats) command.repeats = 1;
  command.folder = report.folder + "/" + level;
  return study::run(command);
}

}  // namespace

int write(const StandardReport& report) {
  if (report.folder.empty()) throw std::runtime_error("--report needs a folder to write to; accepted is --out FOLDER");
  study::require_folder(report.folder);
  const std::vector<std::string> scenes = scene_names(report.quick);
  const std::vector<std::string> levels = game::level_names();
  std::vector<study::Page> pages;
  for (const std::string& name : scenes) {
    pages.push_back({name, [&report, name] {
                       write_scene(report, *find_scene(name));
                       return 0;
                     }});
  }
  for (const std::string& level : levels) {
    pages.push_back({level, [&report, level] { return write_level(report, level); }});
  }
  std::vector<study::Page> own;
  std::vector<std::string> all;
  for (std::size_t k = 0; k < pages.size(); ++k) {
    if (report.shard.has(k, pages.size())) own.push_back(pages[k]);
    all.push_back(pages[k].name);
  }
  const int status = study::write_pages(own, [&](const std::vector<std::string>& done) {
    write_contents(report, report.shard.is_whole() ? done : all, all.size());
    study::show_progress("report", static_cast<double>(done.size()) / static_cast<double>(own.size()));
  });
  std::printf("report: %s/index.html\n", report.folder.c_str());
  return status;
}

}  // namespace tradeoff
