#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/tick/tick.h"
#include "game/screens/card.h"
#include "game/screens/menu.h"
#include "game/screens/screen.h"
#include "game/screens/session.h"
#include "game/simulation/level.h"
#include "game/view/view.h"

namespace game {

/// The list of levels. The selected level is shown behind it.
class LevelScreen : public Screen {
 public:
  /// The session must outlive it.
  explicit LevelScreen(Session& session);

  void shown() override;
  Next update(const Frame& frame) override;
  void draw(engine::Canvas& canvas, double text_scale) override;
  std::string title() const override { return "levels"; }

 private:
  void fill_menu();
  void show_focused(std::int64_t elapsed_ns);
  void draw_facts(engine::Canvas& canvas, double text_scale) const;
  const Level& focused() const { return levels_[static_cast<std::size_t>(menu_.focus())]; }

  Session* session_;
  const std::vector<Level> levels_;
  Menu menu_;
  std::optional<Simulation> preview_;
  std::optional<View> view_;
  int previewed_ = -1;
  engine::FixedTick clock_{ticks_per_second, 2};
};

/// Replaces all screens by the title screen and the list of levels.
Next to_levels(Session& session);
/// The same, with a run of the level on top. Shows a notice and stays if the level cannot be read.
Next start_level(Session& session, const std::string& name);

}  // namespace game
