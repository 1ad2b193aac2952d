#include "tests/study/level_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "engine/replay.h"
#include "tests/study/command.h"
#include "tests/study/plot.h"
#include "tests/study/report.h"
#include "tests/study/terms.h"
#include "tests/study/words.h"

namespace study {
namespace {

namespace fs = std::filesystem;

/// A folder of the test's own, with a copy of a level and a replay in which nobody does anything.
class LevelStudy : public testing::Test {
 protected:
  LevelStudy() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    home = testing::TempDir() + "study_" + info->name();
    fs::remove_all(home);
    fs::create_directories(home);
    level_path = home + "/swing.tmj";
    fs::copy_file(TEST_ASSETS "/levels/first_swing.tmj", level_path);
    replay_path = home + "/swing.replay";
    record(replay_path, 20);
  }
  ~LevelStudy() override { fs::remove_all(home); }

  void record(const std::string& path, int ticks) const {
    const game::Level level = game::load_level(level_path);
    engine::ReplayWriter writer(path, game::Simulation::replay_header(level));
    game::Simulation simulation(level);
    for (int k = 0; k < ticks; ++k) {
      simulation.tick({});
      writer.write({}, simulation.hash());
    }
    writer.finish();
  }

  StudyOptions options() const {
    StudyOptions options;
    options.quick = true;
    options.repeats = 1;
    options.folder = home + "/report";
    return options;
  }

