// Data between two games: bindings, settings, records and recordings.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/window/input_names.h"
#include "game/screens/help.h"
#include "game/screens/level_facts.h"
#include "game/screens/session.h"
#include "game/settings/records.h"
#include "game/settings/run_folder.h"
#include "game/settings/settings_file.h"
#include "game/settings/user_files.h"
#include "game/simulation/medals.h"
#include "tests/game/program.h"
#include "tests/support/environment.h"
#include "tests/support/files.h"
#include "tests/support/refusal.h"

namespace game {
namespace {

using engine::Key;
using engine::MouseButton;
using engine::PadButton;
using engine::WheelTurn;
using test_support::bytes_of;
using test_support::scratch;
using test_support::write_bytes;

TEST(Bindings, AHintNamesTheKeysThatAreBound) {
  Settings settings;
  const std::string hint = "hold {grab}, {jump} and {nothing}, {jump}";
  EXPECT_EQ(hint_in_words(hint, settings, false), "hold E, Space and {nothing}, Space");
  settings.bindings.bind(Action::grab, Key::space);
  settings.bindings.bind(Action::jump, Key::j);
  EXPECT_EQ(hint_in_words(hint, settings, false), "hold E, J and {nothing}, J");
  EXPECT_EQ(hint_in_words(hint, settings, true).find("{jump}"), std::string::npos);
}

/// With default keys and with a gamepad no hint or sign of a level has an unknown word.
TEST(Bindings, TheHintsAndSignsOfAllLevelsHaveNoUnknownWords) {
  for (const Level& level : levels_in_order()) {
    for (const bool pad : {false, true}) {
      const std::string words = hint_in_words(level.hint, Settings{}, pad);
      EXPECT_EQ(words.find_first_of("{}"), std::string::npos) << words;
      EXPECT_TRUE(level.sandbox || words.find("none") == std::string::npos) << words;
      for (const Sign& sign : level.signs) {
        const std::string text = hint_in_words(sign.text, Settings{}, pad);
        EXPECT_EQ(text.find_first_of("{}"), std::string::npos) << text;
        EXPECT_EQ(text.find("none"), std::string::npos) << text;
      }
    }
  }
}

TEST(Bindings, ACodeBelongsToOneActionOnly) {
  Bindings bindings = Bindings::defaults();
  EXPECT_EQ(bindings.action_of(Key::q), Action::reel_in);
  bindings.bind(Action::jump, Key::q);
  EXPECT_EQ(bindings.action_of(Key::q), Action::jump);
  EXPECT_EQ(bindings.action_of(Key::space), Action::jump) << "an action has any number of codes";
  bindings.bind(Action::jump, Key::q);
  EXPECT_EQ(bindings.codes(Action::jump).size(), Bindings::defaults().codes(Action::jump).size() + 1);
  bindings.unbind(Key::q);
  EXPECT_EQ(bindings.action_of(Key::q), std::nullopt);
}

TEST(Bindings, ByDefaultEveryActionHasAKeyAndNoneIsUsedTwice) {
  const Bindings bindings = Bindings::defaults();
  std::vector<engine::InputCode> seen;
  for (const Action action : all_actions()) {
    EXPECT_NE(codes_in_words(bindings, action, false), "none") << action_name(action);
    for (const engine::InputCode& code : bindings.codes(action)) {
      EXPECT_EQ(std::count(seen.begin(), seen.end(), code), 0) << engine::input_name(code);
      EXPECT_EQ(bindings.action_of(code), action);
      seen.push_back(code);
    }
  }
}

TEST(Bindings, EveryCodeHasAUniqueName) {
  const auto check = [](const engine::InputCode& code) {
    EXPECT_EQ(engine::input_of_name(engine::input_name(code)), code);
    EXPECT_FALSE(engine::input_title(code).empty());
  };
  for (std::size_t k = 0; k < engine::key_count; ++k) check(static_cast<Key>(k));
  for (std::size_t k = 0; k < engine::mouse_button_count; ++k) check(static_cast<MouseButton>(k));
  for (std::size_t k = 0; k < engine::wheel_turn_count; ++k) check(static_cast<WheelTurn>(k));
  for (std::size_t k = 0; k < engine::pad_button_count; ++k) check(static_cast<PadButton>(k));
  EXPECT_EQ(engine::input_of_name("key_nowhere"), std::nullopt);
}

Settings some_settings() {
  Settings settings;
  settings.toggle_grab = settings.long_reach = settings.no_fall = settings.reduced_motion = settings.colour_safe = true;
  settings.strain_tint = settings.fullscreen = settings.sound.muted = true;
  settings.ghost = settings.help = false;
  settings.speed = 70;
  settings.sound.volume = 20;
  settings.sound.music = 0;
  settings.bindings.bind(Action::jump, PadButton::left_stick_up);
  settings.bindings.bind(Action::left, MouseButton::middle);
  settings.bindings.unbind(Key::r);
  settings.bindings.unbind(PadButton::back);
  return settings;
}

TEST(SettingsText, HoldsEverySetting) {
  EXPECT_TRUE(parse_settings(settings_text(some_settings()), "file") == some_settings());
  EXPECT_TRUE(parse_settings(settings_text({}), "file") == Settings{});
  EXPECT_TRUE(parse_settings("{}", "file") == Settings{});
}

TEST(SettingsText, NamesWhatIsWrongAndWhatIsAccepted) {
  const auto refused = [](const std::string& text) {
    return test_support::refusal<std::runtime_error>([&] { parse_settings(text, "settings.json"); });
  };
  EXPECT_EQ(refused(R"({"speed": 20})"), "settings.json: \"speed\" is 20, accepted is a whole number from 50 to 100");
  EXPECT_NE(refused(R"({"muted": 1})").find("\"muted\" is 1"), std::string::npos);
  EXPECT_NE(refused(R"({"bindings": {"jump": ["key_nowhere"]}})").find("key_nowhere"), std::string::npos);
  EXPECT_NE(refused(R"({"bindings": {"jump": [7]}})").find("jump has 7"), std::string::npos);
  EXPECT_NE(refused("[]").find("an array"), std::string::npos);
}

TEST(SettingsText, ANewActionHasItsDefaultKeysUnlessTheyAreInUse) {
  const Settings settings = parse_settings(R"({"bindings": {"jump": ["key_r", "key_j"], "left": []}})", "file");
  EXPECT_EQ(settings.bindings.action_of(Key::r), Action::jump);
  EXPECT_EQ(settings.bindings.action_of(PadButton::back), Action::restart);
  EXPECT_TRUE(settings.bindings.codes(Action::left).empty());
}

/// Cut at every byte, and with every byte changed: the file is accepted or refused.
TEST(SettingsText, ABrokenFileIsRefusedWithAMessage) {
  const std::string whole = settings_text(some_settings());
  int refused = 0;
  const auto read = [&](const std::string& text) {
    try {
      parse_settings(text, "file");
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()).rfind("file", 0), 0U) << error.what();
      ++refused;
    }
  };
  for (std::size_t length = 0; length + 2 < whole.size(); ++length) read(whole.substr(0, length));
  EXPECT_EQ(refused, static_cast<int>(whole.size()) - 2) << "a part of a file is none";
  for (std::size_t k = 0; k < whole.size(); ++k) {
    for (const char by : {'\0', '{', '"', '9', '\xff'}) read(std::string(whole).replace(k, 1, 1, by));
  }
}

