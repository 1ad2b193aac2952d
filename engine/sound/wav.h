#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace engine {

/// A sound file that cannot be used. The sentence names the file, what is wrong and what is accepted.
class SoundError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One channel of sound.
struct Sound {
  int rate = 0;                ///< samples a second, 8000 … 192000
  std::vector<float> samples;  ///< −1 … 1
};

/// Reads a WAV file of one channel of 16-bit PCM, of at most 16 MiB. Throws SoundError if it cannot be read or is no
/// such file, one cut short included.
Sound load_wav(const std::string& path);
/// The same from the file's bytes; `file` stands for the path in messages.
Sound parse_wav(std::string_view bytes, const std::string& file);

/// The bytes of a WAV file of one channel of 16-bit PCM. What is beyond ±1 is cut off there.
std::string wav_of(const Sound& sound);

}  // namespace engine
