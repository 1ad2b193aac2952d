#include "tests/support/autopilot.h"

#include "game/simulation/buttons.h"
#include "game/simulation/level.h"
#include "ribbon/box2d/convert.h"
#include "tests/support/scripted_player.h"

namespace test_support {
namespace {

using ribbon::Vec2;

constexpr double edge_of_start = 7.2;  // m, where it jumps
constexpr double landing = 27.5;       // m, on the ground before the hammock
constexpr double landing_speed = 1.5;  // m/s
constexpr double step_up = 39.6;       // m, where the ground rises to the goal
constexpr double let_go_angle = 0.62;  // horizontal part of the unit vector from the cord's top to the player
constexpr double let_go_climb = 0.5;   // m/s, upwards, at least
constexpr int most_ticks_on_cord = 900;

Vec2 velocity(const game::Simulation& simulation) {
  return ribbon::box2d::to_double(simulation.player().body().GetLinearVelocity());
}

bool hangs_free(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord) {
  const auto end = static_cast<int>(coupling.cord(cord).positions().size()) - 1;
  return coupling.cord(cord).kind(end) == ribbon::PointKind::free;
}

}  // namespace

const game::Level& first_swing_level() {
  static const game::Level level = game::load_level("first_swing");
  return level;
}

std::uint16_t Autopilot::buttons(const game::Simulation& simulation) {
  const auto held = simulation.scene().coupling().body(simulation.player().body()).held_place();
  if (held) return hang(simulation, *held);
  ticks_on_cord_ = 0;
  return fly_or_run(simulation);
}

std::uint16_t Autopilot::hang(const game::Simulation& simulation, const ribbon::box2d::CordPoint& held) {
  last_cord_ = held.cord;
  ++ticks_on_cord_;
  const Vec2 top = simulation.scene().coupling().cord(held.cord).positions()[0];
  const Vec2 from_top = simulation.player().position() - top;
  const Vec2 v = velocity(simulation);
  const bool far_out = from_top.x > let_go_angle * length(from_top);
  if ((far_out && v.x > 0.0 && v.y > let_go_climb) || ticks_on_cord_ > most_ticks_on_cord) return game::button_right;
  return static_cast<std::uint16_t>(game::button_grab | pumping(simulation, top));
}

std::uint16_t Autopilot::fly_or_run(const game::Simulation& simulation) const {
  const game::Player& player = simulation.player();
  const double x = player.position().x;
  const bool may_land = !player.is_on_ground() && x > landing && x < step_up;
  if (may_land && velocity(simulation).x > landing_speed) return game::button_left;
  std::uint16_t buttons = game::button_right;
  const bool at_edge = x > edge_of_start && x < edge_of_start + 1.5;
  const bool at_step = x > step_up && velocity(simulation).x < 1.0;
  if (player.is_on_ground() && (at_edge || at_step)) buttons |= game::button_jump;
  if (!player.is_on_ground()) {
    if (velocity(simulation).y > 0.0) buttons |= game::button_jump;
    const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
    const auto near = coupling.nearest_point(player.hand(), player.tuning().grab_range);
    // Not the cord that it has just left, which is still in range; and only cords with a free end.
    if (near && near->cord != last_cord_ && hangs_free(coupling, near->cord)) buttons |= game::button_grab;
  }
  return buttons;
}

}  // namespace test_support
