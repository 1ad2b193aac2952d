#include "game/sound/ear.h"

#include <algorithm>
#include <cmath>

#include "ribbon/box2d/convert.h"

namespace game {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_double;

constexpr double full_thud = 400.0;       // N·s: 60 kg that land at 6.7 m/s
constexpr double least_thud_speed = 0.8;  // m/s, by which a blow changes a body's velocity
constexpr double full_slap = 40.0;        // N·s
constexpr double least_slap = 0.3;        // N·s
constexpr int slap_ticks = 4;             // at least, from one to the next
constexpr double creak_change = 900.0;    // N, about what half a swing of 60 kg changes
constexpr double full_creak = 2500.0;     // N
constexpr int creak_ticks = 14;           // at least, from one to the next
constexpr double step_length = 1.05;      // m
constexpr double calm = 3.5;              // m/s, up to which air is not heard
constexpr double storm = 16.0;            // m/s
constexpr double hearing = 9.0;           // m, at which a sound is half as loud, and all at one side

/// N, the greater of the links at the point; of a ribbon it is not known.
double tension_at(const ribbon::box2d::Coupling& coupling, const ribbon::box2d::CordPoint& held) {
  if (coupling.cord(held.cord).solver() != ribbon::box2d::Solver::direct || coupling.cord(held.cord).shape().rows != 1)
    return 0.0;
  const auto tensions = coupling.cord(held.cord).direct().tensions();
  const auto point = static_cast<std::size_t>(held.point);
  double most = 0.0;
  for (const std::size_t link : {point - 1, point}) {  // the first point has none before it: out of range
    if (link < tensions.size()) most = std::max(most, tensions[link]);
  }
  return most;
}

/// 0 … 1, without a corner.
double smooth(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace

void Ear::hear(const Simulation& simulation) {
  cues_.clear();
  const bool goes_on = simulation.ticks() == tick_ + 1 && simulation.run_ticks() == run_tick_ + 1;
  if (!goes_on) begin(simulation);
  tick_ = simulation.ticks();
  run_tick_ = simulation.run_ticks();
  hear_bodies(simulation);
  hear_cords(simulation);
  hear_line(simulation);
  hear_held_cord(simulation);
  hear_player(simulation);
  hear_wind(simulation);
}

void Ear::begin(const Simulation& simulation) {
  falls_ = simulation.falls();
  reached_goal_ = simulation.goal_ticks().has_value();
  held_ = simulation.scene().coupling().held_by(simulation.player().body()).has_value();
  on_ground_ = simulation.player().is_on_ground();
  checkpoint_ = simulation.checkpoint();
  line_ = simulation.player().line().state();
  line_length_ = simulation.player().line().length();
  velocities_.clear();
  tension_ = unrest_ = walked_ = 0.0;
  since_creak_ = since_slap_ = 0;
}

/// Quieter and further to the side the further it is from the player.
engine::Playing Ear::from(const Simulation& simulation, Vec2 where, double volume, double pitch) const {
  const Vec2 way = where - simulation.player().position();
  const double nearness = hearing * hearing / (hearing * hearing + dot(way, way));
  return {volume * nearness, std::clamp(way.x / hearing, -1.0, 1.0) * 0.8, pitch};
}

/// N·s, the hardest that the body was hit in the tick, as far as velocities tell: Box2D keeps no impulses of what it
/// stops on its way. Of two that hit each other the lighter was hit.
double Ear::blow(const b2Body& body) const {
  const auto before = [this](const b2Body& of) {
    const auto known = velocities_.find(&of);
    return known == velocities_.end() ? to_double(of.GetLinearVelocity()) : known->second;
  };
  double hardest = 0.0;
  for (const b2ContactEdge* edge = body.GetContactList(); edge != nullptr; edge = edge->next) {
    const b2Body& other = *edge->other;
    const bool lighter = other.GetType() != b2_dynamicBody || body.GetMass() <= other.GetMass();
    if (!edge->contact->IsTouching() || !lighter) continue;
    b2WorldManifold manifold;
    edge->contact->GetWorldManifold(&manifold);
    const bool is_b = edge->contact->GetFixtureB()->GetBody() == &body;
    const Vec2 away = (is_b ? 1.0 : -1.0) * to_double(manifold.normal);
    const Vec2 came = before(body) - before(other);
    const Vec2 goes = to_double(body.GetLinearVelocity()) - to_double(other.GetLinearVelocity());
    const double stopped = std::min(-dot(came, away), dot(goes - came, away));
    if (stopped < least_thud_speed) continue;
    const double inverse_mass = 1.0 / static_cast<double>(body.GetMass()) +
                                (other.GetType() == b2_dynamicBody ? 1.0 / static_cast<double>(other.GetMass()) : 0.0);
    hardest = std::max(hardest, stopped / inverse_mass);
  }
  return hardest;
}

void Ear::hear_bodies(const Simulation& simulation) {
  for (const b2Body* body = simulation.scene().world().GetBodyList(); body != nullptr; body = body->GetNext()) {
    if (body->GetType() != b2_dynamicBody) continue;
    const double hit = blow(*body);
    if (hit == 0.0) continue;
    const double pitch = 0.8 + 12.0 / (20.0 + static_cast<double>(body->GetMass()));  // what is heavy sounds deep
    const double volume = std::min(1.0, std::sqrt(hit / full_thud));
    cues_.push_back({Noise::thud, from(simulation, to_double(body->GetPosition()), volume, pitch)});
  }
  for (const b2Body* body = simulation.scene().world().GetBodyList(); body != nullptr; body = body->GetNext()) {
    velocities_[body] = to_double(body->GetLinearVelocity());
  }
}

void Ear::hear_cords(const Simulation& simulation) {
  ++since_slap_;
  const ribbon::box2d::TouchEvent* hardest = nullptr;
  for (const ribbon::box2d::TouchEvent& touch : simulation.scene().coupling().touch_events()) {
    if (!touch.begins || touch.impulse < least_slap) continue;
    if (hardest == nullptr || touch.impulse > hardest->impulse) hardest = &touch;
  }
  if (hardest == nullptr || since_slap_ < slap_ticks) return;
  since_slap_ = 0;
  const double volume = std::min(1.0, std::sqrt(hardest->impulse / full_slap));
  cues_.push_back({Noise::slap, from(simulation, hardest->point, volume, 1.15 - 0.3 * volume)});
}

void Ear::hear_held_cord(const Simulation& simulation) {
  ++since_creak_;
  const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
  const auto held = coupling.held_by(simulation.player().body());
  const bool by_line = held && simulation.player().line().cord() == held->cord;
  if (held && !held_ && !by_line) add(Noise::catches, 0.8);
  if (!held && held_) add(Noise::lets_go, 0.7);
  const double tension = held ? tension_at(coupling, *held) : 0.0;
  if (held && held_) unrest_ += std::abs(tension - tension_);
  if (!held) unrest_ = 0.0;
  const bool rises = tension > tension_;
  held_ = held.has_value();
  tension_ = tension;
  if (unrest_ < creak_change || since_creak_ < creak_ticks) return;
  unrest_ = 0.0;
  since_creak_ = 0;
  add(Noise::creak, 0.15 + 0.6 * smooth(tension / full_creak), rises ? 1.06 : 0.92);
}

void Ear::hear_line(const Simulation& simulation) {
  const Line& line = simulation.player().line();
  if (line.state() == Line::State::flying && line_ != Line::State::flying) add(Noise::throws, 0.7);
  const bool takes_hold = line.state() == Line::State::held && line_ != Line::State::held;
  if (takes_hold) cues_.push_back({Noise::hook, from(simulation, line.hook(), 0.8, 1.0)});
  const bool is_held = line.state() == Line::State::held && !takes_hold;
  const double speed = is_held ? std::abs(line.length() - line_length_) * ticks_per_second : 0.0;  // m/s
  reel_ = {0.6 * smooth(speed / 2.0), 0.0, 0.8 + 0.2 * std::min(speed, 5.0)};
  line_ = line.state();
  line_length_ = line.length();
}

void Ear::hear_player(const Simulation& simulation) {
  const Player& player = simulation.player();
  const Vec2 velocity = to_double(player.body().GetLinearVelocity());
  const bool on_ground = player.is_on_ground();
  if (on_ground_ && !on_ground && velocity.y > 0.5 * player.tuning().jump_speed) add(Noise::jump, 0.6);
  on_ground_ = on_ground;
  walked_ = on_ground ? walked_ + std::abs(velocity.x) / ticks_per_second : 0.0;
  if (walked_ > step_length) {
    walked_ = 0.0;
    add(Noise::footstep, 0.35, tick_ % 2 == 0 ? 0.95 : 1.05);
  }
  if (simulation.falls() > falls_) add(Noise::fall, 0.7);
  falls_ = simulation.falls();
  if (simulation.checkpoint() && simulation.checkpoint() != checkpoint_) add(Noise::checkpoint, 0.7);
  checkpoint_ = simulation.checkpoint();
  if (simulation.goal_ticks() && !reached_goal_) add(Noise::goal, 0.8);
  reached_goal_ = simulation.goal_ticks().has_value();
}

void Ear::hear_wind(const Simulation& simulation) {
  const double speed = length(simulation.scene().coupling().velocity(simulation.player().body()));
  const double strength = on_ground_ ? 0.0 : smooth((speed - calm) / (storm - calm));
  wind_.volume += 0.2 * (0.75 * strength - wind_.volume);
  wind_.pitch = 0.75 + 0.9 * std::min(1.0, speed / storm);
}

}  // namespace game
