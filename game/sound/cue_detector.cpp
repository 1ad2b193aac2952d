#include "game/sound/cue_detector.h"

#include <algorithm>
#include <cmath>

#include "engine/math/smoothstep.h"
#include "ribbon/box2d/convert.h"

namespace game {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_double;

constexpr double full_thud = 400.0;       // N·s, impulse of the full volume: 60 kg that land at 6.7 m/s
constexpr double min_thud_speed = 0.8;    // m/s, change of the normal velocity
constexpr double full_slap = 40.0;        // N·s
constexpr double min_slap = 0.3;          // N·s
constexpr int min_slap_ticks = 4;         // between two slaps
constexpr double creak_change = 900.0;    // N, about the change of tension in half a swing of 60 kg
constexpr double full_creak = 2500.0;     // N
constexpr int min_creak_ticks = 14;       // between two creaks
constexpr double strain_share = 0.8;      // of the breaking force, from which a rope warns
constexpr int max_strain_ticks = 18;      // between two warnings there
constexpr int min_strain_ticks = 6;       // and just before it breaks
constexpr double step_length = 1.05;      // m
constexpr double min_wind_speed = 3.5;    // m/s, below which wind is silent
constexpr double full_wind_speed = 16.0;  // m/s
constexpr double half_distance = 9.0;     // m, at which a sound has half its volume and is fully panned

/// Returns the larger tension of the two links at a point of a rope in N; 0 for ribbons, whose tension is unknown.
double tension_at(const ribbon::box2d::Coupling& coupling, const ribbon::box2d::CordPoint& held) {
  if (coupling.cord(held.cord).solver() != ribbon::box2d::Solver::direct || coupling.cord(held.cord).shape().rows != 1)
    return 0.0;
  const auto tensions = coupling.cord(held.cord).direct().tensions();
  const auto point = static_cast<std::size_t>(held.point);
  double tension = 0.0;
  for (const std::size_t link : {point - 1, point}) {  // the first point has no link before it: wraps out of range
    if (link < tensions.size()) tension = std::max(tension, tensions[link]);
  }
  return tension;
}

/// The place of a cord that is nearest to breaking.
struct Strain {
  double share = 0.0;  // of its breaking force
  Vec2 at;             // m
};

/// Returns the largest strain of all ropes that can break.
Strain largest_strain(const ribbon::box2d::Coupling& coupling) {
  Strain largest;
  for (const ribbon::box2d::CordId id : coupling.cords()) {
    const auto cord = coupling.cord(id);
    if (cord.solver() != ribbon::box2d::Solver::direct || cord.shape().rows != 1) continue;
    const auto tensions = cord.direct().tensions();
    for (std::size_t link = 0; link < tensions.size(); ++link) {
      const double share = tensions[link] / cord.direct().breaking_force(static_cast<int>(link));
      if (share > largest.share) largest = {share, cord.positions()[link]};
    }
  }
  return largest;
}

/// Returns the largest id of a cord; −1 if there is none.
ribbon::box2d::CordId last_cord(const ribbon::box2d::Coupling& coupling) {
  const auto ids = coupling.cords();
  return ids.empty() ? -1 : ids.back();
}

}  // namespace

void CueDetector::update(const Simulation& simulation) {
  cues_.clear();
  const bool continues = simulation.ticks() == tick_ + 1 && simulation.run_ticks() == run_tick_ + 1;
  if (!continues) reset(simulation);
  tick_ = simulation.ticks();
  run_tick_ = simulation.run_ticks();
  if (player_ == 0) detect_bodies(simulation);
  if (player_ == 0) detect_cords(simulation);
  if (player_ == 0) detect_cuts(simulation);
  detect_line(simulation);
  detect_held_cord(simulation);
  if (player_ == 0) detect_strain(simulation);
  detect_player(simulation);
  if (player_ == 0) detect_progress(simulation);
  detect_wind(simulation);
}

void CueDetector::reset(const Simulation& simulation) {
  falls_ = simulation.falls();
  coins_ = simulation.coins();
  last_cord_ = last_cord(simulation.scene().coupling());
  reached_goal_ = simulation.goal_ticks().has_value();
  held_ = simulation.player(player_).held_place(simulation.scene().coupling()).has_value();
  on_ground_ = simulation.player(player_).is_on_ground();
  checkpoint_ = simulation.checkpoint();
  line_ = simulation.player(player_).line().state();
  line_length_ = simulation.player(player_).line().length();
  velocities_.clear();
  tension_ = variation_ = walked_ = 0.0;
  since_creak_ = since_slap_ = 0;
  since_strain_ = max_strain_ticks;
}

