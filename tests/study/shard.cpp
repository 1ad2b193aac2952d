#include "tests/study/shard.h"

#include <charconv>
#include <stdexcept>

namespace study {
namespace {

/// Returns 0 for what is not a number from 1 to 100000.
std::size_t part_number_of(const std::string& text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  return is_number && value <= 100000 ? value : 0;
}

}  // namespace

Shard shard_of(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash != std::string::npos) {
    const Shard shard{part_number_of(text.substr(0, slash)), part_number_of(text.substr(slash + 1))};
    if (shard.number > 0 && shard.number <= shard.count) return shard;
  }
  throw std::invalid_argument("--shard: " + text + " is not accepted; accepted is K/N, the K-th of N parts: 2/8");
}

}  // namespace study
