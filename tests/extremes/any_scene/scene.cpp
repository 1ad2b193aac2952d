#include "tests/extremes/any_scene/scene.h"

#include <algorithm>

namespace any_scene {

std::string_view name(Preset preset) {
  constexpr std::string_view names[] = {"fast", "balanced", "accurate", "ample"};
  return names[static_cast<std::size_t>(preset)];
}

ribbon::Accuracy accuracy_of(Preset preset) {
  constexpr int ample_work = 20'000;
  if (preset == Preset::fast) return ribbon::Accuracy::fast();
  if (preset == Preset::accurate) return ribbon::Accuracy::accurate();
  ribbon::Accuracy accuracy = ribbon::Accuracy::balanced();
  if (preset == Preset::ample) accuracy.max_work = ample_work;
  return accuracy;
}

bool is_driven(const Scene& scene) {
  const bool climbs =
      std::any_of(scene.holds.begin(), scene.holds.end(), [](const Hold& hold) { return hold.climb_to >= 0.0; });
  const bool moves = std::any_of(scene.solids.begin(), scene.solids.end(), [](const Solid& solid) {
    if (solid.belt_speed != 0.0) return true;
    return solid.motion == Motion::kinematic && (solid.velocity != ribbon::Vec2{} || solid.angular_velocity != 0.0);
  });
  const bool turns = std::any_of(scene.wheels.begin(), scene.wheels.end(), [](const Wheel& wheel) {
    return wheel.def.motor_torque > 0.0 && wheel.def.motor_speed != 0.0;
  });
  return climbs || moves || turns || !scene.drags.empty() || !scene.reels.empty();
}

bool holds(const Scene& scene, int solid, int cord) {
  return std::any_of(scene.holds.begin(), scene.holds.end(),
                     [&](const Hold& hold) { return hold.solid == solid && hold.cord == cord; });
}

bool carries(const Scene& scene, int solid, int cord) {
  return std::any_of(scene.wheels.begin(), scene.wheels.end(),
                     [&](const Wheel& wheel) { return wheel.solid == solid && wheel.cord == cord; });
}

bool is_on_wheel(const Scene& scene, int cord, double column) {
  return std::any_of(scene.wheels.begin(), scene.wheels.end(), [&](const Wheel& wheel) {
    return wheel.cord == cord && column > wheel.def.before && column < wheel.def.after;
  });
}

int points(const Scene& scene) {
  int sum = 0;
  for (const SceneCord& cord : scene.cords) sum += cord.def.points * cord.def.rows;
  return sum;
}

}  // namespace any_scene
