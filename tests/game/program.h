#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/support/files.h"

/// Runs of the game in a test, and their files.
namespace test_support {

namespace fs = std::filesystem;

/// The output and exit status of a program; the status is −1 if a signal ended it.
struct Ended {
  int status;
  std::string output;  // both streams
};

/// The game's settings and data are in folders of this process, not in those of the user.
inline const bool remembers_nothing_of_the_user = [] {
  setenv("XDG_CONFIG_HOME", scratch("config_home").c_str(), 1);
  setenv("XDG_DATA_HOME", scratch("data_home").c_str(), 1);
  return true;
}();

/// Runs the game in a shell. `environment` precedes its name: variables, limits.
inline Ended ropeswing(const std::string& arguments, const std::string& environment = "") {
  const std::string command = environment + " " TEST_ROPESWING " " + arguments + " 2>&1";
  std::FILE* pipe = popen(command.c_str(), "r");
  Ended ended{-1, ""};
  std::array<char, 4096> buffer;
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) ended.output.append(buffer.data(), n);
  const int status = pclose(pipe);
  if (WIFEXITED(status)) ended.status = WEXITSTATUS(status);
  return ended;
}

inline std::string golden() { return TEST_ASSETS "/replays/first_swing.replay"; }

inline std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of('\n');
  if (end == std::string::npos) return "";
  const std::size_t start = text.rfind('\n', end);
  return text.substr(start == std::string::npos ? 0 : start + 1,
                     end - (start == std::string::npos ? 0 : start + 1) + 1);
}

}  // namespace test_support
