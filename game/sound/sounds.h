#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/window/sdl_audio.h"
#include "game/sound/ear.h"

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

  /// After each tick of the run that is seen and heard.
  void hear(const Simulation& simulation);
  /// Every frame, so long after the one before: the loops end where nothing has been heard for a moment, as in a pause,
  /// and a device that was lost is looked for. Volume 0 … 1.
  void pass(std::int64_t elapsed_ns, double volume, bool muted);

 private:
  static constexpr std::size_t most_takes = 3;
  struct Take {
    std::array<engine::SoundId, most_takes> sounds{};
    std::size_t count = 0;  // 0: silent
    std::size_t next = 0;
  };

  engine::SoundId load(const std::string& name);
  engine::LoopId load_loop(const std::string& name);
  void load(Noise noise, const std::vector<std::string>& names);
  void play(const Cue& cue);

  engine::Audio audio_;
  std::string trouble_;
  std::array<Take, noise_count> takes_;
  engine::LoopId wind_ = 0;
  engine::LoopId reel_ = 0;
  Ear ear_;
  std::int64_t unheard_ns_ = 0;  // since the last tick
  std::int64_t lost_ns_ = 0;     // since the device was last looked for
  bool was_heard_;
};

}  // namespace game