/// Adds a sound of the player.
void CueDetector::add(const Simulation& simulation, Noise noise, double volume, double pitch) {
  cues_.push_back({noise, from(simulation, simulation.player(player_).position(), volume, pitch)});
}

/// Returns how a sound at a position is played: attenuated and panned by its distance from the first player.
engine::Playing CueDetector::from(const Simulation& simulation, Vec2 where, double volume, double pitch) const {
  const Vec2 offset = where - simulation.player().position();
  const double attenuation = half_distance * half_distance / (half_distance * half_distance + dot(offset, offset));
  return {volume * attenuation, std::clamp(offset.x / half_distance, -1.0, 1.0) * 0.8, pitch};
}

/// Returns the largest contact impulse on the body in the tick in N·s, estimated from the velocities, since Box2D has
/// no impulses for time-of-impact events. Of two bodies that collide, only the lighter counts.
double CueDetector::largest_impulse(const b2Body& body) const {
  const auto before = [this](const b2Body& of) {
    const auto known = velocities_.find(&of);
    return known == velocities_.end() ? to_double(of.GetLinearVelocity()) : known->second;
  };
  double largest = 0.0;
  for (const b2ContactEdge* edge = body.GetContactList(); edge != nullptr; edge = edge->next) {
    const b2Body& other = *edge->other;
    const bool lighter = other.GetType() != b2_dynamicBody || body.GetMass() <= other.GetMass();
    if (!edge->contact->IsTouching() || !lighter) continue;
    b2WorldManifold manifold;
    edge->contact->GetWorldManifold(&manifold);
    const bool is_b = edge->contact->GetFixtureB()->GetBody() == &body;
    const Vec2 away = (is_b ? 1.0 : -1.0) * to_double(manifold.normal);
    const Vec2 old_velocity = before(body) - before(other);
    const Vec2 new_velocity = to_double(body.GetLinearVelocity()) - to_double(other.GetLinearVelocity());
    const double stopped = std::min(-dot(old_velocity, away), dot(new_velocity - old_velocity, away));
    if (stopped < min_thud_speed) continue;
    const double inverse_mass = 1.0 / static_cast<double>(body.GetMass()) +
                                (other.GetType() == b2_dynamicBody ? 1.0 / static_cast<double>(other.GetMass()) : 0.0);
    largest = std::max(largest, stopped / inverse_mass);
  }
  return largest;
}

void CueDetector::detect_bodies(const Simulation& simulation) {
  for (const b2Body* body = simulation.scene().world().GetBodyList(); body != nullptr; body = body->GetNext()) {
    if (body->GetType() != b2_dynamicBody) continue;
    const double impulse = largest_impulse(*body);
    if (impulse == 0.0) continue;
    const double pitch = 0.8 + 12.0 / (20.0 + static_cast<double>(body->GetMass()));  // lower for heavy bodies
    const double volume = std::min(1.0, std::sqrt(impulse / full_thud));
    cues_.push_back({Noise::thud, from(simulation, to_double(body->GetPosition()), volume, pitch)});
  }
  for (const b2Body* body = simulation.scene().world().GetBodyList(); body != nullptr; body = body->GetNext()) {
    velocities_[body] = to_double(body->GetLinearVelocity());
  }
}

void CueDetector::detect_cords(const Simulation& simulation) {
  ++since_slap_;
  const ribbon::box2d::TouchEvent* largest = nullptr;
  for (const ribbon::box2d::TouchEvent& touch : simulation.scene().coupling().last_step().touch_events()) {
    if (!touch.begins || touch.impulse < min_slap) continue;
    if (largest == nullptr || touch.impulse > largest->impulse) largest = &touch;
  }
  if (largest == nullptr || since_slap_ < min_slap_ticks) return;
  since_slap_ = 0;
  const double volume = std::min(1.0, std::sqrt(largest->impulse / full_slap));
  cues_.push_back({Noise::slap, from(simulation, largest->point, volume, 1.15 - 0.3 * volume)});
}

/// A cut that was made since the last tick left a piece, whose id is new. That of a link that broke in it did too.
void CueDetector::detect_cuts(const Simulation& simulation) {
  const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
  const ribbon::box2d::CutEvent* newest = nullptr;
  for (const ribbon::box2d::CutEvent& event : coupling.last_step().cut_events()) {
    const ribbon::box2d::CordId piece = std::max(event.first.value_or(-1), event.second.value_or(-1));
    if (piece > last_cord_) newest = &event;
  }
  last_cord_ = std::max(last_cord_, last_cord(coupling));
  if (newest == nullptr) return;
  const auto piece = newest->first ? newest->first : newest->second;
  const auto cord = coupling.cord(*piece);
  const Vec2 at = !cord.is_valid() ? simulation.player(player_).position()
                  : newest->first  ? cord.positions().back()
                                   : cord.positions().front();
  cues_.push_back({Noise::cut, from(simulation, at, 0.7, newest->broke ? 0.85 : 1.0)});
}

