#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/draw/color.h"
#include "ribbon/vec2.h"

namespace game {

/// A visual effect that flies for some time. Not part of the simulation.
struct Particle {
  enum class Kind : unsigned char { dust, leaf, spark, confetti };
  ribbon::Vec2 at;        ///< m
  ribbon::Vec2 velocity;  ///< m/s
  double age = 0.0;       ///< s
  double life = 1.0;      ///< s
  double size = 0.1;      ///< m
  double turn = 0.0;      ///< rad
  engine::Color color{};
  Kind kind = Kind::dust;
};

/// A pool of particles with its own random numbers. It never allocates.
class Particles {
 public:
  static constexpr std::size_t max_count = 256;

  void clear() { count_ = 0; }
  /// Adds a particle. In a full pool it replaces the one with the shortest remaining life.
  void add(const Particle& particle);
  /// Advances all by `dt` s in a breeze (m/s).
  void tick(double dt, ribbon::Vec2 breeze);
  std::span<const Particle> all() const { return {pool_.data(), count_}; }

  /// Returns a pseudo-random number in −1 … 1.
  double random();

 private:
  std::array<Particle, max_count> pool_{};
  std::size_t count_ = 0;
  std::uint32_t state_ = 0x2545f491U;
};

/// Adds dust at the feet; `strength`, 0 … 1, is its amount.
void add_dust(Particles& particles, ribbon::Vec2 feet, double strength, engine::Color color);
/// Adds a leaf.
void add_leaf(Particles& particles, ribbon::Vec2 at, engine::Color color);
/// Adds a burst of sparks in all directions.
void add_sparkle(Particles& particles, ribbon::Vec2 at, engine::Color color);

/// Adds pieces of paper in four colours that fly up and flutter down.
void add_confetti(Particles& particles, ribbon::Vec2 at, const std::array<engine::Color, 4>& colors);

}  // namespace game
