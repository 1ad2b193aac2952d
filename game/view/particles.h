#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/draw/color.h"
#include "ribbon/vec2.h"

namespace game {

/// Something small that flies for a while: for the eye only, the simulation knows nothing of it.
struct Particle {
  enum class Kind : unsigned char { dust, leaf, spark };
  ribbon::Vec2 at;        ///< m
  ribbon::Vec2 velocity;  ///< m/s
  double age = 0.0;       ///< s
  double life = 1.0;      ///< s
  double size = 0.1;      ///< m
  double turn = 0.0;      ///< rad
  engine::Color color{};
  Kind kind = Kind::dust;
};

/// At most so many at once; when there is no room the oldest gives way. It takes no memory after it was made, and its
/// random numbers are its own.
class Particles {
 public:
  static constexpr std::size_t most = 256;

  void clear() { count_ = 0; }
  void add(const Particle& particle);
  /// Moves them on by dt seconds, in a breeze [m/s].
  void tick(double dt, ribbon::Vec2 breeze);
  std::span<const Particle> all() const { return {pool_.data(), count_}; }

  /// −1 … 1.
  double random();

 private:
  std::array<Particle, most> pool_{};
  std::size_t count_ = 0;
  std::uint32_t state_ = 0x2545f491U;
};

/// Dust where somebody's feet are: `strength` 0 … 1 is how much of it.
void add_dust(Particles& particles, ribbon::Vec2 feet, double strength, engine::Color color);
/// A leaf that the wind brings.
void add_leaf(Particles& particles, ribbon::Vec2 at, engine::Color color);
/// A burst of sparks in all directions.
void add_sparkle(Particles& particles, ribbon::Vec2 at, engine::Color color);

}  // namespace game
