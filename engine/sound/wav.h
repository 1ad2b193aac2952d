#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace engine {

/// A sound file cannot be used. The message has the file, the fault and what is accepted.
class SoundError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One channel of sound.
struct Sound {
  int rate = 0;                ///< samples per second, 8000 … 192000
  std::vector<float> samples;  ///< −1 … 1
};

/// Reads a WAV file of one channel of 16-bit PCM and at most 16 MiB. Throws SoundError if the file cannot be read, is
/// cut short or has another format.
Sound load_wav(const std::string& path);
/// Reads the bytes of a file; messages use `file` as the path. Throws like load_wav.
Sound parse_wav(std::string_view bytes, const std::string& file);

/// Returns the bytes of a WAV file of one channel of 16-bit PCM. Samples are clamped to ±1.
std::string wav_of(const Sound& sound);

}  // namespace engine
