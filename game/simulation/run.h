#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "game/simulation/assists.h"

namespace game {

inline constexpr const char* default_level = "first_swing";

/// What the command line asks for.
struct RunOptions {
  std::optional<std::string> level;  ///< a name or a .tmj file; none: the replay's, or default_level
  bool headless = false;
  std::string replay;                      ///< path; empty: play
  bool verify = false;                     ///< hold the run against the replay's hashes; needs `replay`
  std::string record;                      ///< path; empty: no recording
  std::optional<int> ticks;                ///< stop after this many
  int seek = 0;                            ///< tick of the replay to begin after
  Assists assists;                         ///< of a run without a replay
  std::string screenshot;                  ///< path of a PNG of the last moment; empty: none
  std::string video;                       ///< path of a .gif or .mp4 of the run, headless; empty: none
  int video_width = 480;                   ///< px
  int video_height = 270;                  ///< px
  std::string record_bad_ticks{};          ///< folder; empty: none are recorded
  std::optional<std::int64_t> bad_work{};  ///< of a tick, above which it is a bad one
};

/// Runs without a window, as fast as it can, and prints what happened: with a replay its inputs, else none. Returns the
/// exit status: 0, or of a verification 1 where it diverged and 2 where the replay was cut short.
/// Throws engine::MapError, engine::ReplayError or std::runtime_error with a sentence for the user.
int run_headless(const RunOptions& options);

/// Opens a window and plays, or shows the replay. Throws as run_headless does.
int run_in_window(const RunOptions& options);

}  // namespace game
