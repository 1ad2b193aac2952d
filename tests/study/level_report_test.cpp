#include "tests/study/level_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "engine/replay/replay.h"
#include "tests/study/command.h"
#include "tests/study/level_study_fixture.h"
#include "tests/study/plot.h"
#include "tests/study/report.h"
#include "tests/support/refusal.h"

// The report of a study: files, pages, groups and plots.

namespace study {
namespace {

using test_support::refusal;

TEST_F(LevelStudy, TheReportHasAColumnOfEveryKindOfError) {
  Command command;
  command.level = level_path;
  command.replay = replay_path;
  command.folder = home + "/report";
  command.quick = true;
  command.repeats = 1;
  refusal<std::exception>([&] { run(command); });  // without gnuplot it throws because of the plots
  const std::string csv = read_file(command.folder + "/points.csv");
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    rows.push_back(csv_cells(line));
  }
  ASSERT_EQ(rows.size(), 1 + grid(true).size());
  for (const std::string name : {"tension", "penetration", "energy", "momentum"}) {
    const auto column = static_cast<std::size_t>(std::find(rows[0].begin(), rows[0].end(), name) - rows[0].begin());
    ASSERT_LT(column, rows[0].size()) << name;
    for (const auto& row : rows) {
      ASSERT_EQ(row.size(), rows[0].size());
      const bool lacks = row[0] == "thesis" ? name != "momentum" : row[0].starts_with("box2d") && name != "penetration";
      EXPECT_EQ(row[column].empty(), lacks) << row[1] << ' ' << name;
    }
  }
  EXPECT_NE(csv.find("chaotic_height_m,chaotic_height_sd_m,chaotic_stretch,chaotic_peak_stretch"), std::string::npos);
}

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
  const std::string complaint = refusal<std::exception>([&] { write_report(report, folder); });
  EXPECT_EQ(complaint == "no error", can_plot()) << complaint;
  EXPECT_EQ(read_file(folder + "/points.csv"),
            "method,setting,cost_us,p99_us,error_m,failure,group,stretch\ndirect,fast,1,2,0.1,,,0.1\n"
            "chain,slow,50,60,0.2,,,0.2\nchain,worse,5,6,,blew up in tick 3,,0.3\n");
  EXPECT_NE(read_file(folder + "/points.json").find("\"front\": true"), std::string::npos);
  const std::string page = read_file(folder + "/index.html");
  EXPECT_NE(page.find("a &lt;scene&gt;"), std::string::npos);
  EXPECT_NE(page.find("<tr class=\"failed\"><td>chain<td>worse"), std::string::npos);
  if (complaint == "no error") {
    EXPECT_NE(read_file(folder + "/front.svg").find("<svg"), std::string::npos);
  }
}

TEST_F(LevelStudy, AFolderMayHaveAnyName) {
  const std::string folder = home + "/it's; a $(name) & more";
  const std::string complaint = refusal<std::exception>([&] { write_report(small_report(), folder); });
  EXPECT_EQ(complaint == "no error", can_plot()) << complaint;
  EXPECT_TRUE(fs::exists(folder + "/front.svg") || fs::exists(folder + "/gnuplot.log"));
}

TEST_F(LevelStudy, WithoutAPlottingProgramTheNumbersAreWritten) {
  const std::string folder = home + "/report";
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", home.c_str(), 1);
  const std::string complaint = refusal<std::exception>([&] { write_report(small_report(), folder); });
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_NE(complaint.find("gnuplot-nox"), std::string::npos) << complaint;
  EXPECT_FALSE(read_file(folder + "/points.csv").empty());
  EXPECT_FALSE(read_file(folder + "/index.html").empty());
}

TEST_F(LevelStudy, WithoutAPlottingProgramAllPagesAreWrittenWithOneMessage) {
  const auto page = [&](const std::string& name) {
    return Page{name, [this, name] {
                  write_report(small_report(), home + "/" + name);
                  return 0;
                }};
  };
  std::vector<std::string> added;
  const auto add = [&added](const std::vector<std::string>& done) { added = done; };
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", home.c_str(), 1);
  testing::internal::CaptureStderr();
  const int status = write_pages({page("first"), page("second")}, add);
  const std::string complaint = testing::internal::GetCapturedStderr();
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(status, 1);
  EXPECT_EQ(added, (std::vector<std::string>{"first", "second"}));
  for (const std::string& name : added) EXPECT_FALSE(read_file(home + "/" + name + "/points.csv").empty()) << name;
  EXPECT_NE(complaint.find("of first, second (see gnuplot.log"), std::string::npos) << complaint;
  EXPECT_NE(complaint.find("game/setup tests installs it"), std::string::npos);
  EXPECT_EQ(complaint.find("gnuplot-nox"), complaint.rfind("gnuplot-nox"));
}

TEST(Report, WritingStopsAtTheFirstPageThatFails) {
  std::vector<std::string> added;
  const auto add = [&added](const std::vector<std::string>& done) { added = done; };
  const auto page = [](const std::string& name, int status) { return Page{name, [status] { return status; }}; };
  EXPECT_EQ(write_pages({page("first", 0), page("second", 0)}, add), 0);
  EXPECT_EQ(added.size(), 2U);
  EXPECT_EQ(write_pages({page("first", 0), page("second", 1), page("third", 0)}, add), 1);
  EXPECT_EQ(added, std::vector<std::string>{"first"});
  const auto full = [] { return Page{"full", []() -> int { throw std::runtime_error("cannot write"); }}; };
  EXPECT_THROW(write_pages({full()}, add), std::runtime_error);
}

TEST_F(LevelStudy, GroupsOfAReportAreSeparate) {
  Report report = small_report();
  report.points[1].group = "heavy & slow";
  report.axis = "depth";
  const std::string folder = home + "/report";
  const std::string complaint = refusal<std::exception>([&] { write_report(report, folder); });
  EXPECT_EQ(complaint == "no error", can_plot()) << complaint;
  const std::string page = read_file(folder + "/index.html");
  const std::size_t heading =
      page.find("<tr><th colspan=\"6\">heavy &amp; slow\n<tr class=\"front\"><td>chain<td>slow");
  EXPECT_NE(heading, std::string::npos) << page;
  EXPECT_LT(page.find("<td>worse"), heading);  // beside the reference of the comparison
  EXPECT_NE(page.find("<th>depth"), std::string::npos);
  EXPECT_NE(read_file(folder + "/points.csv").find("\nchain,slow,50,60,0.2,,heavy & slow,"), std::string::npos);
  const std::string plot = read_file(folder + "/front.gp");
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
