#include "game/simulation/chase.h"

#include <algorithm>

#include "game/simulation/level_cords.h"
#include "game/simulation/tick_rate.h"

namespace game {
namespace {

using ribbon::Vec2;

constexpr double fall = 9.81;  // m/s², of a chaser that lost its cord
constexpr int most_falling_ticks = 600;

/// Returns how many cords come from an object of the map: more than one if it was cut or broke.
int pieces_of(const engine::Scene& scene, int object) {
  int count = 0;
  for (const ribbon::box2d::CordId id : scene.coupling().cords()) count += scene.cord_object(id) == object ? 1 : 0;
  return count;
}

Vec2 place_on_track(const Chaser& chaser, int ticks) {
  const double distance = chaser.start + chaser.speed * ticks / ticks_per_second;
  return chaser.track.at(chaser.track.is_closed() ? distance : std::min(distance, chaser.track.length()));
}

}  // namespace

void Chase::start(const std::vector<Chaser>& chasers, const engine::Scene& scene) {
  places_.resize(chasers.size());
  bridges_.assign(chasers.size(), {});
  go_back(chasers);
  for (std::size_t k = 0; k < chasers.size(); ++k) {
    for (const ribbon::box2d::CordId id : scene.coupling().cords()) {
      if (chasers[k].cord == 0 || scene.cord_object(id) != chasers[k].cord) continue;
      const auto x = scene.coupling().cord(id).positions();
      bridges_[k] = {std::min(x.front().x, x.back().x), std::max(x.front().x, x.back().x)};
    }
  }
}

void Chase::go_back(const std::vector<Chaser>& chasers) {
  for (std::size_t k = 0; k < chasers.size(); ++k) {
    const Vec2 at = place_on_track(chasers[k], 0);
    places_[k] = {!chasers[k].from_x, 0, 0, at, at};
  }
}

void Chase::notice(const std::vector<Chaser>& chasers, double x) {
  for (std::size_t k = 0; k < chasers.size(); ++k) {
    if (chasers[k].from_x && x >= *chasers[k].from_x) places_[k].runs = true;
  }
}

void Chase::advance(const std::vector<Chaser>& chasers, const engine::Scene& scene) {
  for (std::size_t k = 0; k < chasers.size(); ++k) {
    Place& place = places_[k];
    place.before = place.at;
    if (!place.runs) continue;
    const bool is_over_gap = place.at.x > bridges_[k].left && place.at.x < bridges_[k].right;
    if (place.falling_ticks > 0 || (is_over_gap && pieces_of(scene, chasers[k].cord) != 1)) {
      if (place.falling_ticks == most_falling_ticks) continue;
      ++place.falling_ticks;
      place.at.y -= fall * place.falling_ticks / (ticks_per_second * ticks_per_second);
    } else {
      place.at = place_on_track(chasers[k], ++place.ticks);
    }
  }
}

bool Chase::touches(const std::vector<Chaser>& chasers, const Player& player) const {
  for (std::size_t k = 0; k < chasers.size(); ++k) {
    if (!chasers[k].round) {
      if (player.touches({places_[k].at, chasers[k].area.size})) return true;
      continue;
    }
    // The player is the set of places within its radius of an upright line.
    const double radius = player.tuning().radius;
    const double straight = 0.5 * player.tuning().height - radius;
    const Vec2 off = places_[k].at - player.position();
    const Vec2 gap{off.x, off.y - std::clamp(off.y, -straight, straight)};
    if (length(gap) <= radius + 0.5 * chasers[k].area.size.x) return true;
  }
  return false;
}

Vec2 Chase::position(std::size_t chaser, double alpha) const {
  return places_[chaser].before + alpha * (places_[chaser].at - places_[chaser].before);
}

void Chase::add_to(ribbon::box2d::Hasher& hasher) const {
  for (const Place& place : places_) {
    hasher.add(static_cast<int>(place.runs));
    hasher.add(place.ticks);
    hasher.add(place.falling_ticks);
    hasher.add(place.at);
  }
}

}  // namespace game
