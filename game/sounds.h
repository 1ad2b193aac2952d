#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/sdl_audio.h"
#include "game/ear.h"

namespace game {

/// The game's sounds, played as its runs are heard.
class Sounds {
 public:
  /// Reads them from assets/sounds. One that cannot be read is silent.
  Sounds();

  /// Which sound could not be read, as a sentence for the user; empty if all were.
  const std::string& trouble() const { return trouble_; }
  /// Why nothing is heard, as a sentence; empty if there is a device that plays.
  std::string why_silent() const { return audio_.why_silent(); }

  /// Volume 0 … 1.
  void set_volume(double volume, bool muted) { audio_.set_volume(muted ? 0.0 : volume); }
  /// After each tick of the run that is seen and heard.
  void hear(const Simulation& simulation);
  /// While nothing moves: in a pause, or when the run has ended.
  void rest();
  /// Every frame: finds the sound device again if it was lost.
  void keep_open(std::int64_t now_ns);

 private:
  static constexpr std::size_t most_takes = 3;
  struct Take {
    std::array<engine::SoundId, most_takes> sounds{};
    std::size_t count = 0;  // 0: silent
    std::size_t next = 0;
  };

  engine::SoundId load(const std::string& name);
  void load(Noise noise, const std::vector<std::string>& names);
  void play(const Cue& cue);

  engine::Audio audio_;
  std::string trouble_;
  std::array<Take, noise_count> takes_;
  engine::LoopId wind_ = 0;
  Ear ear_;
  std::int64_t last_try_ns_ = 0;
  bool was_heard_;
};

}  // namespace game
