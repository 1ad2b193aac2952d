#include "game/view/figure_state.h"

#include <cstddef>

#include "ribbon/box2d/convert.h"

namespace game {
namespace {

using ribbon::Vec2;
using ribbon::box2d::CordPoint;
using ribbon::box2d::Coupling;

constexpr double known_above = 0.7;  // m of cord above the hand that a figure knows
constexpr double below = 1.8;        // m below it

const std::vector<Vec2>& points_of(const Snapshot& now, const CordPoint& held) {
  return now.cords[static_cast<std::size_t>(held.cord)];
}

Vec2 position(const ribbon::box2d::CordView& cord, const Snapshot& now, const CordPoint& held) {
  const std::vector<Vec2>& x = points_of(now, held);
  const auto point = static_cast<std::size_t>(held.point);
  if (held.along == 0.0) return x[point];
  return x[point] + held.along * (x[point + static_cast<std::size_t>(cord.shape().rows)] - x[point]);
}

/// Returns whether a held place hangs from the first end of its cord: there is the nearest pin, or, without a pin, this
/// end is the higher one.
bool hangs_from_first(const ribbon::box2d::CordView& cord, const Snapshot& now, const CordPoint& held) {
  const int size = static_cast<int>(points_of(now, held).size());
  for (int away = 0; away < size; ++away) {
    for (const int p : {held.point - away, held.point + away}) {
      if (p >= 0 && p < size && cord.kind(p) == ribbon::PointKind::constrained) return p <= held.point;
    }
  }
  return points_of(now, held).front().y >= points_of(now, held).back().y;
}

/// Returns the held position and the points of the cord from there on, towards its first end (−1) or its last (1), up
/// to `enough` m.
std::vector<Vec2> walk(const ribbon::box2d::CordView& cord, const Snapshot& now, const CordPoint& held, int direction,
                       double enough) {
  const std::vector<Vec2>& x = points_of(now, held);
  const int step = direction * cord.shape().rows;
  std::vector<Vec2> way{position(cord, now, held)};
  const bool is_between = held.along > 0.0;
  double walked = 0.0;
  for (int p = is_between && direction < 0 ? held.point : held.point + step;
       p >= 0 && p < static_cast<int>(x.size()) && walked < enough; p += step) {
    const Vec2 next = x[static_cast<std::size_t>(p)];
    walked += length(next - way.back());
    way.push_back(next);
  }
  return way;
}

/// Adds the held cord to the state.
void hold(FigureState& state, const Coupling& coupling, const Snapshot& now, const CordPoint& held) {
  const ribbon::box2d::CordView cord = coupling.cord(held.cord);
  const int up = hangs_from_first(cord, now, held) ? -1 : 1;
  HeldCord& around = state.cord.emplace();
  around.above = walk(cord, now, held, up, known_above);
  around.below = walk(cord, now, held, -up, below);
  around.climbed = up * cord.arc(held.point, held.along);
}

}  // namespace

Vec2 held_position(const Coupling& coupling, const Snapshot& now, const CordPoint& held) {
  return position(coupling.cord(held.cord), now, held);
}

std::optional<Vec2> held_position(const Coupling& coupling, const Snapshot& now, const b2Body& body) {
  const auto held = coupling.body(body).held_place();
  if (!held) return std::nullopt;
  return held_position(coupling, now, *held);
}

FigureState figure_of(const Simulation& simulation, const Snapshot& now, double time, int number) {
  const Player& player = simulation.player(number);
  const Coupling& coupling = simulation.scene().coupling();
  FigureState state;
  const std::size_t newer =
      static_cast<std::size_t>(simulation.players() - number);  // the players are the newest bodies
  state.at = now.bodies[now.bodies.size() - newer].position;
  state.velocity = ribbon::box2d::to_double(player.body().GetLinearVelocity());
  state.faces_left = player.faces_left();
  state.on_ground = player.is_on_ground();
  state.time = time;
  state.climbs = player.is_climbing();
  if (const auto held = player.held_place(coupling)) hold(state, coupling, now, *held);
  if (const auto& ledge = player.ledge()) {
    state.ledge = ledge->edge;
    state.faces_left = ledge->side < 0;
  }
  for (const Line& line : player.lines().all()) {
    if (line.state() == Line::State::flying) state.throws_at = line.end();
  }
  if (const auto goal = simulation.goal_ticks()) state.cheers = time - 1.0 * *goal / ticks_per_second;
  return state;
}

FigureState figure_of(const GhostPose& ghost, double time) {
  FigureState state;
  state.at = ghost.at;
  state.velocity = ghost.velocity;
  state.faces_left = ghost.faces_left;
  state.on_ground = ghost.on_ground;
  if (ghost.held) state.cord = HeldCord{{*ghost.held}, {*ghost.held}, 0.0};
  state.time = time;
  return state;
}

}  // namespace game
