#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/tick/tick.h"
#include "game/screens/screen.h"
#include "game/screens/session.h"
#include "game/simulation/level.h"
#include "game/tuning/last_seconds.h"
#include "game/view/view.h"

namespace game {

/// Shows the last seconds of a run again and again, and over them the cords and players with another preset.
class LastSecondsScreen : public Screen {
 public:
  /// `inputs`: of all ticks since the start of a run of the level. The session must outlive it.
  LastSecondsScreen(Session& session, const Level& level, std::vector<engine::TickInput> inputs, const Preset& preset);

  Next update(const Frame& frame) override;
  void draw(engine::Canvas& canvas, double text_scale) override;
  std::string title() const override;
  Tune tune() const override { return Tune::none; }

  /// Whether both runs have reached the last seconds.
  bool is_ready() const { return is_ready_; }
  const LastSeconds& runs() const { return *runs_; }
  const Preset& preset() const { return *preset_; }

 private:
  void choose(int steps);
  void begin();
  void play(std::int64_t elapsed_ns);
  void draw_other(engine::Canvas& canvas, double alpha) const;
  std::vector<std::string> figures() const;

  Session* session_;
  Level level_;
  std::vector<engine::TickInput> inputs_;
  const Preset* preset_;
  std::unique_ptr<LastSeconds> runs_;
  std::optional<View> view_;  // of the run as it was played
  engine::FixedTick clock_{ticks_per_second};
  bool is_ready_ = false;
  int paused_ticks_ = 0;  // since the end
};

}  // namespace game
