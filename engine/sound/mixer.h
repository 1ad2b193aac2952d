#pragma once

#include <span>
#include <vector>

#include "engine/sound/wav.h"

namespace engine {

/// A sound's place in its mixer, in the order of adding.
using SoundId = int;
/// A loop's, in the order of starting.
using LoopId = int;

/// How a sound is heard. What is out of range counts as the nearest that is in it.
struct Playing {
  double volume = 1.0;  ///< 0 … 4
  double pan = 0.0;     ///< −1 left … 1 right
  double pitch = 1.0;   ///< 0.125 … 8: twice as high is twice as fast
};

/// Adds up sounds: what plays once, and loops that go on while their volume and pitch change. Nothing in it is sudden:
/// volumes go where they are to go within some milliseconds, and what is too loud together is bent, not cut off. Knows
/// no device. Of play and the setters the caller sees to it that there is such a sound or loop.
class Mixer {
 public:
  static constexpr int most_voices = 32;

  /// `rate`: samples a second of what it mixes.
  explicit Mixer(int rate);

  SoundId add(Sound sound);
  /// Plays it once from its beginning. If too many play already, the one that began first ends.
  void play(SoundId sound, const Playing& how = {});
  /// A loop of that sound, silent until set_loop.
  LoopId start_loop(SoundId sound);
  void set_loop(LoopId loop, const Playing& how);
  /// Ends what plays, softly, and has all loops silent.
  void hush();
  /// Of everything, 0 … 1.
  void set_volume(double volume);

  /// The next samples, left and right in turn, −1 … 1. Allocates nothing.
  void mix(std::span<float> stereo);

  int rate() const { return rate_; }
  /// How many sounds are playing, loops left out.
  int voices() const { return static_cast<int>(voices_.size()); }

 private:
  struct Gains {
    float left = 0.0F;
    float right = 0.0F;
  };
  struct Voice {
    SoundId sound = 0;
    double at = 0.0;    // sample of the sound
    double step = 0.0;  // samples of the sound a sample of the mix
    Gains gains;
    float fade = 1.0F;  // while it ends
    bool ends = false;
    bool is_over = false;
  };
  struct Loop {
    SoundId sound = 0;
    double at = 0.0;
    double step = 0.0, step_wanted = 0.0;
    Gains gains, wanted;
  };

  static Gains gains_of(const Playing& how);
  double step_of(SoundId sound, double pitch) const;
  const std::vector<float>& samples(SoundId sound) const { return sounds_[static_cast<std::size_t>(sound)].samples; }
  void add_voice(Voice& voice, std::span<float> stereo) const;
  void add_loop(Loop& loop, std::span<float> stereo) const;

  int rate_;
  float approach_;  // share of the way that a volume goes in a sample
  std::vector<Sound> sounds_;
  std::vector<Voice> voices_;
  std::vector<Loop> loops_;
  float volume_ = 1.0F;
  float volume_wanted_ = 1.0F;
};

}  // namespace engine
