#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/tick/workers.h"
#include "game/screens/level_pictures.h"
#include "game/settings/records.h"
#include "game/settings/run_folder.h"
#include "game/settings/settings.h"
#include "game/settings/settings_file.h"
#include "game/sound/sounds.h"
#include "game/tuning/frame_times.h"
#include "ribbon/box2d/step_watcher.h"

namespace game {

/// A message for the player, shown for some seconds at the bottom of any screen. A new one replaces it.
class Notice {
 public:
  void show(std::string sentence);
  void advance(std::int64_t nanoseconds);
  /// Empty if there is no message.
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::int64_t left_ns_ = 0;
};

/// The state that all screens share.
struct Session {
  /// Reads settings and records from these folders; empty: nothing is read or saved.
  Session(const std::string& config_folder, const std::string& data_folder);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Saves the settings if they have changed.
  void save_settings();
  /// Reports, once, that runs cannot be recorded.
  void report_no_recordings();

  Settings settings;
  Notice notice;
  Sounds sounds;
  Records records;
  RunFolder runs;
  bool uses_pad = false;                          ///< the last press was on a gamepad: hints show its buttons
  std::string last_level{};                       ///< that was played, for the list of levels
  ribbon::box2d::StepWatcher* watcher = nullptr;  ///< of all runs; must outlive them
  FrameTimes frame_times;                         ///< for the panel with figures
  LevelPictures level_pictures;                   ///< for the list of levels
  engine::Workers workers;                        ///< for the cords of all runs, one per core

 private:
  SettingsFile settings_file_;
  bool reported_ = false;
};

}  // namespace game
