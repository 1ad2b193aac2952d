#include "game/screens/card_grid.h"

#include <algorithm>
#include <utility>

#include "game/screens/style.h"
#include "game/view/text_box.h"

namespace game {

using engine::Align;
using engine::Canvas;
using ribbon::Vec2;

namespace {

constexpr double usual_card_width = 215.0;  // of a card, units of text
constexpr double around_card = 8.0;         // around a card
constexpr double frame = 5.0;               // around its picture
constexpr double title_size = 17.0;
constexpr double time_size = 15.0;
constexpr double text_height = 50.0;  // below the picture
constexpr double bar = 6.0;           // the width of the scroll bar
constexpr int max_columns = 6;

int sum_around(int value, int step, int count) { return ((value + step) % count + count) % count; }

}  // namespace

int GridPlace::columns() const {
  return std::clamp(static_cast<int>((size.x - bar * scale) / (usual_card_width * scale)), 1, max_columns);
}

Vec2 GridPlace::cell() const {
  const double width = (size.x - bar * scale) / columns();
  const double picture = width - 2.0 * (around_card + frame) * scale;
  return {width, 0.5 * picture + (2.0 * around_card + frame + text_height) * scale};
}

int GridPlace::rows() const { return std::max(static_cast<int>(size.y / cell().y), 1); }

void CardGrid::set_cards(std::vector<PictureCard> cards) {
  cards_ = std::move(cards);
  set_focus(focus_);
}

void CardGrid::set_focus(int card) { focus_ = std::clamp(card, 0, std::max(size() - 1, 0)); }

int CardGrid::first_row(const GridPlace& place) const {
  const int row = focus_ / place.columns();
  const int all = (size() + place.columns() - 1) / place.columns();
  const int first = std::clamp(scrolled_, row - place.rows() + 1, row);
  return std::clamp(first, 0, std::max(all - place.rows(), 0));
}

bool CardGrid::shows(int card, const GridPlace& place) const {
  const int row = card / place.columns() - first_row(place);
  return row >= 0 && row < place.rows();
}

void CardGrid::move(int right, int down, int columns) {
  if (right != 0) focus_ = sum_around(focus_, right, size());
  const int last_row = (size() - 1) / columns;
  for (; down > 0; --down) {
    const bool is_last = focus_ / columns == last_row;
    focus_ = is_last ? focus_ % columns : std::min(focus_ + columns, size() - 1);
  }
  for (; down < 0; ++down) {
    const bool is_first = focus_ < columns;
    focus_ = is_first ? std::min(last_row * columns + focus_, size() - 1) : focus_ - columns;
  }
}

std::optional<int> CardGrid::card_at(Vec2 mouse, const GridPlace& place) const {
  const Vec2 at = mouse - place.top_left;
  const Vec2 cell = place.cell();
  if (at.x < 0.0 || at.y < 0.0 || at.x >= cell.x * place.columns() || at.y >= cell.y * place.rows())
    return std::nullopt;
  const int row = first_row(place) + static_cast<int>(at.y / cell.y);
  const int card = row * place.columns() + static_cast<int>(at.x / cell.x);
  return card < size() ? std::optional(card) : std::nullopt;
}

std::optional<int> CardGrid::update(const MenuInput& input, const GridPlace& place) {
  if (cards_.empty()) return std::nullopt;
  scrolled_ = first_row(place);
  const auto under_mouse = card_at(input.mouse, place);
  if (under_mouse && (input.mouse_moved || input.clicked)) focus_ = *under_mouse;
  move(input.right, input.down, place.columns());
  scrolled_ = first_row(place);
  if (input.accept || (input.clicked && under_mouse)) return focus_;
  return std::nullopt;
}

void CardGrid::draw_card(Canvas& canvas, Vec2 at, const GridPlace& place, int card) const {
  const PictureCard& shown = cards_[static_cast<std::size_t>(card)];
  const double unit = place.scale;
  const bool focused = card == focus_;
  const Vec2 corner = at + Vec2{around_card * unit, around_card * unit};
  const Vec2 size = place.cell() - Vec2{2.0 * around_card * unit, 2.0 * around_card * unit};
  if (focused)
    canvas.panel(corner - Vec2{3.0 * unit, 3.0 * unit}, size + Vec2{6.0 * unit, 6.0 * unit}, 11.0 * unit, style::gold);
  canvas.panel(corner, size, 9.0 * unit, focused ? style::focus_card : style::card);
  const Vec2 picture = corner + Vec2{frame * unit, frame * unit};
  const double width = size.x - 2.0 * frame * unit;
  engine::TexturedMesh mesh;
  const engine::Color tint = shown.picture != nullptr ? style::white : style::night_top;
  add_rectangle(mesh, picture, {width, 0.5 * width}, tint, tint);
  canvas.textured(mesh, {shown.picture, engine::Filter::linear, engine::Wrap::clamp, engine::Wrap::clamp});
  const double left = picture.x + 3.0 * unit;
  double y = picture.y + 0.5 * width + 2.0 * unit;
  for (const std::string& title : wrapped(canvas, shown.title, title_size * unit, width - 6.0 * unit, 1)) {
    canvas.text({left, y}, title, title_size * unit, focused ? style::white : style::faint);
  }
  y += canvas.line_height(title_size * unit);
  canvas.text({left, y}, shown.time, time_size * unit, style::faint);
  if (shown.medal == Medal::none) return;
  const double radius = 8.0 * unit;
  draw_medal(canvas, {picture.x + width - radius - 3.0 * unit, y + 0.5 * canvas.line_height(time_size * unit)}, radius,
             shown.medal);
}

void CardGrid::draw(Canvas& canvas, const GridPlace& place) const {
  const int first = first_row(place) * place.columns();
  const int last = std::min(first + place.rows() * place.columns(), size());
  const Vec2 cell = place.cell();
  for (int card = first; card < last; ++card) {
    const int row = (card - first) / place.columns();
    const int column = (card - first) % place.columns();
    draw_card(canvas, place.top_left + Vec2{column * cell.x, row * cell.y}, place, card);
  }
  draw_scroll_bar(canvas, place);
}

void CardGrid::draw_scroll_bar(Canvas& canvas, const GridPlace& place) const {
  const int all = (size() + place.columns() - 1) / place.columns();
  if (all <= place.rows()) return;
  const double width = bar * place.scale;
  const double height = place.rows() * place.cell().y;
  const Vec2 top = place.top_left + Vec2{place.size.x - width, 0.0};
  canvas.panel(top, {width, height}, 0.5 * width, style::shade);
  canvas.panel(top + Vec2{0.0, height * first_row(place) / all}, {width, height * place.rows() / all}, 0.5 * width,
               style::faint);
}

void draw_medal(Canvas& canvas, Vec2 center, double radius, Medal medal) {
  const auto disc = [&](double r, engine::Color color) {
    canvas.panel(center - Vec2{r, r}, {2.0 * r, 2.0 * r}, r, color);
  };
  const engine::Color color = style::of_medal(medal);
  disc(radius, style::dark_of(color));
  disc(0.86 * radius, color);
  disc(0.62 * radius, style::dark_of(color));
  disc(0.52 * radius, color);
}

}  // namespace game
