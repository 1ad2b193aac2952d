#include "game/screens/yard_screen.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "game/screens/play_screen.h"
#include "game/screens/style.h"

namespace game {
namespace {

using engine::Canvas;
using engine::Color;
using engine::Key;
using engine::PadButton;
using ribbon::Vec2;

constexpr Color fine{255, 212, 92};
constexpr Color wrong{255, 110, 96};
constexpr Color picked{120, 200, 255};

/// The items of the palette behind those of the things.
enum YardItem : int { move = static_cast<int>(all_things.size()), remove, clear, done };

const char* title_of(Thing thing) {
  switch (thing) {
    case Thing::rope: return words::yard_rope;
    case Thing::hanging_rope: return words::yard_hanging_rope;
    case Thing::curtain: return words::yard_curtain;
    case Thing::trampoline: return words::yard_trampoline;
    case Thing::crate: return words::yard_crate;
    case Thing::ball: return words::yard_ball;
    case Thing::peg: break;
  }
  return words::yard_peg;
}

const char* words_of(PlacingFault fault) {
  switch (fault) {
    case PlacingFault::too_many: return words::yard_too_many;
    case PlacingFault::outside: return words::yard_outside;
    case PlacingFault::too_short: return words::yard_too_short;
    case PlacingFault::too_long: return words::yard_too_long;
    case PlacingFault::in_the_way: break;
  }
  return words::yard_in_the_way;
}

/// Returns −1, 0 or 1 by two sets of keys or buttons that are held.
double axis(const engine::WindowInput& input, std::array<engine::InputCode, 3> plus,
            std::array<engine::InputCode, 3> minus) {
  const auto any = [&input](const auto& codes) {
    return std::any_of(codes.begin(), codes.end(), [&input](const auto& code) { return input.held(code); });
  };
  return (any(plus) ? 1.0 : 0.0) - (any(minus) ? 1.0 : 0.0);
}

void draw_thing(Canvas& canvas, const PlacedThing& thing, Color color) {
  constexpr double width = 0.06;  // m
  if (has_two_ends(thing.thing)) canvas.polyline(std::array{thing.first, thing.second}, width, color);
  canvas.ring(thing.first, has_two_ends(thing.thing) ? 0.15 : 0.45, width, color);
  canvas.ring(thing.second, 0.15, width, color);
}

}  // namespace

YardScreen::YardScreen(Session& session, PlayScreen& play) : session_(&session), play_(&play) {
  card_.headline = words::yard_headline;
  card_.width = 215.0;
  card_.text_size = 15.0;
  card_.line_size = 14.0;
  std::vector<MenuItem> items;
  for (const Thing thing : all_things) items.push_back({title_of(thing)});
  items.insert(items.end(), {{words::yard_move}, {words::yard_remove}, {words::yard_clear}, {words::yard_done}});
  menu_.set_items(std::move(items));
}

void YardScreen::shown() {
  play_->played().begin_building();
  const Player& player = play_->simulation().player();
  pointer_ = player.position() + Vec2{player.faces_left() ? -2.0 : 2.0, 1.0};
}

void YardScreen::leave() { play_->end_building(); }

MenuPlace YardScreen::place_of(const Canvas& canvas, double text_scale) const {
  return menu_place(canvas, text_scale, card_, static_cast<int>(menu_.items().size()));
}

Next YardScreen::update(const Frame& frame) {
  card_.side = play_->free_side(frame.canvas);
  card_.lines = {status()};
  const engine::WindowInput& input = frame.input;
  const bool stops = frame.menu.back || session_->settings.bindings.pressed(Action::palette, input);
  if (stops && !tool_.begun()) return Next::back();
  if (stops) tool_.forget();
  move_pointer(frame);

  const auto pressed = [&input](const engine::InputCode& code) { return input.pressed(code); };
  MenuInput menu;
  menu.mouse = input.mouse;
  menu.clicked = input.pressed(engine::MouseButton::left);
  if (pressed(Key::tab) || pressed(PadButton::right_shoulder) || pressed(engine::WheelTurn::down)) ++menu.down;
  if (pressed(PadButton::left_shoulder) || pressed(engine::WheelTurn::up)) --menu.down;
  const int before = menu_.focus();
  const auto clicked = menu_.update(menu, place_of(frame.canvas, frame.text_scale));
  if (menu_.focus() != before) choose(-1);
  if (clicked) return choose(clicked->item) == Chosen::done ? Next::back() : Next::stay();
  if (frame.menu.accept) {
    if (menu_.focus() < clear) {
      use_tool();
    } else if (choose(menu_.focus()) == Chosen::done) {
      return Next::back();
    }
  }
  const Rectangle card = card_place(frame.canvas, frame.text_scale, card_, static_cast<int>(menu_.items().size()));
  follow_button(frame, shared_area(card, {input.mouse, {1.0, 1.0}}) > 0.0);
  return Next::stay();
}

/// Takes the tool that has the focus. Clears the yard if `item` is that line.
YardScreen::Chosen YardScreen::choose(int item) {
  fault_.reset();
  const int focus = menu_.focus();
  if (focus < move) {
    tool_.take(YardTool::Kind::place, all_things[static_cast<std::size_t>(focus)]);
  } else {
    tool_.take(focus == move ? YardTool::Kind::move : YardTool::Kind::remove);
  }
  if (item == clear) {
    Yard yard = play_->simulation().level().yard;
    yard.things.clear();
    play_->played().build(yard);
  }
  return item == done ? Chosen::done : Chosen::a_tool;
}

void YardScreen::move_pointer(const Frame& frame) {
  const engine::WindowInput& input = frame.input;
  Vec2 speed = input.left_stick;
  speed.x += axis(input, {Key::right, Key::d, PadButton::dpad_right}, {Key::left, Key::a, PadButton::dpad_left});
  speed.y += axis(input, {Key::up, Key::w, PadButton::dpad_up}, {Key::down, Key::s, PadButton::dpad_down});
  pointer_ += 1e-9 * static_cast<double>(frame.elapsed_ns) * pointer_speed * speed;
  if (input.mouse_moved || input.pressed(engine::MouseButton::left)) pointer_ = frame.canvas.to_world(input.mouse);
  const Vec2 low = frame.canvas.to_world({0.0, 1.0 * frame.canvas.height()});
  const Vec2 high = frame.canvas.to_world({1.0 * frame.canvas.width(), 0.0});
  pointer_ = {std::clamp(pointer_.x, low.x, high.x), std::clamp(pointer_.y, low.y, high.y)};
}

void YardScreen::use_tool() {
  YardTool::Outcome outcome = tool_.use(pointer_, play_->simulation());
  fault_ = outcome.fault;
  if (outcome.changed) play_->played().build(*outcome.changed);
}

/// A press uses the tool; so does a release after a way with the button down, which gives the second end.
void YardScreen::follow_button(const Frame& frame, bool over_palette) {
  const auto button = static_cast<std::size_t>(engine::MouseButton::left);
  if (frame.input.buttons_pressed[button] && !over_palette) {
    pressed_ = pointer_;
    use_tool();
  }
  if (!frame.input.buttons_released[button] || !pressed_) return;
  if (length(pointer_ - *std::exchange(pressed_, std::nullopt)) > drag_distance && tool_.begun()) use_tool();
}

std::string YardScreen::status() const {
  if (fault_) {
    return words::filled(words_of(*fault_), {{"count", std::to_string(Yard::max_things)},
                                             {"least", std::to_string(static_cast<int>(Yard::min_span))},
                                             {"most", std::to_string(static_cast<int>(Yard::max_span))}});
  }
  const std::size_t count = play_->simulation().level().yard.things.size();
  return words::filled(words::yard_count,
                       {{"count", std::to_string(count)}, {"most", std::to_string(Yard::max_things)}});
}

/// Draws the pointer, what the tool would do there, and the ends of all things.
void YardScreen::draw_world(Canvas& canvas) const {
  const Simulation& simulation = play_->simulation();
  const Yard& yard = simulation.level().yard;
  if (const auto index = tool_.picked(pointer_, yard)) draw_thing(canvas, yard.things[*index], picked);
  const bool is_wrong = tool_.fault_at(pointer_, simulation).has_value();
  if (const auto thing = tool_.preview(pointer_, yard)) draw_thing(canvas, *thing, is_wrong ? wrong : fine);
  canvas.ring(pointer_, 0.22, 0.05, style::white);
  canvas.circle(pointer_, 0.06, style::white);
}

void YardScreen::draw(Canvas& canvas, double text_scale) {
  draw_world(canvas);
  card_.side = play_->free_side(canvas);
  card_.lines = {status()};
  draw_card(canvas, text_scale, card_, static_cast<int>(menu_.items().size()));
  menu_.draw(canvas, place_of(canvas, text_scale));
  draw_keys_line(canvas, text_scale, session_->uses_pad ? words::yard_buttons : words::yard_keys);
}

}  // namespace game
