// The program in a real window of an X server, operated by key and mouse events of that server.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/replay/replay.h"
#include "game/screens/level_facts.h"
#include "game/simulation/buttons.h"
#include "tests/game/process.h"
#include "tests/game/program.h"

namespace {

using namespace test_support;

/// Returns the output of a command, without the final newline.
std::string said_by(const std::string& command) {
  std::FILE* pipe = popen((command + " 2>/dev/null").c_str(), "r");
  std::string said;
  std::array<char, 256> buffer{};
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) said.append(buffer.data(), n);
  pclose(pipe);
  return said.substr(0, said.find('\n'));
}

/// Operates the window by xdotool.
class Person {
 public:
  Person(std::string display, Process& game) : display_(std::move(display)), game_(&game) {}

  /// Waits for the window and focuses it. Returns false if the game ends instead.
  bool finds_the_window() {
    while (window_.empty()) {
      if (!game_->runs()) return false;
      window_ = said_by(xdotool("search --onlyvisible --name '^Rope swing - '"));
    }
    said_by(xdotool("windowfocus --sync " + window_));
    return true;
  }
  std::string screen() const { return said_by(xdotool("getwindowname " + window_)); }
  /// Waits until that screen is shown. The failure names the last screen.
  std::string sees(const std::string& title) {
    const std::string wanted = "Rope swing - " + title;
    std::string there;
    for (int look = 0; look < 2000 && game_->runs(); ++look) {
      there = screen();
      if (there == wanted) return title;
    }
    return there;
  }
  void does(const std::string& what) const { said_by(xdotool(what)); }
  /// Returns the size of the window: "  Geometry: 800x600".
  std::string size() const { return said_by(xdotool("getwindowgeometry " + window_) + " | tail -1"); }

 private:
  std::string xdotool(const std::string& arguments) const { return "DISPLAY=" + display_ + " xdotool " + arguments; }

  std::string display_;
  Process* game_;
  std::string window_;
};

/// The game in a window of its own X server, without saved data at first.
class RealWindow : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v Xvfb >/dev/null && command -v xdotool >/dev/null") != 0) {
      GTEST_SKIP() << "Xvfb or xdotool is not installed";
    }
    for (const std::string& folder : {config, data}) fs::remove_all(folder);
    ASSERT_TRUE(server.starts());
    game.emplace(
        "ASAN_OPTIONS=detect_leaks=0 SDL_VIDEODRIVER=x11 SDL_RENDER_DRIVER=software DISPLAY=" + server.display() +
        " XDG_CONFIG_HOME=" + config + " XDG_DATA_HOME=" + data + " exec " TEST_ROPESWING " >" + said + " 2>&1");
    person.emplace(server.display(), *game);
    ASSERT_TRUE(person->finds_the_window()) << bytes_of(said);
    ASSERT_EQ(person->sees("title"), "title") << bytes_of(said);
  }

  /// The recordings of all runs, oldest first.
  std::vector<fs::path> runs() const {
    std::vector<fs::path> found;
    std::error_code not_there_yet;
    for (const auto& entry : fs::directory_iterator(data + "/ropeswing/runs", not_there_yet)) {
      found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end());
    return found;
  }
  /// Returns what is recorded of the newest run so far.
  engine::Replay newest_run() const {
    const std::vector<fs::path> all = runs();
    try {
      return all.empty() ? engine::Replay{} : engine::load_replay(all.back().string());
    } catch (const engine::ReplayError&) {  // it has just begun
      return {};
    }
  }
  /// Waits for a number of runs, and for a number of ticks in the newest one. Returns false after a timeout.
  bool sees_ticks(std::size_t run_count, std::size_t ticks) {
    for (int look = 0; look < 20'000 && game->runs(); ++look) {
      if (runs().size() == run_count && newest_run().ticks.size() >= ticks) return true;
    }
    return false;
  }
  /// Moves the mouse down the window by half a line at a time and clicks until another screen is shown.
  void click_down_to_something(int x) {
    const std::string here = person->screen();
    for (int y = 320; y < 500 && person->screen() == here; y += 24) {
      person->does("mousemove " + std::to_string(x) + " " + std::to_string(y) + " click 1");
      // The mouse stays where it is until the screen may have changed, so that it does not move over that screen.
      for (int look = 0; look < 100 && person->screen() == here; ++look) {
      }
    }
  }

  const std::string config = scratch("real_config");
  const std::string data = scratch("real_data");
  const std::string said = scratch("real_said.txt");
  XServer server{"1280x720x24"};
  std::optional<Process> game;
  std::optional<Person> person;
};

TEST_F(RealWindow, KeysAndMouseGoThroughEveryScreenAndTheGameEndsCleanly) {
  person->does("key Down");
  person->does("key Return");
  ASSERT_EQ(person->sees("the lab: Heavy load"), "the lab: Heavy load");
  person->does("key Escape");
  ASSERT_EQ(person->sees("title"), "title");
  person->does("key Down");
  person->does("key Return");
  ASSERT_EQ(person->sees("options"), "options");
  person->does("key Return");
  ASSERT_EQ(person->sees("keys and buttons"), "keys and buttons");
  person->does("key Escape");
  ASSERT_EQ(person->sees("options"), "options");
  person->does("key Escape");
  ASSERT_EQ(person->sees("title"), "title");
  click_down_to_something(200);  // Play
  ASSERT_EQ(person->sees("levels"), "levels");
  const std::string first = game::levels_in_order().front().name;
  person->does("key Return");
  ASSERT_EQ(person->sees(first), first);
  person->does("keydown d");
  ASSERT_TRUE(sees_ticks(1, 60));
  person->does("keyup d");
  person->does("key Escape");
  ASSERT_EQ(person->sees("paused"), "paused");
  person->does("key Escape");
  ASSERT_EQ(person->sees(first), first);
  person->does("key p");
  ASSERT_EQ(person->sees("paused"), "paused");
  person->does("key Up");
  person->does("key Return");
  ASSERT_EQ(person->sees("title"), "title");
  person->does("key Up");
  person->does("key Return");
  EXPECT_EQ(game->wait(), 0) << bytes_of(said);

  ASSERT_EQ(runs().size(), 1U);
  const std::string path = runs().front().string();
  const engine::Replay replay = engine::load_replay(path);
  EXPECT_TRUE(replay.complete);
  EXPECT_TRUE(std::any_of(replay.ticks.begin(), replay.ticks.end(), [](const engine::RecordedTick& tick) {
    return (tick.input.buttons & game::button_right) != 0;
  })) << "the key was held";
  EXPECT_EQ(ropeswing("--headless --verify --replay " + path).status, 0);
}

