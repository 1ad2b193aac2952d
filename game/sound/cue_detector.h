#pragma once

#include <box2d/box2d.h>

#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "engine/sound/mixer.h"
#include "game/simulation/simulation.h"

namespace game {

/// Events of a run that have a sound.
enum class Noise : unsigned char {
  thud,     ///< a body hits another or the ground, including the landing of the player
  slap,     ///< a cord hits something
  creak,    ///< the tension of the held cord changes
  catches,  ///< the player catches a cord
  lets_go,  ///< the player releases a cord
  jump,
  footstep,
  fall,  ///< out of the level
  dies,  ///< a danger of the level kills the player
  goal,
  throws,  ///< the player throws a line
  hook,    ///< the line arrives at the hook
  checkpoint,
  strains,  ///< a rope is near its breaking force
  cut,      ///< a knife, a blade or a fire cuts a cord, or it breaks
  coin,     ///< the player collects one
};
inline constexpr std::size_t noise_count = static_cast<std::size_t>(Noise::coin) + 1;

struct Cue {
  Noise noise;
  engine::Playing how;
};

/// Derives the sounds of a run from its state after each tick, as the first player hears them. It does not change the
/// run; equal runs give equal sounds.
class CueDetector {
 public:
  /// `player`: whose own sounds it detects. Those of the level, as of what falls, breaks or is reached, are detected
  /// with those of the first player, 0.
  explicit CueDetector(int player = 0) : player_(player) {}

  /// Call it after each tick. If ticks were skipped or the run was restarted, it only stores the state.
  void update(const Simulation& simulation);

  /// The sounds that began in the last tick; volumes 0 … 1.
  std::span<const Cue> cues() const { return cues_; }
  /// The wind around its player, by its speed in the air, as heard from the first player.
  const engine::Playing& wind() const { return wind_; }
  /// The reeling of the line, heard likewise.
  const engine::Playing& reel() const { return reel_; }

 private:
  void reset(const Simulation& simulation);
  double largest_impulse(const b2Body& body) const;
  void detect_bodies(const Simulation& simulation);
  void detect_cords(const Simulation& simulation);
  void detect_cuts(const Simulation& simulation);
  void detect_held_cord(const Simulation& simulation);
  void detect_strain(const Simulation& simulation);
  void detect_line(const Simulation& simulation);
  void detect_player(const Simulation& simulation);
  void detect_progress(const Simulation& simulation);
  void detect_wind(const Simulation& simulation);
  void add(const Simulation& simulation, Noise noise, double volume, double pitch = 1.0);
  engine::Playing from(const Simulation& simulation, ribbon::Vec2 where, double volume, double pitch) const;

  int player_;
  std::vector<Cue> cues_;
  engine::Playing wind_{0.0, 0.0, 1.0};
  double gust_ = 0.0;  // volume of the wind at its player
  engine::Playing reel_{0.0, 0.0, 1.0};
  std::unordered_map<const b2Body*, ribbon::Vec2> velocities_;  // m/s, after the previous tick
  int tick_ = -1;
  int run_tick_ = -1;
  int falls_ = 0;
  int coins_ = 0;
  ribbon::box2d::CordId last_cord_ = -1;  // the largest id of a cord after the previous tick
  bool reached_goal_ = false;
  std::optional<std::size_t> checkpoint_;
  Line::State line_ = Line::State::stowed;
  double line_length_ = 0.0;  // m
  bool held_ = false;
  bool on_ground_ = false;
  double tension_ = 0.0;    // N
  double variation_ = 0.0;  // N, the total variation of the tension since the last creak
  double walked_ = 0.0;     // m, since the last footstep
  int since_creak_ = 0;     // ticks
  int since_slap_ = 0;      // ticks
  int since_strain_ = 0;    // ticks
};

}  // namespace game
