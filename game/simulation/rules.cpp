#include "game/simulation/rules.h"

#include <cmath>
#include <numeric>
#include <utility>

#include "game/simulation/buttons.h"
#include "game/simulation/knife.h"

namespace game {
namespace {

constexpr ribbon::Vec2 coin_size{0.5, 0.5};  // m

}  // namespace

void Rules::start(const LevelRules& level, const engine::Scene& scene) {
  level_ = &level;
  blades_.start(level.blades, scene);
  burning_ = {};
  chase_.start(level.chasers, scene);
  water_ = {};
  coins_.assign(level.coins.size(), 0);
}

/// Returns the weather of a scene with water, or null.
const ribbon::WeatherDef* Rules::water_of(const engine::Scene& scene) {
  const bool has_water = scene.weather() && std::isfinite(scene.weather()->def().water_level);
  return has_water ? &scene.weather()->def() : nullptr;
}

void Rules::act(std::size_t number, unsigned pressed, Player& player, engine::Scene& scene) {
  if (level_->knife && (pressed & button_cut) != 0) cut_by_hand(player, scene.coupling());
  if (const auto* const water = water_of(scene)) water_.swim(*water, number, pressed, player, scene.coupling());
}

void Rules::before(engine::Scene& scene, double dt) {
  if (const auto* const water = water_of(scene)) water_.act(*water, scene.world(), dt);
}

void Rules::after(engine::Scene& scene) {
  burning_.burn(level_->fires, scene);
  blades_.cut(level_->blades, scene);
  chase_.advance(level_->chasers, scene);
}

bool Rules::meet(const Player& player) {
  for (std::size_t k = 0; k < coins_.size(); ++k) {
    if (coins_[k] == 0 && player.touches({level_->coins[k], coin_size})) coins_[k] = 1;
  }
  chase_.notice(level_->chasers, player.position().x);
  for (const Fire& fire : level_->fires) {
    if (player.touches(fire.area)) return true;
  }
  for (const Area& area : level_->spikes) {
    if (player.touches(area)) return true;
  }
  return chase_.touches(level_->chasers, player);
}

void Rules::cords_were_put(const engine::Scene& scene) {
  if (!level_->blades.empty()) blades_.store(scene);
}

void Rules::return_to(const Rules& start) {
  std::vector<std::uint8_t> coins = std::move(coins_);
  *this = start;
  coins_ = std::move(coins);
}

int Rules::coins() const { return std::accumulate(coins_.begin(), coins_.end(), 0); }

void Rules::add_to(ribbon::box2d::Hasher& hasher, const engine::Scene& scene) const {
  blades_.add_to(hasher);
  burning_.add_to(hasher);
  chase_.add_to(hasher);
  if (water_of(scene) != nullptr) water_.add_to(hasher);
  if (!scene.rides().empty()) hasher.add(scene.rides().time());
  for (const std::uint8_t coin : coins_) hasher.add(static_cast<int>(coin));
}

}  // namespace game
