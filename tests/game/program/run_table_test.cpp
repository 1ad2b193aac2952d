// The table of the recordings of a folder.

#include "game/program/run_table.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "engine/replay/replay.h"
#include "game/simulation/buttons.h"
#include "game/simulation/run_header.h"
#include "game/simulation/simulation.h"
#include "tests/game/program.h"
#include "tests/support/refusal.h"

namespace {

using namespace test_support;

const std::string replays = TEST_ASSETS "/replays/";

/// An empty folder of that name.
std::string folder(const std::string& name) {
  std::string path = scratch(name);
  fs::remove_all(path);
  fs::create_directories(path);
  return path;
}

/// The golden run with an input changed, and valid checksums.
void write_tampered(const std::string& path) {
  const engine::Replay replay = engine::load_replay(golden());
  engine::ReplayWriter writer(path, replay.header);
  for (std::size_t k = 0; k < replay.ticks.size(); ++k) {
    engine::TickInput input = replay.ticks[k].input;
    if (k == 100) input.buttons ^= game::button_right;
    writer.write(input, replay.ticks[k].state);
  }
  writer.finish();
}

/// The inputs of the golden run in a level with assists, after some ticks without input.
void write_run(const std::string& path, const game::Assists& assists, int wait) {
  const engine::Replay replay = engine::load_replay(golden());
  game::Level level = game::load_level("first_swing");
  level.assists = assists;
  game::Simulation simulation(level);
  engine::ReplayWriter writer(path, game::replay_header(level));
  const auto tick = [&](const engine::TickInput& input) {
    simulation.tick(input);
    writer.write(input, simulation.hash());
  };
  for (int k = 0; k < wait; ++k) tick({});
  for (const engine::RecordedTick& recorded : replay.ticks) tick(recorded.input);
  writer.finish();
}

const game::RunTable::Row& row(const game::RunTable& table, const std::string& file) {
  for (const game::RunTable::Row& found : table.rows) {
    if (found.file == file) return found;
  }
  ADD_FAILURE() << file << " is not in the table";
  return table.rows.front();
}

TEST(RunTable, RanksTrueRecordingsByLevelAndTime) {
  const std::string path = folder("true_runs");
  fs::copy_file(replays + "pump_it_up.replay", path + "/a.replay");
  fs::copy_file(golden(), path + "/c.replay");
  fs::copy_file(golden(), path + "/b.replay");
  write_run(path + "/late.replay", {}, 3);
  write_run(path + "/helped.replay", {std::nullopt, true}, 0);
  write_bytes(path + "/readme.txt", "");
  const game::RunTable table = game::table_of(path);
  EXPECT_TRUE(table.all_are_true()) << table.text();
  const int ticks = *row(table, "b.replay").time.ticks;
  EXPECT_EQ(row(table, "helped.replay").time.ticks, ticks);
  EXPECT_TRUE(row(table, "helped.replay").time.assisted);
  EXPECT_EQ(row(table, "helped.replay").time.medal, game::Medal::none);
  EXPECT_EQ(row(table, "b.replay").time.medal, game::Medal::gold);
  const std::string text = table.text();
  std::size_t last = 0;
  for (const char* const words :
       {"First swing\n    1 ", "Gold       b.replay\n    1 ", "Gold       c.replay\n", "with help  helped.replay\n",
        "Pump it up\n    1 ", "a.replay\n", "5 recordings are true; 1 other file\n"}) {
    const std::size_t at = text.find(words, last);
    ASSERT_NE(at, std::string::npos) << words << " in\n" << text;
    last = at;
  }
}

TEST(RunTable, NamesWhatIsNotTrueAndWhy) {
  const std::string path = folder("bad_runs");
  const std::string bytes = bytes_of(golden());
  fs::copy_file(golden(), path + "/true.replay");
  write_tampered(path + "/tampered.replay");
  write_bytes(path + "/cut.replay", bytes.substr(0, bytes.size() / 2));
  write_bytes(path + "/foreign.replay", "a letter\n");
  write_bytes(path + "/damaged.replay", std::string(bytes).replace(bytes.size() / 2, 1, "?"));
  fs::create_directories(path + "/folder.replay");
  engine::Replay unknown = engine::load_replay(golden());
  unknown.header.level = "nowhere";
  engine::ReplayWriter(path + "/unknown.replay", unknown.header).finish();
  engine::Replay other = engine::load_replay(golden());
  ++other.header.level_hash;
  engine::ReplayWriter(path + "/other.replay", other.header).finish();

  const game::RunTable table = game::table_of(path);
  EXPECT_FALSE(table.all_are_true());
  EXPECT_EQ(row(table, "true.replay").time.fault, "");
  const auto fault = [&](const std::string& file) { return row(table, file).time.fault; };
  EXPECT_EQ(fault("tampered.replay").rfind("tick 101: ", 0), 0U) << fault("tampered.replay");
  EXPECT_EQ(fault("cut.replay").rfind("cut short after ", 0), 0U) << fault("cut.replay");
  EXPECT_EQ(fault("foreign.replay").rfind("byte 0", 0), 0U) << fault("foreign.replay");
  EXPECT_EQ(fault("damaged.replay").rfind("byte ", 0), 0U) << fault("damaged.replay");
  EXPECT_NE(fault("folder.replay"), "");
  EXPECT_NE(fault("unknown.replay").find("nowhere"), std::string::npos) << fault("unknown.replay");
  EXPECT_NE(fault("other.replay").find("level hash"), std::string::npos) << fault("other.replay");
  EXPECT_NE(table.text().find("\n1 recording is true, 7 are not\n"), std::string::npos) << table.text();
}

/// A recording may have several runs, between restarts.
TEST(RunTable, TheBestRunOfARecordingCountsAndADraggedOneIsMarked) {
  const std::string path = folder("several_runs");
  const engine::Replay replay = engine::load_replay(golden());
  const game::Level level = game::load_level("first_swing");
  game::Simulation simulation(level);
  engine::ReplayWriter writer(path + "/several.replay", replay.header);
  engine::ReplayWriter dragged(path + "/dragged.replay", replay.header);
  const auto tick = [&](engine::TickInput input, int drag) {
    input.buttons |= static_cast<std::uint16_t>(drag);
    simulation.tick(input);
    writer.write(input, simulation.hash());
    if (simulation.ticks() <= static_cast<int>(replay.ticks.size())) dragged.write(input, simulation.hash());
  };
  for (std::size_t k = 0; k < replay.ticks.size(); ++k) tick(replay.ticks[k].input, k == 0 ? game::button_drag : 0);
  dragged.finish();
  engine::TickInput restart;
  restart.buttons = game::button_restart;
  tick(restart, 0);
  for (int k = 0; k < 5; ++k) tick({}, 0);
  for (const engine::RecordedTick& recorded : replay.ticks) tick(recorded.input, 0);
  writer.finish();
  const game::RunTable table = game::table_of(path);
  EXPECT_TRUE(table.all_are_true()) << table.text();
  EXPECT_TRUE(row(table, "dragged.replay").time.assisted);
  EXPECT_FALSE(row(table, "several.replay").time.assisted) << "the second run was without help";
}

TEST(RunTable, ReportsItsProgress) {
  const std::string path = folder("progress_runs");
  for (const char* const name : {"/a.replay", "/b.replay"}) fs::copy_file(golden(), path + name);
  double last = 0.0;
  game::table_of(path, [&last](double share) {
    EXPECT_GE(share, last);
    last = share;
  });
  EXPECT_EQ(last, 1.0);
}

TEST(TableProgram, ExitsWith0IfAllAreTrueAnd1OtherwiseAnd2WithoutAFolder) {
  const std::string path = folder("table_runs");
  const Ended none = ropeswing("--table " + path);
  EXPECT_EQ(none.status, 0);
  EXPECT_EQ(none.output, "0 recordings are true\n");
  fs::copy_file(golden(), path + "/a.replay");
  const Ended good = ropeswing("--table " + path);
  EXPECT_EQ(good.status, 0);
  EXPECT_EQ(good.output.rfind("First swing\n", 0), 0U) << good.output;
  EXPECT_EQ(good.output.find('\r'), std::string::npos) << "no progress bar in a pipe";
  EXPECT_EQ(ropeswing("--table " + path).output, good.output);
  write_tampered(path + "/b.replay");
  EXPECT_EQ(ropeswing("--table " + path).status, 1);
  const Ended missing = ropeswing("--table " + path + "/nowhere");
  EXPECT_EQ(missing.status, 2);
  EXPECT_NE(missing.output.find("/nowhere: cannot be read: "), std::string::npos) << missing.output;
  EXPECT_EQ(ropeswing("--table " + golden()).status, 2) << "a file";
  EXPECT_EQ(ropeswing("--table " + path + " --level first_swing").status, 2);
  EXPECT_EQ(ropeswing("--table ''").status, 2);
}

}  // namespace