TEST(SettingsFile, IsLoadedAgainOrRenamedIfBroken) {
  const std::string path = scratch("config/settings.json");
  std::string notice;
  SettingsFile(path).save(some_settings(), notice);
  EXPECT_TRUE(SettingsFile(path).load(notice) == some_settings());
  EXPECT_EQ(notice, "");
  write_bytes(path, "{\"speed\": ");
  EXPECT_TRUE(SettingsFile(path).load(notice) == Settings{});
  EXPECT_NE(notice.find("settings.json.broken"), std::string::npos);
  EXPECT_EQ(bytes_of(path + ".broken"), "{\"speed\": ");
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(SettingsFile, ReportsOnceThatItCannotBeWritten) {
  const std::string file = scratch("a_file");
  write_bytes(file, "");
  for (const std::string& path : {file + "/settings.json", std::string("/proc/nowhere/settings.json")}) {
    SettingsFile settings_file(path);
    std::string notice;
    settings_file.save(some_settings(), notice);
    EXPECT_NE(notice.find("cannot be written"), std::string::npos);
    notice.clear();
    settings_file.save({}, notice);
    EXPECT_EQ(notice, "");
  }
}

TEST(Records, TheBestRunIsStoredWithItsRecording) {
  const std::string folder = scratch("data");
  const LevelKey level{"swing", 0x1234};
  std::string notice;
  Records records(folder);
  write_bytes(scratch("a.replay"), "first");
  write_bytes(scratch("b.replay"), "second");
  EXPECT_TRUE(records.offer(level, {500, false}, scratch("a.replay"), notice));
  EXPECT_FALSE(records.offer(level, {500, false}, scratch("b.replay"), notice)) << "no better";
  EXPECT_FALSE(records.offer(level, {300, true}, scratch("b.replay"), notice)) << "with help";
  EXPECT_EQ(bytes_of(records.replay_path(level)), "first");
  EXPECT_TRUE(records.offer(level, {499, false}, scratch("b.replay"), notice));
  EXPECT_EQ(records.best({"swing", 0x1235}), std::nullopt) << "the level has changed";

  Records again(folder);
  again.load(notice);
  EXPECT_EQ(again.best(level), (Best{499, false}));
  EXPECT_EQ(bytes_of(again.replay_path(level)), "second");
  EXPECT_TRUE(again.offer(level, {400, false}, "", notice));
  EXPECT_FALSE(std::filesystem::exists(again.replay_path(level))) << "of another run than the best";
  EXPECT_EQ(notice, "");
}

TEST(Records, SplitsAreStoredAndMayBeAddedLater) {
  const std::string folder = scratch("data_with_splits");
  const LevelKey level{"swing", 0x1234};
  const LevelKey other{"bridge", 0x99};
  std::string notice;
  Records records(folder);
  records.offer(level, {500, false, {120, std::nullopt, 480}}, "", notice);
  records.offer(other, {300, false}, "", notice);
  records.add_splits(other, 301, {7}, notice);
  EXPECT_EQ(records.best(other)->splits.size(), 0U) << "of another run";
  records.add_splits(other, 300, {std::nullopt, 9}, notice);
  records.add_splits(level, 500, {1}, notice);
  Records again(folder);
  again.load(notice);
  EXPECT_EQ(again.best(level), (Best{500, false, {120, std::nullopt, 480}})) << "known splits stay";
  EXPECT_EQ(again.best(other), (Best{300, false, {std::nullopt, 9}}));
  EXPECT_EQ(notice, "");
}

TEST(Records, AFileOfAnEarlierVersionIsReadAndALaterOneRefused) {
  const std::string folder = scratch("data_of_version_1");
  const std::string record = R"("best": [{"level": "a", "hash": "0000000000000007", "ticks": 90, "assisted": false)";
  const auto load = [&](const std::string& text) {
    write_bytes(folder + "/best.json", text);
    std::string notice;
    Records records(folder);
    records.load(notice);
    EXPECT_EQ(notice == "", records.best({"a", 7}).has_value()) << text;
    return records.best({"a", 7});
  };
  std::filesystem::create_directories(folder);
  EXPECT_EQ(load("{" + record + "}]}"), (Best{90, false}));
  EXPECT_EQ(load(R"({"version": 2, )" + record + R"(, "splits": [null, 40]}]})"),
            (Best{90, false, {std::nullopt, 40}}));
  EXPECT_EQ(load(R"({"version": 3, )" + record + "}]}"), std::nullopt);
  for (const char* const splits : {"7", "[91]", "[-1]", "[1.5]", "[\"1\"]", "[[1]]", "[99999999999]"}) {
    EXPECT_EQ(load("{" + record + R"(, "splits": )" + splits + "}]}"), std::nullopt) << splits;
  }
}

TEST(Records, AnUnassistedRunRanksAboveAnAssistedOne) {
  EXPECT_TRUE((Best{900, false}).is_better_than({300, true}));
  EXPECT_FALSE((Best{300, true}).is_better_than({900, false}));
  EXPECT_TRUE((Best{299, true}).is_better_than({300, true}));
}

TEST(Records, AFileBrokenAtAnyByteIsRenamed) {
  const std::string folder = scratch("broken_data");
  std::string notice;
  Records(folder).offer({"swing", 7}, {500, false}, "", notice);
  const std::string whole = bytes_of(folder + "/best.json");
  ASSERT_GT(whole.size(), 20U);
  for (std::size_t length = 0; length + 2 < whole.size(); ++length) {
    write_bytes(folder + "/best.json", whole.substr(0, length));
    notice.clear();
    Records records(folder);
    records.load(notice);
    EXPECT_EQ(records.best({"swing", 7}), std::nullopt);
    EXPECT_NE(notice.find("best.json.broken"), std::string::npos) << length;
    EXPECT_EQ(bytes_of(folder + "/best.json.broken"), whole.substr(0, length));
  }
  for (const char* const text : {R"({"best": [{"level": "a", "hash": "xyz", "ticks": 1}]})",
                                 R"({"best": [{"level": "a", "hash": "0000000000000007", "ticks": 0}]})",
                                 R"({"best": [{"level": "a", "hash": "0000000000000007", "ticks": 1e99}]})"}) {
    write_bytes(folder + "/best.json", text);
    notice.clear();
    Records(folder).load(notice);
    EXPECT_NE(notice, "") << text;
  }
}

TEST(Records, WithoutAFolderTheyAreStoredInMemory) {
  std::string notice;
  Records nowhere("");
  EXPECT_TRUE(nowhere.offer({"swing", 7}, {500, false}, "", notice));
  EXPECT_EQ(nowhere.best({"swing", 7}), (Best{500, false}));
  EXPECT_EQ(notice, "");
  Records unwritable("/proc/nowhere");
  EXPECT_TRUE(unwritable.offer({"swing", 7}, {500, false}, "", notice));
  EXPECT_NE(notice, "");
  notice.clear();
  EXPECT_TRUE(unwritable.offer({"swing", 7}, {400, false}, "", notice));
  EXPECT_EQ(notice, "") << "once is enough";
}

/// Folders of the user for pictures and videos: by environment, by the desktop's list, or among the game's own data.
class UserFolders : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove_all(config);
    std::filesystem::create_directories(config);
  }
  void list(const std::string& text) const { write_bytes(config + "/user-dirs.dirs", text); }

  const std::string config = scratch("user_dirs");
  const test_support::Environment home{"HOME", "/home/a_player"};
  const test_support::Environment config_home{"XDG_CONFIG_HOME", config.c_str()};
  const test_support::Environment data_home{"XDG_DATA_HOME", nullptr};
  const test_support::Environment pictures{"XDG_PICTURES_DIR", nullptr};
  const test_support::Environment videos{"XDG_VIDEOS_DIR", nullptr};
};

