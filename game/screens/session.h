#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/tick/workers.h"
#include "game/settings/records.h"
#include "game/settings/run_folder.h"
#include "game/settings/settings.h"
#include "game/settings/settings_file.h"
#include "game/sound/sounds.h"
#include "ribbon/box2d/step_watcher.h"

namespace game {

/// A sentence for the player, shown for a while at the bottom of whichever screen there is; a new one takes its place.
class Notice {
 public:
  void show(std::string sentence);
  void pass(std::int64_t nanoseconds);
  /// Empty: none.
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::int64_t left_ns_ = 0;
};

/// What all screens share.
struct Session {
  /// Reads what is remembered in these folders; empty: nothing is.
  Session(const std::string& config_folder, const std::string& data_folder);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Remembers the settings if they have changed.
  void keep_settings();
  /// Says, once, that runs cannot be recorded.
  void say_that_runs_are_not_recorded();

  Settings settings;
  Notice notice;
  Sounds sounds;
  Records records;
  RunFolder runs;
  bool uses_pad = false;     ///< the last thing that was pressed was on a gamepad: hints name its buttons
  std::string last_level{};  ///< that was played, for the level select
  ribbon::box2d::StepWatcher* watcher = nullptr;  ///< of all runs that are played; outlives them
  engine::Workers workers;                        ///< that move their cords: one a core

 private:
  SettingsFile settings_file_;
  bool said_ = false;
};

}  // namespace game
