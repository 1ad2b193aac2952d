#include "game/screens/title_screen.h"

#include <utility>

#include "game/screens/card.h"
#include "game/screens/play_screen.h"

namespace game {
namespace {

enum Item { play, leave_it };

const Card card{.headline = "Rope swing", .lines = {}};

}  // namespace

TitleScreen::TitleScreen(Session& session) : session_(&session) { menu_.set_items({{"Play"}, {"Leave the game"}}); }

Next TitleScreen::update(const Frame& frame) {
  const MenuPlace place = menu_place(frame.canvas, frame.text_scale, card, static_cast<int>(menu_.items().size()));
  const auto choice = menu_.update(frame.menu, place);
  if (!choice) return Next::stay();
  if (choice->item == play) return Next::open(std::make_unique<PlayScreen>(*session_, RunOptions{}, false));
  return Next::quit();
}

void TitleScreen::draw(engine::Canvas& canvas, double text_scale) {
  canvas.clear({92, 160, 214}, {214, 236, 246});
  const auto rows = static_cast<int>(menu_.items().size());
  draw_card(canvas, text_scale, card, rows);
  menu_.draw(canvas, menu_place(canvas, text_scale, card, rows));
  draw_menu_keys(canvas, text_scale, session_->uses_pad);
}

Next to_title(Session& session) {
  std::vector<std::unique_ptr<Screen>> screens;
  screens.push_back(std::make_unique<TitleScreen>(session));
  return Next::replace_all(std::move(screens));
}

}  // namespace game
