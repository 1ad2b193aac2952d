#pragma once

#include <optional>
#include <string>

#include "engine/panel/debug_panel.h"
#include "game/simulation/meter.h"
#include "game/simulation/recorded_run.h"
#include "game/tuning/tuned_level.h"

namespace game {

/// The panel that shows what the cords of a run cost and do, and where all of them can be tuned while they move.
class TuningPanel {
 public:
  TuningPanel();

  void toggle() { is_shown_ = !is_shown_; }
  bool is_shown() const { return is_shown_; }

  /// A frame, `seconds` after the one before, on a canvas of that size and scale; before the frame's ticks. What is
  /// left of the input is for the game. While it is not shown, all of it.
  engine::WindowInput update(const engine::WindowInput& input, const engine::Canvas& canvas, double scale,
                             double seconds, RecordedRun& run, const Meter& meter);
  void draw(engine::Canvas& canvas) const;

  /// True once after it was asked for.
  bool takes_restart();

 private:
  /// What the user asked for in a frame.
  struct Wish {
    int object;
    std::string property;
    std::optional<engine::Properties::Value> value;  ///< none: to be taken away
  };

  void show(const RecordedRun& run, const Meter& meter, double scale);
  void show_cord(const engine::Scene& scene, ribbon::box2d::CordId cord);
  void show_dials(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord, int object);
  void show_world(const RecordedRun& run);
  void show_player(const RecordedRun& run);
  void show_file(const RecordedRun& run);
  void obey(RecordedRun& run);
  void write();

  engine::DebugPanel panel_;
  bool is_shown_ = false;
  bool wants_restart_ = false;
  bool wants_file_ = false;  // its values
  std::optional<Wish> wish_;
  std::optional<TunedLevel> tuned_;
  std::optional<PlayerTuning> player_;
  std::string message_;
};

}  // namespace game
