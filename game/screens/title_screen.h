#pragma once

#include <optional>

#include "engine/tick/tick.h"
#include "game/screens/menu.h"
#include "game/screens/screen.h"
#include "game/screens/session.h"
#include "game/simulation/recorded_run.h"
#include "game/view/view.h"
#include "game/words/words.h"

namespace game {

/// The first screen, with a recorded run behind it.
class TitleScreen : public Screen {
 public:
  /// The session must outlive it.
  explicit TitleScreen(Session& session);

  Next update(const Frame& frame) override;
  void draw(engine::Canvas& canvas, double text_scale) override;
  void draw_below(engine::Canvas& canvas, double text_scale) override;
  std::string title() const override { return words::screen_title; }
  /// The run behind the menu; null if its recording cannot be read.
  const RecordedRun* run() const { return run_ ? &*run_ : nullptr; }

 private:
  void show_run(std::int64_t elapsed_ns);

  Session* session_;
  Menu menu_;
  std::optional<RecordedRun> run_;
  std::optional<View> view_;
  engine::FixedTick clock_{ticks_per_second, 2};
};

/// Replaces all screens by the title screen.
Next to_title(Session& session);

}  // namespace game
