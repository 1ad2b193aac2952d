#pragma once

#include <box2d/box2d.h>

#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "engine/sound/mixer.h"
#include "game/simulation/simulation.h"

namespace game {

/// What a run can be heard doing, once each time it does.
enum class Noise : unsigned char {
  thud,     ///< a body against another or the ground, the player's landing among them
  slap,     ///< a cord against something
  creak,    ///< the held cord, as its tension rises and falls
  catches,  ///< the player catches a cord
  lets_go,
  jump,
  footstep,
  fall,  ///< out of the level
  goal,
  throws,  ///< the player throws a line
  hook,    ///< and it takes hold
  checkpoint,
};
inline constexpr std::size_t noise_count = static_cast<std::size_t>(Noise::checkpoint) + 1;

struct Cue {
  Noise noise;
  engine::Playing how;
};

/// Listens to a run: from its state after each tick it tells what is to be heard. It changes nothing of the run, and
/// the same run is heard the same each time.
class Ear {
 public:
  /// After each tick. A run that has gone on, or back, without it is listened to anew.
  void hear(const Simulation& simulation);

  /// What began in that tick; volumes 0 … 1.
  std::span<const Cue> cues() const { return cues_; }
  /// The air around the player, from how fast he flies.
  const engine::Playing& wind() const { return wind_; }
  /// The line, as it is reeled in or out.
  const engine::Playing& reel() const { return reel_; }

 private:
  void begin(const Simulation& simulation);
  double blow(const b2Body& body) const;
  void hear_bodies(const Simulation& simulation);
  void hear_cords(const Simulation& simulation);
  void hear_held_cord(const Simulation& simulation);
  void hear_line(const Simulation& simulation);
  void hear_player(const Simulation& simulation);
  void hear_wind(const Simulation& simulation);
  void add(Noise noise, double volume, double pitch = 1.0) { cues_.push_back({noise, {volume, 0.0, pitch}}); }
  engine::Playing from(const Simulation& simulation, ribbon::Vec2 where, double volume, double pitch) const;

  std::vector<Cue> cues_;
  engine::Playing wind_{0.0, 0.0, 1.0};
  engine::Playing reel_{0.0, 0.0, 1.0};
  std::unordered_map<const b2Body*, ribbon::Vec2> velocities_;  // m/s, after the tick before
  int tick_ = -1;
  int run_tick_ = -1;
  int falls_ = 0;
  bool reached_goal_ = false;
  std::optional<std::size_t> checkpoint_;
  Line::State line_ = Line::State::stowed;
  double line_length_ = 0.0;  // m
  bool held_ = false;
  bool on_ground_ = false;
  double tension_ = 0.0;  // N
  double unrest_ = 0.0;   // N, by which it has changed since the last creak
  double walked_ = 0.0;   // m, since the last footstep
  int since_creak_ = 0;   // ticks
  int since_slap_ = 0;    // ticks
};

}  // namespace game
