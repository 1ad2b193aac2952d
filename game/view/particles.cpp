#include "game/view/particles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace game {
namespace {

using engine::Color;
using ribbon::Vec2;

}  // namespace

void Particles::add(const Particle& particle) {
  if (count_ < max_count) {
    pool_[count_++] = particle;
    return;
  }
  const auto left = [](const Particle& p) { return p.life - p.age; };
  *std::min_element(pool_.begin(), pool_.end(),
                    [&](const Particle& a, const Particle& b) { return left(a) < left(b); }) = particle;
}

void Particles::tick(double dt, Vec2 breeze) {
  for (std::size_t k = 0; k < count_;) {
    Particle& p = pool_[k];
    p.age += dt;
    if (p.age >= p.life) {
      p = pool_[--count_];
      continue;
    }
    switch (p.kind) {
      case Particle::Kind::dust: p.velocity += dt * (-3.0 * p.velocity + Vec2{0.6 * breeze.x, 0.5}); break;
      case Particle::Kind::leaf:
        p.velocity +=
            dt * 1.5 *
            (breeze + Vec2{0.5 * std::sin(3.0 * p.age + p.turn), -0.5 + 0.5 * std::cos(2.3 * p.age)} - p.velocity);
        p.turn += dt * 2.5;
        break;
      case Particle::Kind::confetti:
        p.velocity += dt * (-2.2 * p.velocity + Vec2{0.8 * std::sin(3.0 * p.turn) + 0.4 * breeze.x, -3.2});
        p.turn += dt * 4.0;
        break;
      case Particle::Kind::spark: p.velocity += dt * (-1.2 * p.velocity + Vec2{0.0, -5.0}); break;
    }
    p.at += dt * p.velocity;
    ++k;
  }
}

double Particles::random() {
  state_ ^= state_ << 13U;
  state_ ^= state_ >> 17U;
  state_ ^= state_ << 5U;
  return static_cast<double>(state_) / 2147483648.0 - 1.0;
}

void add_dust(Particles& particles, Vec2 feet, double strength, Color color) {
  const int count = static_cast<int>(std::lround(1.0 + 13.0 * std::clamp(strength, 0.0, 1.0)));
  for (int k = 0; k < count; ++k) {
    Particle p;
    p.at = feet + Vec2{0.2 * particles.random(), 0.03};
    p.velocity = {(0.6 + 2.4 * strength) * particles.random(), 0.5 + 0.6 * strength * (1.0 + particles.random())};
    p.life = 0.45 + 0.2 * particles.random();
    p.size = 0.13 + 0.06 * particles.random();
    p.color = color;
    particles.add(p);
  }
}

void add_leaf(Particles& particles, Vec2 at, Color color) {
  Particle p;
  p.kind = Particle::Kind::leaf;
  p.at = at;
  p.velocity = {1.0, -0.3};
  p.life = 9.0 + 2.0 * particles.random();
  p.size = 0.10 + 0.03 * particles.random();
  p.turn = 3.0 * particles.random();
  p.color = color;
  particles.add(p);
}

void add_sparkle(Particles& particles, Vec2 at, Color color) {
  for (int k = 0; k < 48; ++k) {
    Particle p;
    p.kind = Particle::Kind::spark;
    const double angle = std::numbers::pi * particles.random();
    const double speed = 3.0 + 2.0 * particles.random();
    p.at = at;
    p.velocity = speed * Vec2{std::cos(angle), std::sin(angle)} + Vec2{0.0, 2.0};
    p.life = 1.0 + 0.4 * particles.random();
    p.size = 0.07 + 0.03 * particles.random();
    p.color = color;
    particles.add(p);
  }
}

void add_confetti(Particles& particles, Vec2 at, const std::array<Color, 4>& colors) {
  for (std::size_t k = 0; k < 72; ++k) {
    Particle p;
    p.kind = Particle::Kind::confetti;
    const double angle = 0.5 * std::numbers::pi + 0.8 * particles.random();
    const double speed = 7.5 + 3.5 * particles.random();
    p.at = at + Vec2{0.3 * particles.random(), 0.0};
    p.velocity = speed * Vec2{std::cos(angle), std::sin(angle)};
    p.life = 3.0 + 0.8 * particles.random();
    p.size = 0.13 + 0.04 * particles.random();
    p.turn = 3.0 * particles.random();
    p.color = colors[k % colors.size()];
    particles.add(p);
  }
}

}  // namespace game
