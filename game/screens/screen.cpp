#include "game/screens/screen.h"

#include <algorithm>
#include <utility>

namespace game {
namespace {

constexpr double usual_desktop_width = 1280.0;  // desktop units, for text of the usual size
constexpr double usual_height = 720.0;
constexpr double min_scale = 0.65;  // below it, text is hard to read
constexpr double max_scale = 1.5;

}  // namespace

double text_scale_of(const engine::Canvas& canvas, double pixel_scale) {
  const double size = std::min(canvas.width() / usual_desktop_width, canvas.height() / usual_height);
  return pixel_scale * std::clamp(size / pixel_scale, min_scale, max_scale);
}

Next Next::open(std::unique_ptr<Screen> screen) {
  Next next{What::open, {}};
  next.screens.push_back(std::move(screen));
  return next;
}

Next Next::back() { return {What::back, {}}; }

Next Next::replace_all(std::vector<std::unique_ptr<Screen>> screens) { return {What::replace_all, std::move(screens)}; }

Next Next::quit() { return {What::quit, {}}; }

void ScreenStack::open(std::unique_ptr<Screen> screen) {
  if (!screens_.empty() && !screen->is_overlay()) fade_.begin();
  screens_.push_back(std::move(screen));
  screens_.back()->shown();
}

void ScreenStack::close_top() {
  screens_.back()->leave();
  if (!screens_.back()->is_overlay()) fade_.begin();
  screens_.pop_back();
}

bool ScreenStack::update(const Frame& frame) {
  fade_.advance(frame.elapsed_ns);
  Next next = screens_.back()->update(frame);
  switch (next.what) {
    case Next::What::stay: return true;
    case Next::What::open: open(std::move(next.screens.front())); return true;
    case Next::What::back:
      close_top();
      if (!screens_.empty()) screens_.back()->shown();
      return !screens_.empty();
    case Next::What::replace_all:
      while (!screens_.empty()) close_top();
      for (std::unique_ptr<Screen>& screen : next.screens) screens_.push_back(std::move(screen));
      screens_.back()->shown();
      return true;
    case Next::What::quit: return false;
  }
  return false;
}

void ScreenStack::draw(engine::Canvas& canvas, double text_scale) {
  std::size_t first = screens_.size() - 1;
  while (first > 0 && screens_[first]->is_overlay()) --first;
  if (first + 1 < screens_.size()) screens_[first]->draw_below(canvas, text_scale);
  screens_.back()->draw(canvas, text_scale);
  fade_.draw(canvas);
}

void ScreenStack::leave() {
  for (auto screen = screens_.rbegin(); screen != screens_.rend(); ++screen) (*screen)->leave();
}

}  // namespace game
