#pragma once

#include <memory>
#include <string>
#include <vector>

#include "game/screens/card_grid.h"
#include "game/screens/screen.h"
#include "game/screens/session.h"
#include "game/simulation/level.h"
#include "game/words/words.h"

namespace game {

/// The levels as cards, with hint, best time and medals of the one with the focus.
class LevelScreen : public Screen {
 public:
  /// The session must outlive it.
  explicit LevelScreen(Session& session);

  void shown() override;
  Next update(const Frame& frame) override;
  void draw(engine::Canvas& canvas, double text_scale) override;
  std::string title() const override { return words::screen_levels; }

 private:
  void fill_grid();
  void make_a_picture(const GridPlace& place);
  void draw_facts(engine::Canvas& canvas, double text_scale) const;
  void draw_medal_limits(engine::Canvas& canvas, ribbon::Vec2 right, double size) const;
  void draw_no_levels(engine::Canvas& canvas, double text_scale) const;
  const Level& focused() const { return levels_[static_cast<std::size_t>(grid_.focus())]; }

  Session* session_;
  const std::vector<Level> levels_;
  CardGrid grid_;
};

/// Replaces all screens by the title screen and the list of levels.
Next to_levels(Session& session);
/// The same, with a run of the level on top. Shows a notice and stays if the level cannot be read.
Next start_level(Session& session, const std::string& name);

}  // namespace game
