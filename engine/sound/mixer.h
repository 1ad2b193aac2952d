#pragma once

#include <span>
#include <vector>

#include "engine/sound/wav.h"

namespace engine {

/// The index of a sound in its mixer, in the order of add().
using SoundId = int;
/// The index of a loop, in the order of start_loop().
using LoopId = int;

/// How a sound is played. Values out of range are clamped.
struct Playing {
  double volume = 1.0;  ///< 0 … 4
  double pan = 0.0;     ///< −1 left … 1 right
  double pitch = 1.0;   ///< 0.125 … 8, the factor of frequency and speed
};

/// Mixes sounds that play once and loops whose volume and pitch change. It avoids clicks: volumes change over some
/// milliseconds, and a soft limiter replaces clipping. Independent of the audio device. Callers must pass valid ids.
class Mixer {
 public:
  static constexpr int max_voices = 32;

  /// `rate`: samples per second of the mix.
  explicit Mixer(int rate);

  SoundId add(Sound sound);
  /// Plays the sound once. If max_voices play already, the oldest ends.
  void play(SoundId sound, const Playing& how = {});
  /// Starts a loop of that sound, silent until set_loop.
  LoopId start_loop(SoundId sound);
  /// A loop of volume 0 stops at its place and costs nothing.
  void set_loop(LoopId loop, const Playing& how);
  /// Fades out all sounds and loops.
  void fade_out();
  /// Sets the master volume, 0 … 1.
  void set_volume(double volume);

  /// Writes the next samples, left and right interleaved, in −1 … 1. Does not allocate.
  void mix(std::span<float> stereo);

  int rate() const { return rate_; }
  /// The number of sounds that play, without loops.
  int voices() const { return static_cast<int>(voices_.size()); }

 private:
  struct Gains {
    float left = 0.0F;
    float right = 0.0F;
  };
  struct Voice {
    SoundId sound = 0;
    double at = 0.0;    // position in samples of the sound
    double step = 0.0;  // samples of the sound per sample of the mix
    Gains gains;
    float fade = 1.0F;  // falls to 0 while it ends
    bool ends = false;
    bool is_over = false;
  };
  struct Loop {
    SoundId sound = 0;
    double at = 0.0;
    double step = 0.0, target_step = 0.0;
    Gains gains, target;
  };

  static Gains gains_of(const Playing& how);
  double step_of(SoundId sound, double pitch) const;
  const std::vector<float>& samples(SoundId sound) const { return sounds_[static_cast<std::size_t>(sound)].samples; }
  void add_voice(Voice& voice, std::span<float> stereo) const;
  void add_loop(Loop& loop, std::span<float> stereo) const;

  int rate_;
  float approach_;  // the fraction of its remaining change that a volume makes per sample
  std::vector<Sound> sounds_;
  std::vector<Voice> voices_;
  std::vector<Loop> loops_;
  float volume_ = 1.0F;
  float target_volume_ = 1.0F;
};

}  // namespace engine