  std::string home, level_path, replay_path;
};

std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

TEST(Dials, NoSettingOfAGridStandsInItTwice) {
  for (const bool quick : {false, true}) {
    std::set<std::string> names;
    for (const Dials& dials : grid(quick)) EXPECT_TRUE(names.insert(dials.solver + name_of(dials)).second);
    EXPECT_GE(names.size(), quick ? 8U : 25U);
  }
}

TEST_F(LevelStudy, ALevelTakesTheDialsAndNothingElse) {
  const LevelFile file(level_path);
  const game::Level level = file.with({"direct", "implicit_euler", 3, 1e-6, 2.0});
  const auto changed = level.make_scene();
  const auto before = file.level().make_scene();
  for (int c = 0; c < changed->coupling().size(); ++c) {
    const ribbon::CordDef& def = changed->coupling().direct_cord(c).def();
    const ribbon::CordDef& old = before->coupling().direct_cord(c).def();
    EXPECT_EQ(def.accuracy.integrator, ribbon::Integrator::implicit_euler);
    EXPECT_EQ(def.accuracy.substeps, 3);
    EXPECT_EQ(def.accuracy.tolerance, 1e-6);
    EXPECT_EQ(def.points - 1, 2 * (old.points - 1));
    EXPECT_EQ(def.friction, old.friction);
    EXPECT_EQ(def.bending_stiffness, old.bending_stiffness);
  }
  const auto thesis = file.with({"thesis", "", 4, 0.0}).make_scene();
  EXPECT_EQ(thesis->coupling().solver(0), engine::Solver::thesis);
  EXPECT_EQ(thesis->coupling().cord(0).def().substeps, 4);
}

TEST_F(LevelStudy, WhatIsAppliedStandsInTheFile) {
  LevelFile(level_path).apply({"direct", "tr_bdf2", 2, 1e-5});
  const auto scene = game::load_level(level_path).make_scene();
  EXPECT_EQ(scene->coupling().direct_cord(0).def().accuracy.substeps, 2);
  EXPECT_EQ(scene->coupling().direct_cord(0).def().accuracy.tolerance, 1e-5);
  EXPECT_EQ(LevelFile(level_path).declares("friction"), true);
  const std::string before = content_of(level_path);
  EXPECT_THROW(LevelFile(level_path).apply({"direct", "tr_bdf2", 0, 1e-5}), engine::MapError);
  EXPECT_EQ(content_of(level_path), before);
}

TEST_F(LevelStudy, MoreSubstepsAndLessToleranceAreMoreExact) {
  const Study study = measure(LevelFile(level_path), replay_path, options());
  ASSERT_TRUE(study.complete);
  const auto error_of = [&](const Dials& dials) {
    const auto found =
        std::find_if(study.settings.begin(), study.settings.end(), [&](const Measured& m) { return m.dials == dials; });
    return found->error.position_m;
  };
  const double one = error_of({});
  const double four = error_of({"direct", "tr_bdf2", 4, 1e-4});
  EXPECT_NEAR(std::log(one / four) / std::log(4.0), 2.0, 0.4);  // its order
  const double euler = error_of({"direct", "implicit_euler", 1, 5e-4});
  const double euler_four = error_of({"direct", "implicit_euler", 4, 5e-4});
  EXPECT_NEAR(std::log(euler / euler_four) / std::log(4.0), 1.0, 0.2);
  EXPECT_LT(study.references[0].agreement_m, 0.1 * four);
  for (const Measured& m : study.settings) {
    EXPECT_GT(m.cost_us, 0.0);
    EXPECT_GE(m.point().error_m, m.known_to_m);
  }
}

TEST_F(LevelStudy, WhoIsInterruptedGoesOnWhereHeWas) {
  StudyOptions stops = options();
  int asked = 0;
  stops.stopped = [&asked] { return ++asked > 15; };
  const Study half = measure(LevelFile(level_path), replay_path, stops);
  EXPECT_FALSE(half.complete);
  ASSERT_GT(half.settings.size(), 0U);
  const std::string path = options().folder + "/results.jsonl";
  const std::string kept = content_of(path);
  EXPECT_EQ(static_cast<std::size_t>(std::count(kept.begin(), kept.end(), '\n')), half.settings.size());

  std::ofstream(path, std::ios::app) << "{\"key\": \"half a li";
  std::ofstream(path, std::ios::app) << '\n';
  const Study whole = measure(LevelFile(level_path), replay_path, options());
  EXPECT_TRUE(whole.complete);
  EXPECT_EQ(whole.settings.size(), grid(true).size());
  for (std::size_t k = 0; k < half.settings.size(); ++k) {
    EXPECT_EQ(whole.settings[k].error.position_m, half.settings[k].error.position_m);
  }
  EXPECT_EQ(content_of(path).find(kept), 0U);  // nothing was measured again
  const std::string all = content_of(path);
  EXPECT_EQ(static_cast<std::size_t>(std::count(all.begin(), all.end(), '\n')), grid(true).size() + 1);
}

TEST_F(LevelStudy, RefusesWhatItCannotMeasure) {
  const LevelFile file(level_path);
  record(home + "/none.replay", 0);
  EXPECT_NE(message_of([&] { measure(file, home + "/none.replay", options()); }).find("has no ticks"),
            std::string::npos);
  EXPECT_NE(message_of([&] { measure(file, home + "/absent.replay", options()); }).find("absent.replay"),
            std::string::npos);
  StudyOptions nowhere = options();
  nowhere.folder = level_path + "/inside";
  EXPECT_NE(message_of([&] { measure(file, replay_path, nowhere); }).find("cannot write to"), std::string::npos);
  Command command;
  command.level = level_path;
  EXPECT_NE(message_of([&] { run(command); }).find("no --replay given"), std::string::npos);
  EXPECT_NE(message_of([&] { LevelFile(home + "/absent.tmj"); }).find("absent.tmj"), std::string::npos);
}

TEST_F(LevelStudy, ATermThatNothingNeedsIsTold) {
  const Terms terms = try_terms(LevelFile(level_path), replay_path, [](double) {});
  const auto result = [&](const std::string& term) {
    return *std::find_if(terms.declared.begin(), terms.declared.end(), [&](const auto& r) { return r.term == term; });
  };
  EXPECT_EQ(result("cord_contact").shows_at, 0U);  // its cords do not meet in a third of a second
  EXPECT_EQ(result("cord_contact").change.greatest_length(), 0.0);
  EXPECT_NE(verdict(result("cord_contact")).find("not needed"), std::string::npos);
  EXPECT_GT(result("bending_stiffness").shows_at, 0U);
  EXPECT_NE(verdict(result("bending_stiffness")).find("from tick"), std::string::npos);
  EXPECT_TRUE(terms.lacking.empty());
}

// --- the report --------------------------------------------------------------------------------------------------

bool can_plot() { return std::system("gnuplot --version > /dev/null 2>&1") == 0; }

Report small_report() {
  Report report;
  report.title = "a <scene>";
  report.notes = {"A note."};
  report.points = {{"direct", "fast", 1.0, 2.0, 0.1, ""},
                   {"chain", "slow", 50.0, 60.0, 0.2, ""},
                   {"chain", "worse", 5.0, 6.0, 0.2, "blew up in tick 3"}};
  report.columns = {"stretch"};
  report.cells = {{"0.1"}, {"0.2"}, {"0.3"}};
  return report;
}

TEST_F(LevelStudy, AReportHasEverySettingInEveryFile) {
  const std::string folder = home + "/report";
  const Report report = small_report();
  const std::string complaint = message_of([&] { write_report(report, folder); });
  EXPECT_EQ(complaint.empty(), can_plot()) << complaint;
  EXPECT_EQ(content_of(folder + "/points.csv"),
            "group,method,setting,cost_us,p99_us,error_m,failure,stretch\n,direct,fast,1,2,0.1,,0.1\n"
            ",chain,slow,50,60,0.2,,0.2\n,chain,worse,5,6,,blew up in tick 3,0.3\n");
  EXPECT_NE(content_of(folder + "/points.json").find("\"front\": true"), std::string::npos);
  const std::string page = content_of(folder + "/index.html");
  EXPECT_NE(page.find("a &lt;scene&gt;"), std::string::npos);
  EXPECT_NE(page.find("<tr class=\"failed\"><td>chain<td>worse"), std::string::npos);
  if (complaint.empty()) {
    EXPECT_NE(content_of(folder + "/front.svg").find("<svg"), std::string::npos);
  }
}

TEST_F(LevelStudy, AFolderMayHaveAnyName) {
  const std::string folder = home + "/it's; a $(name) & more";
  const std::string complaint = message_of([&] { write_report(small_report(), folder); });
  EXPECT_EQ(complaint.empty(), can_plot()) << complaint;
  EXPECT_TRUE(fs::exists(folder + "/front.svg") || fs::exists(folder + "/gnuplot.log"));
}

TEST_F(LevelStudy, WithoutAPlottingProgramTheNumbersAreWritten) {
  const std::string folder = home + "/report";
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", home.c_str(), 1);
  const std::string complaint = message_of([&] { write_report(small_report(), folder); });
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_NE(complaint.find("gnuplot-nox"), std::string::npos) << complaint;
  EXPECT_FALSE(content_of(folder + "/points.csv").empty());
  EXPECT_FALSE(content_of(folder + "/index.html").empty());
}

TEST_F(LevelStudy, GroupsOfAReportStandApart) {
  Report report = small_report();
  report.points[1].group = "heavy & slow";
  report.axis = "depth";
  const std::string folder = home + "/report";
  const std::string complaint = message_of([&] { write_report(report, folder); });
  EXPECT_EQ(complaint.empty(), can_plot()) << complaint;
  const std::string page = content_of(folder + "/index.html");
  const std::size_t heading =
      page.find("<tr><th colspan=\"6\">heavy &amp; slow\n<tr class=\"front\"><td>chain<td>slow");
  EXPECT_NE(heading, std::string::npos) << page;
  EXPECT_LT(page.find("<td>worse"), heading);  // beside what it is compared with
  EXPECT_NE(page.find("<th>depth"), std::string::npos);
  EXPECT_NE(content_of(folder + "/points.csv").find("\nheavy & slow,chain,slow,"), std::string::npos);
  const std::string plot = content_of(folder + "/front.gp");
  EXPECT_NE(plot.find("$front_0 << END\n1 0.1\nEND"), std::string::npos) << plot;
  EXPECT_NE(plot.find("$front_1 << END\n50 0.2\nEND"), std::string::npos);
  EXPECT_NE(plot.find("set title 'heavy & slow'"), std::string::npos);
}

TEST(Report, FailuresAreDrawnAtTheTop) {
  const std::string plot = plot_of(small_report().points, "error [m]", "front");
  EXPECT_NE(plot.find("$failed1_0 << END\n5 0.8\nEND"), std::string::npos) << plot;
  EXPECT_NE(plot.find("$front_0 << END\n1 0.1\nEND"), std::string::npos);
}

}  // namespace
}  // namespace study
