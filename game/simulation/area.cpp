#include "game/simulation/area.h"

#include <algorithm>

namespace game {
namespace {

using ribbon::Vec2;

constexpr double least_height = 1.2;  // m, of a goal
constexpr double over_goal = 0.9;     // m, of the pole over the upper edge of the goal
constexpr double pole_width = 0.13;   // m
constexpr Vec2 cloth_size{1.45, 0.9};
constexpr double below_top = 0.06;  // m, from the top of the pole to the cloth

}  // namespace

Flag flag_of(const Area& goal) {
  const Vec2 foot = goal.center - Vec2{0.0, 0.5 * goal.size.y};
  const double height = std::max(goal.size.y, least_height) + over_goal;
  const Vec2 top = foot + Vec2{0.0, height};
  return {foot,
          top,
          {foot + Vec2{0.0, 0.5 * height}, {pole_width, height}},
          {top + Vec2{0.5 * cloth_size.x, -below_top - 0.5 * cloth_size.y}, cloth_size}};
}

}  // namespace game
