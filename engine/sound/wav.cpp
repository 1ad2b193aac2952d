#include "engine/sound/wav.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <optional>
#include <sstream>

#include "engine/files/regular_file.h"

namespace engine {
namespace {

constexpr std::size_t max_file_bytes = std::size_t{16} << 20U;
constexpr float full_scale = 32767.0F;
constexpr std::string_view accepted = "; accepted is a WAV file of one channel of 16-bit PCM";

std::uint32_t number_at(std::string_view bytes, std::size_t at, std::size_t size) {
  std::uint32_t value = 0;
  for (std::size_t k = size; k-- > 0;) value = value << 8U | static_cast<std::uint8_t>(bytes[at + k]);
  return value;
}

void append(std::string& bytes, std::uint32_t value, std::size_t size) {
  for (std::size_t k = 0; k < size; ++k) bytes += static_cast<char>(value >> 8U * k & 0xffU);
}

[[noreturn]] void fail(const std::string& file, const std::string& sentence) {
  throw SoundError(file + ": " + sentence + std::string(accepted));
}

/// Returns the content of the first chunk with that name.
std::optional<std::string_view> chunk(std::string_view bytes, std::string_view name, const std::string& file) {
  std::size_t at = 12;
  while (at + 8 <= bytes.size()) {
    const std::size_t size = number_at(bytes, at + 4, 4);
    if (size > bytes.size() - at - 8) fail(file, "is cut short");
    if (bytes.substr(at, 4) == name) return bytes.substr(at + 8, size);
    at += 8 + size + size % 2;
  }
  return std::nullopt;
}

int rate_of(std::string_view format, const std::string& file) {
  const std::uint32_t channels = number_at(format, 2, 2);
  const std::uint32_t rate = number_at(format, 4, 4);
  const std::uint32_t bits = number_at(format, 14, 2);
  if (number_at(format, 0, 2) != 1) fail(file, "is not plain PCM");
  if (channels != 1) fail(file, "has " + std::to_string(channels) + " channels");
  if (bits != 16) fail(file, "has " + std::to_string(bits) + " bits a sample");
  if (rate < 8000 || rate > 192000) fail(file, "has " + std::to_string(rate) + " samples a second, not 8000 to 192000");
  return static_cast<int>(rate);
}

}  // namespace

Sound parse_wav(std::string_view bytes, const std::string& file) {
  if (bytes.size() < 12 || bytes.substr(0, 4) != "RIFF" || bytes.substr(8, 4) != "WAVE") fail(file, "is no WAV file");
  const auto format = chunk(bytes, "fmt ", file);
  const auto data = chunk(bytes, "data", file);
  if (!format || format->size() < 16) fail(file, "does not say what format it has");
  if (!data || data->size() < 2) fail(file, "has no samples");
  Sound sound;
  sound.rate = rate_of(*format, file);
  for (std::size_t at = 0; at + 1 < data->size(); at += 2) {
    const auto sample = static_cast<std::int16_t>(number_at(*data, at, 2));
    sound.samples.push_back(std::max(-1.0F, static_cast<float>(sample) / full_scale));
  }
  return sound;
}

Sound load_wav(const std::string& path) {
  std::ifstream in;
  try {
    in = open_regular_file(path);
  } catch (const std::runtime_error& error) {
    throw SoundError(error.what());
  }
  std::ostringstream bytes;
  bytes << in.rdbuf();
  if (!in || in.bad()) throw SoundError(path + ": reading failed");
  const std::string all = bytes.str();
  if (all.size() > max_file_bytes) fail(path, "is larger than 16 MiB");
  return parse_wav(all, path);
}

std::string wav_of(const Sound& sound) {
  const auto rate = static_cast<std::uint32_t>(sound.rate);
  const auto size = static_cast<std::uint32_t>(2 * sound.samples.size());
  std::string bytes = "RIFF";
  append(bytes, 36 + size, 4);
  bytes += "WAVEfmt ";
  append(bytes, 16, 4);
  append(bytes, 1, 2);  // PCM
  append(bytes, 1, 2);  // channels
  append(bytes, rate, 4);
  append(bytes, 2 * rate, 4);  // bytes per second
  append(bytes, 2, 2);         // bytes per sample
  append(bytes, 16, 2);        // bits per sample
  bytes += "data";
  append(bytes, size, 4);
  for (const float sample : sound.samples) {
    const float scaled = full_scale * std::clamp(sample, -1.0F, 1.0F);
    append(bytes, static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(scaled))), 2);
  }
  return bytes;
}

}  // namespace engine
