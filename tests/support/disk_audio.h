#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace test_support {

/// The left channel of what SDL's disk driver wrote there: 44100 samples a second, floats, left and right in turn.
inline std::vector<float> left_channel(const std::string& path) {
  std::error_code ignored;
  const auto size = std::filesystem::file_size(path, ignored);
  std::vector<float> samples(ignored ? 0 : size / sizeof(float));
  std::ifstream in(path, std::ios::binary);
  in.read(reinterpret_cast<char*>(samples.data()), static_cast<std::streamsize>(samples.size() * sizeof(float)));
  for (std::size_t k = 0; 2 * k < samples.size(); ++k) samples[k] = samples[2 * k];
  samples.resize(samples.size() / 2);
  return samples;
}

inline double peak(const std::vector<float>& samples) {
  double most = 0.0;
  for (const float sample : samples) most = std::max(most, static_cast<double>(std::abs(sample)));
  return most;
}

inline double rms(const std::vector<float>& samples) {
  double sum = 0.0;
  for (const float sample : samples) sum += static_cast<double>(sample) * static_cast<double>(sample);
  return samples.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(samples.size()));
}

}  // namespace test_support
