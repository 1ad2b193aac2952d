#include "ribbon/study/motion.h"

#include <algorithm>
#include <cmath>

#include "ribbon/box2d/convert.h"
#include "ribbon/study/accuracies.h"
#include "ribbon/study/conditions.h"

namespace ribbon::study {
namespace {

constexpr double max_coordinate = 1e6;  // m, of what has not blown up

Frame frame_of(const Scene& scene) {
  Frame frame;
  for (const box2d::CordId c : scene.coupling.cords()) {
    if (scene.coupling.cord(c).solver() != box2d::Solver::direct) continue;
    const auto places = scene.coupling.cord(c).positions();
    frame.cords.emplace_back(c, std::vector<Vec2>(places.begin(), places.end()));
    frame.is_converged = frame.is_converged && scene.coupling.cord(c).island_report().unconverged == 0;
  }
  for (const b2Body* body = scene.world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    if (body->GetType() == b2_dynamicBody) frame.bodies.push_back(box2d::to_double(body->GetPosition()));
  }
  frame.work = scene.coupling.last_step().report().work;
  return frame;
}

bool is_in_bounds(Vec2 place) { return std::abs(place.x) <= max_coordinate && std::abs(place.y) <= max_coordinate; }

bool is_in_bounds(const Frame& frame) {
  const auto all = [](const std::vector<Vec2>& places) {
    return std::all_of(places.begin(), places.end(), [](Vec2 place) { return is_in_bounds(place); });
  };
  return all(frame.bodies) &&
         std::all_of(frame.cords.begin(), frame.cords.end(), [&all](const auto& cord) { return all(cord.second); });
}

}  // namespace

Motion play(const MakeScene& make, const Part& part) {
  const Scene scene = make();
  Accuracies accuracies;
  for (int tick = 0; tick < part.begin; ++tick) {
    if (tick + part.lead_in >= part.begin) accuracies.set(scene.coupling, lead_in_accuracy);
    scene.tick(tick);
  }
  if (part.kick != 0.0) kick(scene.world, scene.coupling, part.kick);
  Motion motion;
  for (int tick = part.begin; tick < part.begin + part.ticks; ++tick) {
    accuracies.set(scene.coupling, part.accuracy);
    scene.tick(tick);
    motion.frames.push_back(frame_of(scene));
    if (is_in_bounds(motion.frames.back())) continue;
    motion.failure = "blew up in tick " + std::to_string(tick + 1);
    break;
  }
  return motion;
}

void kick(b2World& world, box2d::Coupling& coupling, double speed) {
  for (const box2d::CordId c : coupling.cords()) {
    if (coupling.cord(c).solver() != box2d::Solver::direct) continue;
    Cord& cord = coupling.cord(c).direct();
    for (int p = 0; p < static_cast<int>(cord.velocities().size()); ++p) {
      cord.set_velocity(p, cord.velocities()[static_cast<std::size_t>(p)] + Vec2{speed, 0.0});
    }
  }
  for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    if (body->GetType() != b2_dynamicBody) continue;
    body->SetLinearVelocity(body->GetLinearVelocity() + b2Vec2{static_cast<float>(speed), 0.0F});
  }
}

void Differences::add(Vec2 off) {
  squares += dot(off, off);
  ++count;
  most = std::max(most, length(off));
}

Differences& Differences::operator+=(const Differences& other) {
  squares += other.squares;
  count += other.count;
  most = std::max(most, other.most);
  return *this;
}

double Differences::root() const { return count > 0.0 ? std::sqrt(squares / count) : 0.0; }

Differences cord_differences(const Frame& a, const Frame& b) {
  Differences all;
  for (const auto& [id, places] : a.cords) {  // both ascend
    const auto other = std::lower_bound(b.cords.begin(), b.cords.end(), id,
                                        [](const auto& cord, box2d::CordId wanted) { return cord.first < wanted; });
    if (other == b.cords.end() || other->first != id || other->second.size() != places.size()) continue;
    for (std::size_t p = 0; p < places.size(); ++p) all.add(places[p] - other->second[p]);
  }
  return all;
}

Differences body_differences(const Frame& a, const Frame& b) {
  Differences all;
  if (a.bodies.size() != b.bodies.size()) return all;
  for (std::size_t k = 0; k < a.bodies.size(); ++k) all.add(a.bodies[k] - b.bodies[k]);
  return all;
}

}  // namespace ribbon::study