void CueDetector::detect_held_cord(const Simulation& simulation) {
  ++since_creak_;
  const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
  const auto held = simulation.player(player_).held_place(coupling);
  const bool by_line = held && simulation.player(player_).line().cord() == held->cord;
  if (held && !held_ && !by_line) add(simulation, Noise::catches, 0.8);
  if (!held && held_) add(simulation, Noise::lets_go, 0.7);
  const double tension = held ? tension_at(coupling, *held) : 0.0;
  if (held && held_) variation_ += std::abs(tension - tension_);
  if (!held) variation_ = 0.0;
  const bool rises = tension > tension_;
  held_ = held.has_value();
  tension_ = tension;
  if (variation_ < creak_change || since_creak_ < min_creak_ticks) return;
  variation_ = 0.0;
  since_creak_ = 0;
  add(simulation, Noise::creak, 0.15 + 0.6 * engine::smoothstep(0.0, 1.0, tension / full_creak), rises ? 1.06 : 0.92);
}

/// A rope that is near its breaking force creaks, the more often and the louder the nearer it is.
void CueDetector::detect_strain(const Simulation& simulation) {
  ++since_strain_;
  const Strain strain = largest_strain(simulation.scene().coupling());
  if (strain.share < strain_share) return;
  const double danger = std::min(1.0, (strain.share - strain_share) / (1.0 - strain_share));  // 0 … 1
  if (since_strain_ < max_strain_ticks - danger * (max_strain_ticks - min_strain_ticks)) return;
  since_strain_ = 0;
  cues_.push_back({Noise::strains, from(simulation, strain.at, 0.6 + 0.4 * danger, 1.25 + 0.2 * danger)});
}

void CueDetector::detect_line(const Simulation& simulation) {
  const Line& line = simulation.player(player_).line();
  if (line.state() == Line::State::flying && line_ != Line::State::flying) add(simulation, Noise::throws, 0.7);
  const bool arrives = line.state() == Line::State::held && line_ != Line::State::held;
  if (arrives) cues_.push_back({Noise::hook, from(simulation, line.end(), 0.8, 1.0)});
  const bool is_held = line.state() == Line::State::held && !arrives;
  const double speed = is_held ? std::abs(line.length() - line_length_) * ticks_per_second : 0.0;  // m/s
  reel_ = from(simulation, simulation.player(player_).position(), 0.6 * engine::smoothstep(0.0, 1.0, speed / 2.0),
               0.8 + 0.2 * std::min(speed, 5.0));
  line_ = line.state();
  line_length_ = line.length();
}

void CueDetector::detect_player(const Simulation& simulation) {
  const Player& player = simulation.player(player_);
  const Vec2 velocity = to_double(player.body().GetLinearVelocity());
  const bool on_ground = player.is_on_ground();
  if (on_ground_ && !on_ground && velocity.y > 0.5 * player.tuning().jump_speed) add(simulation, Noise::jump, 0.6);
  on_ground_ = on_ground;
  walked_ = on_ground ? walked_ + std::abs(velocity.x) / ticks_per_second : 0.0;
  if (walked_ > step_length) {
    walked_ = 0.0;
    add(simulation, Noise::footstep, 0.35, tick_ % 2 == 0 ? 0.95 : 1.05);
  }
}

void CueDetector::detect_progress(const Simulation& simulation) {
  if (simulation.falls() > falls_) add(simulation, simulation.died() ? Noise::dies : Noise::fall, 0.7);
  falls_ = simulation.falls();
  if (simulation.coins() > coins_) add(simulation, Noise::coin, 0.6);
  coins_ = simulation.coins();
  if (simulation.checkpoint() && simulation.checkpoint() != checkpoint_) add(simulation, Noise::checkpoint, 0.7);
  checkpoint_ = simulation.checkpoint();
  if (simulation.goal_ticks() && !reached_goal_) add(simulation, Noise::goal, 0.8);
  reached_goal_ = simulation.goal_ticks().has_value();
}

void CueDetector::detect_wind(const Simulation& simulation) {
  const double speed = length(simulation.scene().coupling().body(simulation.player(player_).body()).velocity());
  const double strength =
      on_ground_ ? 0.0 : engine::smoothstep(0.0, 1.0, (speed - min_wind_speed) / (full_wind_speed - min_wind_speed));
  gust_ += 0.2 * (0.75 * strength - gust_);
  wind_ = from(simulation, simulation.player(player_).position(), gust_,
               0.75 + 0.9 * std::min(1.0, speed / full_wind_speed));
}

}  // namespace game