TEST(SmallDisplay, TheFirstWindowFitsOnIt) {
  if (std::system("command -v Xvfb >/dev/null && command -v xdotool >/dev/null") != 0) {
    GTEST_SKIP() << "Xvfb or xdotool is not installed";
  }
  XServer server{"800x600x24"};
  ASSERT_TRUE(server.starts());
  Process game("ASAN_OPTIONS=detect_leaks=0 SDL_VIDEODRIVER=x11 SDL_RENDER_DRIVER=software DISPLAY=" +
               server.display() + " exec " TEST_ROPESWING " >/dev/null 2>&1");
  Person person(server.display(), game);
  ASSERT_TRUE(person.finds_the_window());
  EXPECT_EQ(person.size(), "  Geometry: 800x600");
}

struct KeyOf {
  game::Button button;
  const char* name;  // in xdotool
};
constexpr std::array keys = {KeyOf{game::button_left, "Left"},  KeyOf{game::button_right, "d"},
                             KeyOf{game::button_jump, "space"}, KeyOf{game::button_grab, "Shift_L"},
                             KeyOf{game::button_up, "w"},       KeyOf{game::button_down, "Down"},
                             KeyOf{game::button_throw, "f"},    KeyOf{game::button_reel_in, "q"},
                             KeyOf{game::button_reel_out, "z"}, KeyOf{game::button_retry, "t"}};

/// Presses and releases the keys that differ between two ticks.
std::string from_keys_to_keys(std::uint16_t from, std::uint16_t to) {
  std::string moves;
  for (const KeyOf& key : keys) {
    if ((from & key.button) == (to & key.button)) continue;
    moves += std::string((to & key.button) != 0 ? "keydown " : "keyup ") + key.name + " ";
  }
  return moves;
}

/// Plays a winning run tick by tick, with the key N for each, so that delays of the machine or display do not matter.
TEST_F(RealWindow, ARunIsPlayedFromTheTitleToTheGoalAndBackToTheTitle) {
  const std::string level = "pump_it_up";  // the fifth level, the last of the first row of cards; its run is short
  const engine::Replay wanted = engine::load_replay(TEST_ASSETS "/replays/" + level + ".replay");
  click_down_to_something(200);
  ASSERT_EQ(person->sees("levels"), "levels");
  ASSERT_EQ(game::levels_in_order().at(4).name, level);
  for (int card = 0; card < 4; ++card) person->does("key Right");
  person->does("key Return");
  ASSERT_EQ(person->sees(level), level);
  person->does("key n");
  ASSERT_TRUE(sees_ticks(1, 1));

  person->does("mousemove 900 200 mousedown 1 key n");
  person->does("mouseup 1");
  const auto throws = [](const engine::RecordedTick& tick) { return (tick.input.buttons & game::button_throw) != 0; };
  const auto has_thrown = [&] {
    const engine::Replay run = newest_run();
    return std::any_of(run.ticks.begin(), run.ticks.end(), throws);
  };
  for (int look = 0; look < 5000 && !has_thrown(); ++look) ASSERT_TRUE(game->runs());
  ASSERT_TRUE(has_thrown()) << "the mouse's button was held";

  std::uint16_t held = wanted.ticks.front().input.buttons;
  person->does(from_keys_to_keys(0, held) + "key r");
  ASSERT_TRUE(sees_ticks(2, 1));
  for (std::size_t k = 1; k < wanted.ticks.size(); ++k) {
    const std::uint16_t now = wanted.ticks[k].input.buttons;
    person->does(from_keys_to_keys(std::exchange(held, now), now) + "key --delay 0 n");
    ASSERT_TRUE(sees_ticks(2, k + 1)) << "tick " << k + 1;
  }
  person->does(from_keys_to_keys(held, 0) + "key p");
  ASSERT_EQ(person->sees("results"), "results");
  const engine::Replay played = newest_run();
  EXPECT_TRUE(played.complete);
  ASSERT_GT(played.ticks.size(), wanted.ticks.size());
  for (std::size_t k = 0; k < wanted.ticks.size(); ++k) {
    ASSERT_EQ(played.ticks[k].input.buttons, wanted.ticks[k].input.buttons) << "tick " << k + 1;
    ASSERT_TRUE(played.ticks[k].state == wanted.ticks[k].state) << "tick " << k + 1;
  }
  EXPECT_EQ(ropeswing("--headless --verify --replay " + runs().back().string()).status, 0);

  person->does("click 3");
  ASSERT_EQ(person->sees("levels"), "levels");
  person->does("click 3");
  ASSERT_EQ(person->sees("title"), "title");
  person->does("key Up");
  person->does("key Return");
  EXPECT_EQ(game->wait(), 0) << bytes_of(said);
  EXPECT_NE(bytes_of(data + "/ropeswing/best.json").find(level), std::string::npos);
}

}  // namespace
