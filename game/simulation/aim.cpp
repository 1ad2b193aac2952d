#include "game/simulation/aim.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "ribbon/box2d/convert.h"

namespace game {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_double;
using ribbon::box2d::to_float;

constexpr double pointer_range = 1.5;  // m, from the pointer to a hook that it selects
constexpr double look_ahead = 3.0;     // m, horizontally from the hand to the preferred position of a hook
constexpr double look_up = 5.0;        // m, vertically

/// Directions in which a knot looks for a surface.
constexpr std::array<Vec2, 8> directions_around = {{{0.0, 1.0},
                                                    {0.707, 0.707},
                                                    {-0.707, 0.707},
                                                    {1.0, 0.0},
                                                    {-1.0, 0.0},
                                                    {0.707, -0.707},
                                                    {-0.707, -0.707},
                                                    {0.0, -1.0}}};
/// Directions in which a throw without a pointer looks for a surface, for a player that faces to the right.
constexpr std::array<Vec2, 5> directions_ahead = {
    {{0.5, 0.866}, {0.707, 0.707}, {0.866, 0.5}, {0.259, 0.966}, {0.0, 1.0}}};

/// The first thing that a ray meets, apart from sensors and players, through which lines fly.
class FirstHit : public b2RayCastCallback {
 public:
  float ReportFixture(b2Fixture* fixture, const b2Vec2& point, const b2Vec2& normal, float fraction) override {
    if (fixture->IsSensor() || fixture->GetFilterData().categoryBits == player_category) return -1.0F;
    body = fixture->GetBody();
    at = point;
    outwards = normal;
    return fraction;
  }

  b2Body* body = nullptr;
  b2Vec2 at{0.0F, 0.0F};
  b2Vec2 outwards{0.0F, 0.0F};
};

bool is_sticky(const engine::Scene& scene, const b2Body* body) {
  const auto bodies = scene.bodies();
  return std::any_of(bodies.begin(), bodies.end(),
                     [body](const engine::SceneBody& made) { return made.is_sticky && made.body == body; });
}

bool has_sticky_bodies(const engine::Scene& scene) {
  const auto bodies = scene.bodies();
  return std::any_of(bodies.begin(), bodies.end(), [](const engine::SceneBody& made) { return made.is_sticky; });
}

Target hook_of(const Level& level, std::size_t index) { return {level.hooks[index], nullptr, {0.0F, 0.0F}, index}; }

/// Returns the sticky surface that a ray from the hand in this direction meets first, within `range` m.
std::optional<Target> surface(const engine::Scene& scene, const Player& player, Vec2 direction, double range) {
  const double size = length(direction);
  if (size == 0.0) return std::nullopt;
  const Vec2 from = player.hand();
  FirstHit hit;
  scene.world().RayCast(&hit, to_float(from), to_float(from + (range / size) * direction));
  if (hit.body == nullptr || !is_sticky(scene, hit.body)) return std::nullopt;
  const Vec2 at = to_double(hit.at) + player.line().tuning().radius * to_double(hit.outwards);
  if (hit.body->GetType() == b2_staticBody) return Target{at};
  return Target{at, hit.body, hit.body->GetLocalPoint(to_float(at))};
}

/// Returns the hook that costs least, of those within the throw range whose cost is not above `most`.
template <typename Cost>
std::optional<Target> best_hook(const Level& level, const Player& player, double most, Cost cost_of) {
  std::optional<Target> best;
  for (std::size_t k = 0; k < level.hooks.size(); ++k) {
    if (length(level.hooks[k] - player.hand()) > player.line().tuning().throw_range) continue;
    const double cost = cost_of(level.hooks[k]);
    if (cost > most || (best && cost >= most)) continue;
    most = cost;
    best = hook_of(level, k);
  }
  return best;
}

}  // namespace

std::optional<Target> aimed_target(const Level& level, const engine::Scene& scene, const Player& player,
                                   std::optional<Vec2> pointer) {
  if (pointer) {
    const auto from_pointer = [at = *pointer](Vec2 hook) { return length(hook - at); };
    if (auto hook = best_hook(level, player, pointer_range, from_pointer)) return hook;
  }
  const bool has_sticky = has_sticky_bodies(scene);
  const double range = player.line().tuning().throw_range;
  if (has_sticky && pointer) {
    if (auto found = surface(scene, player, *pointer - player.hand(), range)) return found;
  }
  const double side = player.faces_left() ? -1.0 : 1.0;
  const Vec2 ahead = player.hand() + Vec2{side * look_ahead, look_up};
  if (auto hook = best_hook(level, player, 2.0 * range, [ahead](Vec2 at) { return length(at - ahead); })) return hook;
  for (const Vec2 direction : directions_ahead) {
    if (!has_sticky) break;
    if (auto found = surface(scene, player, {side * direction.x, direction.y}, range)) return found;
  }
  return std::nullopt;
}

std::optional<Target> target_at_hand(const Level& level, const engine::Scene& scene, const Player& player) {
  const double reach = player.tuning().grab_range;
  if (auto hook = best_hook(level, player, reach, [&player](Vec2 at) { return length(at - player.hand()); }))
    return hook;
  if (!has_sticky_bodies(scene)) return std::nullopt;
  std::optional<Target> nearest;
  for (const Vec2 direction : directions_around) {
    const auto found = surface(scene, player, direction, reach);
    if (found && (!nearest || length(found->at - player.hand()) < length(nearest->at - player.hand()))) nearest = found;
  }
  return nearest;
}

}  // namespace game
