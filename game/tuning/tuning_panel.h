#pragma once

#include <optional>
#include <string>

#include "engine/panel/debug_panel.h"
#include "game/simulation/meter.h"
#include "game/simulation/recorded_run.h"
#include "game/tuning/frame_times.h"
#include "game/tuning/last_seconds.h"
#include "game/tuning/parameters.h"
#include "game/tuning/tuned_level.h"

namespace game {

/// The panel with figures of the cords of a run and sliders for their parameters.
class TuningPanel {
 public:
  TuningPanel();

  void toggle() { is_shown_ = !is_shown_; }
  bool is_shown() const { return is_shown_; }
  /// The place of the panel on the canvas in px.
  struct Place {
    ribbon::Vec2 corner, size;
  };
  /// Returns its place in the last update; none if it is not shown.
  std::optional<Place> place() const { return is_shown_ ? place_ : std::nullopt; }

  /// Runs a frame `seconds` after the last one, before its ticks, and applies changes to the run. Returns the input
  /// that the panel does not use.
  engine::WindowInput update(const engine::WindowInput& input, const engine::Canvas& canvas, double scale,
                             double seconds, RecordedRun& run, const Meter& meter, const FrameTimes& times);
  void draw(engine::Canvas& canvas) const;

  /// Returns true once after the user requested a restart.
  bool takes_restart();
  /// Returns once the preset with which the user requested to see the last seconds again; otherwise null.
  const Preset* takes_comparison();

 private:
  /// A change that the user made in a frame.
  struct Change {
    int object;
    std::string property;
    std::optional<engine::Properties::Value> value;  ///< none: remove the property
  };

  void show(const RecordedRun& run, const Meter& meter, const FrameTimes& times, double scale);
  void show_last_seconds(const RecordedRun& run);
  void show_cord(const engine::Scene& scene, ribbon::box2d::CordId cord);
  void show_parameter(const Parameter& parameter, double value, int object);
  void show_world(const RecordedRun& run);
  void show_player(const RecordedRun& run);
  void show_file(const RecordedRun& run);
  void apply_change(RecordedRun& run);
  void write();

  engine::DebugPanel panel_;
  bool is_shown_ = false;
  std::optional<Place> place_;
  bool wants_restart_ = false;
  const Preset* compared_ = nullptr;
  bool wants_file_ = false;  // reset to the values of the file
  std::optional<Change> change_;
  std::optional<TunedLevel> tuned_;
  std::optional<PlayerTuning> player_;
  std::string message_;
};

}  // namespace game
