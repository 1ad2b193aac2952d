// The program in a real window of an X server, by key and mouse events that go through it.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "engine/replay.h"
#include "game/buttons.h"
#include "game/level_facts.h"
#include "tests/game/process.h"
#include "tests/game/program.h"

namespace {

using namespace test_support;

/// What a command printed, without the line's end.
std::string said_by(const std::string& command) {
  std::FILE* pipe = popen((command + " 2>/dev/null").c_str(), "r");
  std::string said;
  std::array<char, 256> buffer{};
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) said.append(buffer.data(), n);
  pclose(pipe);
  return said.substr(0, said.find('\n'));
}

/// A person before the screen.
class Person {
 public:
  Person(std::string display, Process& game) : display_(std::move(display)), game_(&game) {}

  /// Waits for the window and takes it. False if the game ends instead.
  bool finds_the_window() {
    while (window_.empty()) {
      if (!game_->runs()) return false;
      window_ = said_by(xdotool("search --onlyvisible --name '^Rope swing - '"));
    }
    said_by(xdotool("windowfocus --sync " + window_));
    return true;
  }
  std::string screen() const { return said_by(xdotool("getwindowname " + window_)); }
  /// Waits until that screen is there. What else there is in the end if it does not come.
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

 private:
  std::string xdotool(const std::string& arguments) const { return "DISPLAY=" + display_ + " xdotool " + arguments; }

  std::string display_;
  Process* game_;
  std::string window_;
};

/// The recordings of all runs, oldest first.
std::vector<fs::path> runs_in(const std::string& data) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(data + "/ropeswing/runs")) found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

TEST(RealWindow, KeysAndMouseGoThroughEveryScreenAndTheGameEndsCleanly) {
  if (std::system("command -v Xvfb >/dev/null && command -v xdotool >/dev/null") != 0) {
    GTEST_SKIP() << "Xvfb or xdotool is not installed";
  }
  const std::string data = scratch("real_data");
  const std::string said = scratch("real_said.txt");
  XServer server("1280x720x24");
  ASSERT_TRUE(server.starts());
  Process game("ASAN_OPTIONS=detect_leaks=0 SDL_VIDEODRIVER=x11 SDL_RENDER_DRIVER=software DISPLAY=" +
               server.display() + " XDG_CONFIG_HOME=" + scratch("real_config") + " XDG_DATA_HOME=" + data +
               " exec " TEST_ROPESWING " >" + said + " 2>&1");
  Person person(server.display(), game);
  ASSERT_TRUE(person.finds_the_window()) << bytes_of(said);
  ASSERT_EQ(person.sees("title"), "title") << bytes_of(said);
  person.does("key Down");
  person.does("key Return");
  ASSERT_EQ(person.sees("options"), "options");
  person.does("key Return");
  ASSERT_EQ(person.sees("keys and buttons"), "keys and buttons");
  person.does("key Escape");
  ASSERT_EQ(person.sees("options"), "options");
  person.does("key Escape");
  ASSERT_EQ(person.sees("title"), "title");
  for (int y = 250; y < 500 && person.screen() == "Rope swing - title"; y += 12) {  // Play is somewhere there
    person.does("mousemove 200 " + std::to_string(y) + " click 1");
  }
  ASSERT_EQ(person.sees("levels"), "levels");
  const std::string first = game::levels_in_order().front().name;
  person.does("key Return");
  ASSERT_EQ(person.sees(first), first);
  person.does("keydown d");
  const auto ticks_of = [&] { return runs_in(data).empty() ? 0U : fs::file_size(runs_in(data).back()); };
  while (ticks_of() < 10'000) ASSERT_TRUE(game.runs());
  person.does("keyup d");
  person.does("key Escape");
  ASSERT_EQ(person.sees("paused"), "paused");
  person.does("key Escape");
  ASSERT_EQ(person.sees(first), first);
  person.does("key p");
  ASSERT_EQ(person.sees("paused"), "paused");
  person.does("key Up");
  person.does("key Return");
  ASSERT_EQ(person.sees("title"), "title");
  person.does("key Up");
  person.does("key Return");
  EXPECT_EQ(game.wait(), 0) << bytes_of(said);

  ASSERT_EQ(runs_in(data).size(), 1U);
  const std::string path = runs_in(data).front().string();
  const engine::Replay replay = engine::load_replay(path);
  EXPECT_TRUE(replay.complete);
  EXPECT_TRUE(std::any_of(replay.ticks.begin(), replay.ticks.end(), [](const engine::RecordedTick& tick) {
    return (tick.input.buttons & game::button_right) != 0;
  })) << "the key was held";
  EXPECT_EQ(ropeswing("--headless --verify --replay " + path).status, 0);
}

}  // namespace
