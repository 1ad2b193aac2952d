#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/window/sdl_audio.h"
#include "game/sound/cue_detector.h"
#include "game/sound/music.h"

namespace game {

/// How loud it is; volumes are 0 … 1.
struct Loudness {
  double sounds = 1.0;
  double music = 1.0;
  bool muted = false;  ///< all of it
};

/// Plays the sounds of runs and the music.
class Sounds {
 public:
  /// Reads the sounds from assets/sounds and the scores of the music. What cannot be read is silent.
  Sounds();

  /// The message of the first sound or score that could not be read; empty if there is none.
  const std::string& load_error() const { return load_error_.empty() ? music_.load_error() : load_error_; }
  /// The reason why no device plays; empty if one does.
  std::string why_silent() const { return audio_.why_silent(); }

  /// Plays the sounds of a tick. Call it after each tick of the visible run.
  void tick(const Simulation& simulation);
  /// Call it in each frame: ends the loops during a pause, plays the music and reopens a lost device.
  void frame(std::int64_t elapsed_ns, const Loudness& loudness, Tune tune);

 private:
  static constexpr std::size_t max_takes = 3;
  struct Take {
    std::array<engine::SoundId, max_takes> sounds{};
    std::size_t count = 0;  // 0: silent
    std::size_t next = 0;
  };

  engine::SoundId load(const std::string& name);
  engine::LoopId load_loop(const std::string& name);
  void load(Noise noise, const std::vector<std::string>& names);
  void play(const Cue& cue);
  engine::Playing at_volume(engine::Playing how) const;

  engine::Audio audio_;
  Music music_{audio_};
  double volume_ = 1.0;  // of the sounds
  std::string load_error_;
  std::array<Take, noise_count> takes_;
  engine::LoopId wind_ = 0;
  engine::LoopId reel_ = 0;
  std::array<CueDetector, 2> cues_{CueDetector(0), CueDetector(1)};  // of the players
  std::int64_t idle_ns_ = 0;                                         // since the last tick
  std::int64_t lost_ns_ = 0;                                         // since the last attempt to open the device
  bool had_device_;
};

}  // namespace game
