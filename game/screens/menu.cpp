#include "game/screens/menu.h"

#include <algorithm>
#include <utility>

#include "game/screens/style.h"
#include "game/words/words.h"

namespace game {

using engine::Align;
using engine::Canvas;
using ribbon::Vec2;

namespace {

constexpr double value_width = 0.45;  // fraction of the width, at the right

}  // namespace

int MenuPlace::rows() const { return std::max(static_cast<int>(height / row_height()), 1); }

void Menu::set_items(std::vector<MenuItem> items) {
  items_ = std::move(items);
  set_focus(focus_);
}

void Menu::set_focus(int item) { focus_ = std::clamp(item, 0, std::max(size() - 1, 0)); }

int Menu::first_shown(const MenuPlace& place) const {
  const int rows = place.rows();
  const int first = std::clamp(scrolled_, focus_ - rows + 1, focus_);
  return std::clamp(first, 0, std::max(size() - rows, 0));
}

std::optional<int> Menu::item_at(Vec2 mouse, const MenuPlace& place) const {
  const Vec2 at = mouse - place.top_left;
  if (at.x < 0.0 || at.x >= place.width || at.y < 0.0) return std::nullopt;
  const int row = static_cast<int>(at.y / place.row_height());
  const int item = first_shown(place) + row;
  if (row >= place.rows() || item >= size()) return std::nullopt;
  return item;
}

std::optional<MenuChoice> Menu::update(const MenuInput& input, const MenuPlace& place) {
  if (items_.empty()) return std::nullopt;
  scrolled_ = first_shown(place);
  const auto under_mouse = item_at(input.mouse, place);
  if (under_mouse && (input.mouse_moved || input.clicked)) focus_ = *under_mouse;
  if (input.down != 0) focus_ = ((focus_ + input.down) % size() + size()) % size();
  scrolled_ = first_shown(place);

  const bool adjustable = items_[static_cast<std::size_t>(focus_)].adjustable;
  const bool clicked = input.clicked && under_mouse;
  if (clicked && adjustable) {
    const double left_arrow = place.top_left.x + place.width * (1.0 - value_width) + 0.1 * place.width;
    const bool on_value = input.mouse.x > place.top_left.x + place.width * (1.0 - value_width);
    return MenuChoice{focus_, on_value && input.mouse.x < left_arrow ? -1 : 1};
  }
  if (input.accept || clicked) return MenuChoice{focus_, adjustable ? 1 : 0};
  if (input.right != 0 && adjustable) return MenuChoice{focus_, input.right > 0 ? 1 : -1};
  return std::nullopt;
}

void Menu::draw_row(Canvas& canvas, Vec2 at, const MenuPlace& place, int item) const {
  const MenuItem& shown = items_[static_cast<std::size_t>(item)];
  const bool focused = item == focus_;
  const double size = place.text_size;
  const double height = place.row_height();
  if (focused) canvas.panel(at, {place.width, height - 0.1 * size}, 0.4 * size, style::focus);
  const double y = at.y + 0.5 * (height - canvas.line_height(size)) - 0.05 * size;
  const engine::Color color = focused ? style::white : style::faint;
  const double margin = 0.6 * size;
  canvas.text({at.x + margin, y}, shown.label, size, color);
  if (shown.value.empty()) return;
  if (!shown.adjustable) {
    canvas.text({at.x + place.width - margin, y}, shown.value, size, color, Align::right);
    return;
  }
  const double left = at.x + place.width * (1.0 - value_width);
  const double right = at.x + place.width - margin;
  canvas.text({0.5 * (left + right), y}, shown.value, size, color, Align::center);
  if (!focused) return;
  canvas.text({left, y}, words::less, size, style::gold);
  canvas.text({right, y}, words::more, size, style::gold, Align::right);
}

void Menu::draw(Canvas& canvas, const MenuPlace& place) const {
  const int first = first_shown(place);
  const int last = std::min(first + place.rows(), size());
  for (int item = first; item < last; ++item) {
    draw_row(canvas, place.top_left + Vec2{0.0, (item - first) * place.row_height()}, place, item);
  }
  const double middle = place.top_left.x + 0.5 * place.width;
  const double step = canvas.line_height(0.6 * place.text_size);
  if (first > 0)
    canvas.text({middle, place.top_left.y - step}, words::more_above, 0.6 * place.text_size, style::faint,
                Align::center);
  if (last < size()) {
    canvas.text({middle, place.top_left.y + place.rows() * place.row_height()}, words::more_below,
                0.6 * place.text_size, style::faint, Align::center);
  }
}

}  // namespace game
