#include "game/view/effects.h"

#include <algorithm>
#include <cmath>

#include "game/simulation/tick_rate.h"
#include "ribbon/box2d/convert.h"

namespace game {
namespace {

using engine::Color;
using ribbon::Vec2;

constexpr int max_gap = 30;             // ticks
constexpr int leaf_ticks = 45;          // between two leaves
constexpr int step_ticks = 9;           // between two footsteps
constexpr double min_dust_speed = 2.5;  // m/s, of a landing
constexpr Vec2 breeze{1.3, 0.0};        // m/s

}  // namespace

Effects::Effects(const Simulation& simulation)
    : simulation_(&simulation), camera_(simulation.level().map.size, simulation.level().hooks) {}

CameraSubject Effects::subject() const {
  const Player& player = simulation_->player();
  CameraSubject now;
  now.at = player.position();
  now.velocity = ribbon::box2d::to_double(player.body().GetLinearVelocity());
  now.faces_left = player.faces_left();
  now.on_ground = player.is_on_ground();
  if (simulation_->players() == 2) {
    const Player& other = simulation_->player(1);
    const Vec2 apart = 0.5 * (other.position() - now.at);
    now.spread = Vec2{std::abs(apart.x), std::abs(apart.y)};
    now.at += apart;
    now.velocity = 0.5 * (now.velocity + ribbon::box2d::to_double(other.body().GetLinearVelocity()));
    now.on_ground = now.on_ground && other.is_on_ground();
  }
  now.hangs = player.held_place(simulation_->scene().coupling()).has_value();
  return now;
}

Effects::Moving Effects::player(int number) const {
  const Player& player = simulation_->player(number);
  return {player.position(), ribbon::box2d::to_double(player.body().GetLinearVelocity())};
}

void Effects::start_again(const CameraSubject& now) {
  camera_ = Camera(simulation_->level().map.size,
                   simulation_->level().hooks);  // the level may have been reloaded with another size
  CameraSubject first = now;
  if (simulation_->run_ticks() <= 1) first.on_ground = true;  // it will have met the ground in the next tick
  camera_.jump_to(first);
  particles_.clear();
  trail_.clear();
  fall_.end();
  was_on_ground_ = {true, true};
  had_goal_ = simulation_->goal_ticks().has_value();
  checkpoint_ = simulation_->checkpoint();
}

/// Advances by the ticks since the last frame.
void Effects::advance(const CameraSubject& now, int gap) {
  if (simulation_->falls() > falls_) {
    const Moving& fallen = players_before_[static_cast<std::size_t>(simulation_->last_fallen())];
    fall_.begin(fallen.at, fallen.velocity);
    trail_.clear();
  }
  for (int k = 1; k <= gap; ++k) {
    const bool was_closing = fall_.is_closing();
    fall_.tick();
    particles_.tick(tick_dt, breeze);
    if (fall_.is_closing()) continue;  // the picture stays at the place of the fall
    CameraSubject between = now;
    if (!was_closing && !fall_.is_shown()) between.at = before_.at + (1.0 * k / gap) * (now.at - before_.at);
    between.lands = now.lands && k == gap;
    if (was_closing) camera_.jump_to(between);
    camera_.tick(between);
    trail_.add(players_before_[0].at + (was_closing ? 1.0 : 1.0 * k / gap) * (player(0).at - players_before_[0].at));
  }
}

void Effects::follow(const Palette& palette, bool reduced_motion) {
  const int gap = simulation_->ticks() - seen_ticks_;
  CameraSubject now = subject();
  const bool set_back = simulation_->run_ticks() < seen_run_ticks_;
  if (seen_ticks_ < 0 || gap < 0 || gap > max_gap || set_back) {
    start_again(now);
  } else if (gap > 0) {
    now.impact = std::max(-before_.velocity.y, 0.0);
    now.lands = lands(0);
    advance(now, gap);
    if (!reduced_motion) add_particles(now, palette);
    for (int k = 0; k < simulation_->players(); ++k)
      was_on_ground_[static_cast<std::size_t>(k)] = simulation_->player(k).is_on_ground();
  }
  before_ = now;
  for (int k = 0; k < simulation_->players(); ++k) players_before_[static_cast<std::size_t>(k)] = player(k);
  falls_ = simulation_->falls();
  seen_ticks_ = simulation_->ticks();
  seen_run_ticks_ = simulation_->run_ticks();
}

bool Effects::lands(int number) const {
  const bool on_ground = simulation_->player(number).is_on_ground();
  return on_ground && !was_on_ground_[static_cast<std::size_t>(number)] && !fall_.is_shown();
}

/// Adds the dust of a player that lands or runs.
void Effects::add_dust_of(int number, const Palette& palette) {
  const Player& player = simulation_->player(number);
  const Vec2 feet = player.position() - Vec2{0.0, 0.5 * player.tuning().height};
  const Color dust = mix(palette.soil, {255, 255, 255}, 0.45);
  const double impact = std::max(-players_before_[static_cast<std::size_t>(number)].velocity.y, 0.0);
  if (lands(number) && impact > min_dust_speed) add_dust(particles_, feet, impact / 10.0, dust);
  const bool runs = player.is_on_ground() && std::abs(this->player(number).velocity.x) > 3.0;
  if (runs && simulation_->ticks() / step_ticks != seen_ticks_ / step_ticks) add_dust(particles_, feet, 0.0, dust);
}

void Effects::add_particles(const CameraSubject& now, const Palette& palette) {
  for (int k = 0; k < simulation_->players(); ++k) add_dust_of(k, palette);
  const Place place = simulation_->level().place;
  const bool has_leaves = place == Place::hills || place == Place::storm;
  if (has_leaves && simulation_->ticks() / leaf_ticks != seen_ticks_ / leaf_ticks) {
    const Vec2 from = now.at + Vec2{-12.0 + 9.0 * particles_.random(), 5.0 + 4.0 * particles_.random()};
    add_leaf(particles_, from, mix(palette.grass, palette.goal, 0.5 + 0.5 * particles_.random()));
  }
  const bool has_goal = simulation_->goal_ticks().has_value();
  if (has_goal && !had_goal_) {
    const Vec2 cloth = flag_of(*simulation_->level().goal).cloth.center;
    add_sparkle(particles_, cloth, palette.goal);
    add_sparkle(particles_, cloth, palette.sun);
    add_confetti(particles_, cloth, palette.ribbons);
  }
  had_goal_ = has_goal;
  const auto checkpoint = simulation_->checkpoint();
  if (checkpoint && checkpoint != checkpoint_) {
    const Area& area = simulation_->level().checkpoints[*checkpoint];
    add_sparkle(particles_, area.center + Vec2{0.4, 1.4 - 0.5 * area.size.y}, palette.banner_up);
  }
  checkpoint_ = checkpoint;
}

void Effects::draw(Pen& pen, double alpha) const {
  for (const Particle& p : particles_.all()) {
    const Vec2 at = p.at + ((alpha - 1.0) * tick_dt) * p.velocity;
    if (!pen.sees(at, p.size)) continue;
    const double left = 1.0 - p.age / p.life;
    const Vec2 pixel = pen.canvas.to_pixels(at);
    const double size = 2.0 * p.size * pen.scale();
    switch (p.kind) {
      case Particle::Kind::dust: {
        const double grown = size * (1.0 + 1.6 * (1.0 - left));
        pen.sprite(pen.images.glow, pixel, {1.6 * grown, 1.6 * grown},
                   with_alpha(p.color, static_cast<int>(220.0 * left)));
        break;
      }
      case Particle::Kind::leaf: {
        const double fade = std::min({1.0, 4.0 * left, 2.0 * p.age});
        const Vec2 tip = 0.5 * p.size * Vec2{std::cos(p.turn), std::sin(p.turn)};
        pen.canvas.polyline(std::array{at - tip, at + tip},
                            0.5 * p.size * (0.35 + 0.65 * std::abs(std::sin(2.0 * p.turn))),
                            with_alpha(p.color, static_cast<int>(255.0 * fade)));
        break;
      }
      case Particle::Kind::confetti: {
        const Vec2 tip = 0.5 * p.size * Vec2{std::cos(0.6 * p.turn), std::sin(0.6 * p.turn)};
        pen.canvas.polyline(std::array{at - tip, at + tip},
                            0.6 * p.size * (0.2 + 0.8 * std::abs(std::sin(2.0 * p.turn))),
                            with_alpha(p.color, static_cast<int>(255.0 * std::min(1.0, 3.0 * left))));
        break;
      }
      case Particle::Kind::spark:
        pen.sprite(pen.images.glow, pixel, {3.0 * size, 3.0 * size},
                   with_alpha(p.color, static_cast<int>(200.0 * left)));
        pen.canvas.circle(at, 0.45 * p.size * left, with_alpha({255, 255, 255}, static_cast<int>(255.0 * left)));
        break;
    }
  }
}

}  // namespace game
