#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "engine/scene/scene.h"
#include "game/simulation/level.h"
#include "game/simulation/player.h"
#include "game/simulation/target.h"
#include "game/simulation/tether.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/vec2.h"

namespace game {

/// What a run remembers of one of its players, besides the Player.
struct Seat {
  Targets targets{};                    ///< of its lines
  std::optional<std::size_t> inside{};  ///< the checkpoint in which it is
  ribbon::Vec2 foothold{};              ///< m, feet: the position after a fall with the assist no_fall
  ribbon::Vec2 next_foothold{};         ///< m, feet: becomes foothold if the player keeps standing
  int standing_ticks = 0;               ///< on firm ground
  std::uint16_t buttons_before = 0;
};

/// The buttons of both players in a tick; 0 for one that does not exist.
using ButtonsOfBoth = std::array<std::uint16_t, 2>;

/// The player of a run, or both, with the rope between them.
class Players {
 public:
  /// State between two ticks.
  struct State {
    std::optional<Player> first;
    std::optional<Player> second;
    std::optional<Tether> tether;
    std::array<Seat, 2> seats;
  };

  /// Makes the players of a new scene, which do not touch each other. `tied`: also the rope between them, if the level
  /// has one.
  void make(const Level& level, engine::Scene& scene, bool tied);
  /// Removes them. Their scene may end then.
  void clear();

  int count() const { return all_[1] ? 2 : 1; }
  Player& operator[](int number) { return *all_[static_cast<std::size_t>(number)]; }
  const Player& operator[](int number) const { return *all_[static_cast<std::size_t>(number)]; }
  Seat& seat(int number) { return seats_[static_cast<std::size_t>(number)]; }
  const Seat& seat(int number) const { return seats_[static_cast<std::size_t>(number)]; }
  const std::optional<Tether>& tether() const { return tether_; }
  /// The cord that the other player holds in its hand.
  std::optional<ribbon::box2d::CordId> held_by_other(int number, const engine::Scene& scene) const;

  /// Takes the buttons of a tick and returns those that were pressed in it.
  std::array<unsigned, 2> press(const ButtonsOfBoth& buttons);
  /// A key that is down since before the players were put back or made anew is no new press.
  void hold_buttons();
  /// A player that holds no line reels the rope between the two. One that stands still on the ground braces itself.
  void reel_tether(const ButtonsOfBoth& buttons, engine::Scene& scene, double dt);
  /// Puts them at rest at these feet, m. Returns whether the rope between them was laid anew.
  bool put_at(ribbon::Vec2 first, ribbon::Vec2 second, engine::Scene& scene);
  /// Sets the foothold to a position at which the player stood a while earlier, since the last position is often the
  /// edge of a fall.
  void update_foothold(int number);

  void save(State& state) const;
  void restore(const State& state);
  /// Does so but for the seats.
  void put_back(const State& state);
  /// Adds one player to a hash. `level`: that of make().
  void add_to(ribbon::box2d::Hasher& hasher, int number, const Level& level, const engine::Scene& scene) const;

 private:
  std::array<std::unique_ptr<Player>, 2> all_;  // the second one is null in a run of one
  std::optional<Tether> tether_;
  std::array<Seat, 2> seats_;
};

}  // namespace game
