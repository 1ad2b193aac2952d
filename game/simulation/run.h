#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "game/simulation/assists.h"

namespace game {

inline constexpr const char* default_level = "first_swing";

/// The options of the command line.
struct RunOptions {
  std::optional<std::string> level;  ///< a name or a .tmj file; none: that of the replay, or default_level
  bool headless = false;
  std::string replay;                      ///< path; empty: play
  bool verify = false;                     ///< compare the run with the hashes of `replay`
  std::string record;                      ///< path; empty: no recording
  std::optional<int> ticks;                ///< number of ticks after which to stop
  int seek = 0;                            ///< start after this tick of the replay
  Assists assists;                         ///< of a run without a replay
  std::string screenshot;                  ///< path of a PNG of the last tick; empty: none
  std::string video;                       ///< path of a .gif or .mp4 of the run, headless; empty: none
  int video_width = 480;                   ///< px
  int video_height = 270;                  ///< px
  std::string record_bad_ticks{};          ///< folder; empty: none are recorded
  std::string ghost{};                     ///< path of a recording to race against; empty: the best run
  std::string table{};                     ///< folder of recordings to verify and list; empty: play
  std::optional<std::string> lab{};        ///< a scene of the lab instead of a run; empty: its first one
  std::optional<std::int64_t> bad_work{};  ///< ticks with more work are bad too
};

/// Runs without a window at full speed, with the inputs of the replay or none, and prints the result. Returns the exit
/// status: 0; for a verification 1 if it diverged and 2 if the replay was cut short. Throws engine::MapError,
/// engine::ReplayError or std::runtime_error with a message for the user.
int run_headless(const RunOptions& options);

/// Runs a scene of the lab without a window, prints its figures and its hash, and returns 0. Throws std::runtime_error
/// with a message for the user.
int run_lab_headless(const RunOptions& options);

/// Opens a window and plays, or shows the replay. Throws like run_headless.
int run_in_window(const RunOptions& options);

}  // namespace game
