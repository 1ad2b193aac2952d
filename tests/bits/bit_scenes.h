#pragma once

#include <box2d/box2d.h>

#include <cstdint>
#include <ostream>
#include <span>
#include <string_view>

#include "ribbon/box2d/coupling.h"

// Small worlds that between them take every way through the solvers, made of numbers that are the same everywhere: no
// function of the C library but √ has a part in them.

namespace bits {

inline constexpr double dt = 1.0 / 60.0;  // s

/// A world with cords in it, between two ticks.
struct BitWorld {
  b2World world{b2Vec2(0.0F, -9.81F)};
  ribbon::box2d::Coupling coupling;
};

/// What is done to a world before each tick.
struct BitScene {
  std::string_view name;
  void (*build)(BitWorld&);
  void (*drive)(BitWorld&, int tick);  ///< may be null; a function of the tick and of the world
  int ticks;
  std::uint64_t golden;  ///< of hash_of_run
};
void PrintTo(const BitScene& scene, std::ostream* out);  // for GoogleTest

std::span<const BitScene> bit_scenes();

/// The n-th body that was made, from 0.
b2Body& body(b2World& world, int n);

/// One tick: drive, cords, world.
void tick(const BitScene& scene, BitWorld& world, int number);

/// Of every bit of the coupling's state and of the bodies'.
std::uint64_t hash_of(const ribbon::box2d::Coupling& coupling, const b2World& world);

/// Of all of a scene's ticks.
std::uint64_t hash_of_run(const BitScene& scene);

}  // namespace bits
