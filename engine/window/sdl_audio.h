#pragma once

#include <memory>
#include <string>

#include "engine/sound/mixer.h"

namespace engine {

/// The audio device and its mixer. Without a device, or after it was lost, all calls have no audible effect.
class Audio {
 public:
  static constexpr int rate = 44100;  ///< samples per second of the mixer

  /// Opens the default device.
  Audio();
  ~Audio();

  /// True while a device plays.
  bool has_device() const;
  /// The reason why no device plays; empty if one does.
  std::string why_silent() const;
  /// Opens a device if there is none or it was lost; returns true if that succeeded. Costs some milliseconds if it
  /// fails, so callers should retry only every few seconds.
  bool reopen_if_lost();

  /// The functions of Mixer. Mixing runs in the audio thread.
  SoundId add(Sound sound);
  void play(SoundId sound, const Playing& how = {});
  LoopId start_loop(SoundId sound);
  void set_loop(LoopId loop, const Playing& how);
  void fade_out();
  void set_volume(double volume);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace engine
