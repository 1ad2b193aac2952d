#pragma once

#include <memory>
#include <string>

#include "engine/sound/mixer.h"

namespace engine {

/// The sound device and the mixer that it plays. Where there is no device, and once it is lost, everything can be
/// called as before and nothing is heard.
class Audio {
 public:
  static constexpr int rate = 44100;  ///< samples a second of the mixer

  /// Opens the device that the system prefers.
  Audio();
  ~Audio();

  /// True while there is a device that plays.
  bool is_heard() const;
  /// What keeps it from being heard, as a sentence; empty if nothing does.
  std::string why_silent() const;
  /// Opens a device anew if the one before was lost; true if it did. It costs some milliseconds where there is none:
  /// try it every few seconds, no more.
  bool reopen_if_lost();

  /// As of Mixer, whose mixing goes on in a thread of its own.
  SoundId add(Sound sound);
  void play(SoundId sound, const Playing& how = {});
  LoopId start_loop(SoundId sound);
  void set_loop(LoopId loop, const Playing& how);
  void hush();
  void set_volume(double volume);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace engine