TEST_F(UserFolders, AreThoseOfTheDesktop) {
  EXPECT_EQ(pictures_folder(), "/home/a_player/.local/share/ropeswing/pictures");
  EXPECT_EQ(videos_folder(), "/home/a_player/.local/share/ropeswing/videos");
  list("# a comment\nXDG_PICTURES_DIR=\"$HOME/My Pictures\"\nXDG_VIDEOS_DIR=\"/mnt/videos\"\n");
  EXPECT_EQ(pictures_folder(), "/home/a_player/My Pictures");
  EXPECT_EQ(videos_folder(), "/mnt/videos");
  const test_support::Environment chosen("XDG_PICTURES_DIR", "/elsewhere");
  EXPECT_EQ(pictures_folder(), "/elsewhere");
}

TEST_F(UserFolders, EntriesThatNameNoFolderAreIgnored) {
  for (const char* value : {"\"$HOME\"", "\"$HOME/\"", "\"relative\"", "unquoted", "\"", ""}) {
    list(std::string("XDG_PICTURES_DIR=") + value + "\n");
    EXPECT_EQ(pictures_folder(), "/home/a_player/.local/share/ropeswing/pictures") << value;
  }
  const test_support::Environment relative("XDG_PICTURES_DIR", "pictures");
  EXPECT_EQ(pictures_folder(), "/home/a_player/.local/share/ropeswing/pictures");
  const test_support::Environment homeless("HOME", nullptr);
  EXPECT_EQ(pictures_folder(), "");
}

