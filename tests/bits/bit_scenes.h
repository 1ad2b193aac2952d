#pragma once

#include <box2d/box2d.h>

#include <cstdint>
#include <optional>
#include <ostream>
#include <span>
#include <string_view>

#include "ribbon/box2d/coupling.h"
#include "ribbon/weather.h"

// Small worlds that together use every path of the solvers. Their numbers are the same everywhere: of the C library
// they use no function but √.

namespace bits {

inline constexpr double dt = 1.0 / 60.0;  // s

/// A world with cords in it, between two ticks.
struct BitWorld {
  b2World world{b2Vec2(0.0F, -9.81F)};
  std::optional<ribbon::Weather> weather;
  ribbon::box2d::Coupling coupling;
};

/// A scene: initial state, and changes before each tick.
struct BitScene {
  std::string_view name;
  void (*build)(BitWorld&);
  void (*drive)(BitWorld&, int tick);  ///< may be null; a function of the tick and of the world
  int ticks;
  std::uint64_t golden;  ///< of hash_of_run
};
void PrintTo(const BitScene& scene, std::ostream* out);  // for GoogleTest

std::span<const BitScene> bit_scenes();

/// Returns the n-th created body, from 0.
b2Body& body(b2World& world, int n);

/// Runs one tick: drive, cords, world.
void tick(const BitScene& scene, BitWorld& world, int number);

/// Returns the hash of all bits of the coupling's state and of the bodies.
std::uint64_t hash_of(const ribbon::box2d::Coupling& coupling, const b2World& world);

/// Returns the hash of all ticks of a scene.
std::uint64_t hash_of_run(const BitScene& scene);

}  // namespace bits