TEST(RunFolder, KeepsTheNewest) {
  const std::string folder = scratch("runs");
  RunFolder runs(folder);
  EXPECT_EQ(runs.next_path("swing"), folder + "/000001-swing.replay");
  write_bytes(folder + "/another player's.replay", "");
  for (int k = 0; k < RunFolder::max_runs + 5; ++k) write_bytes(runs.next_path("swing"), "");
  EXPECT_FALSE(std::filesystem::exists(folder + "/000005-swing.replay"));
  EXPECT_TRUE(std::filesystem::exists(folder + "/000006-swing.replay"));
  EXPECT_TRUE(std::filesystem::exists(folder + "/000055-swing.replay"));
  EXPECT_TRUE(std::filesystem::exists(folder + "/another player's.replay"));
  EXPECT_EQ(RunFolder("").next_path("swing"), "");
  EXPECT_EQ(RunFolder("/proc/nowhere").next_path("swing"), "");
}

TEST(Medals, AreAwardedForTimesUpToTheirLimits) {
  const Medals medals{10.0, 12.5, 20.0};
  EXPECT_EQ(medal_for(600, medals), Medal::gold);
  EXPECT_EQ(medal_for(601, medals), Medal::silver);
  EXPECT_EQ(medal_for(750, medals), Medal::silver);
  EXPECT_EQ(medal_for(1200, medals), Medal::bronze);
  EXPECT_EQ(medal_for(1201, medals), Medal::none);
}

TEST(Session, AnUnreadableFileIsReportedAndTheGameContinues) {
  const std::string config = scratch("bad_config");
  std::filesystem::create_directories(config + "/settings.json");  // a folder instead of a file
  Session session(config, "");
  EXPECT_TRUE(session.settings == Settings{});
  EXPECT_NE(session.notice.text().find("settings"), std::string::npos);
  session.notice.advance(7'000'000'000);
  EXPECT_EQ(session.notice.text(), "");
}

}  // namespace
}  // namespace game
