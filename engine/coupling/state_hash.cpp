#include "ribbon/box2d/state_hash.h"

#include <algorithm>
#include <cassert>

namespace ribbon::box2d {
namespace {

bool same_part(const StatePart& a, const StatePart& b) { return a.subsystem == b.subsystem && a.index == b.index; }

bool contains(std::span<const StatePart> parts, const StatePart& part) {
  return std::any_of(parts.begin(), parts.end(), [&](const StatePart& p) { return same_part(p, part); });
}

Divergence missing(const StatePart& recorded) {
  return {Divergence::Kind::missing, recorded.subsystem, recorded.index, recorded.hash, 0};
}

Divergence extra(const StatePart& computed) {
  return {Divergence::Kind::extra, computed.subsystem, computed.index, 0, computed.hash};
}

std::string hex_digits(std::uint64_t value, std::size_t count) {
  std::string digits(count, '0');
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit, value >>= 4)
    *digit = "0123456789abcdef"[value & 15];
  return digits;
}

std::string part_hash(std::uint64_t hash) { return to_hex(static_cast<std::uint32_t>(hash)); }

}  // namespace

std::uint64_t Hasher::value() const {
  // The finaliser of SplitMix64 (Steele, Lea, Flood 2014): every bit of the state reaches every bit of the value.
  std::uint64_t z = state_ + words_ * 0x9e37'79b9'7f4a'7c15U;
  z = (z ^ (z >> 30)) * 0xbf58'476d'1ce4'e5b9U;
  z = (z ^ (z >> 27)) * 0x94d0'49bb'1331'11ebU;
  return z ^ (z >> 31);
}

std::string_view subsystem_name(Subsystem subsystem) {
  switch (subsystem) {
    case Subsystem::game: return "game";
    case Subsystem::cord: return "cord";
    case Subsystem::body: return "body";
  }
  assert(false && "no such subsystem");
  return "?";
}

void StateHash::clear() {
  parts_.clear();
  combined_ = 0;
}

void StateHash::add(Subsystem subsystem, std::uint16_t index, const Hasher& hasher) {
  const std::uint64_t hash = hasher.value();
  parts_.push_back({subsystem, index, static_cast<std::uint32_t>(hash ^ (hash >> 32))});
  Hasher all;
  all.add(combined_);
  all.add(static_cast<std::uint8_t>(subsystem));
  all.add(index);
  all.add(hash);
  combined_ = all.value();
}

std::optional<Divergence> first_difference(const StateHash& recorded, const StateHash& computed) {
  const std::span<const StatePart> was = recorded.parts();
  const std::span<const StatePart> is = computed.parts();
  const std::size_t common = std::min(was.size(), is.size());
  for (std::size_t i = 0; i < common; ++i) {
    if (same_part(was[i], is[i])) {
      if (was[i].hash == is[i].hash) continue;
      return Divergence{Divergence::Kind::differs, was[i].subsystem, was[i].index, was[i].hash, is[i].hash};
    }
    // Out of step: the recorded part still to come means the computed one was put in, else the recorded one is gone.
    return contains(is.subspan(i), was[i]) ? extra(is[i]) : missing(was[i]);
  }
  if (was.size() > common) return missing(was[common]);
  if (is.size() > common) return extra(is[common]);
  if (recorded.combined() == computed.combined()) return std::nullopt;
  return Divergence{Divergence::Kind::combined, Subsystem::game, 0, recorded.combined(), computed.combined()};
}

std::string describe(const Divergence& divergence) {
  std::string part = std::string(subsystem_name(divergence.subsystem)) + " " + std::to_string(divergence.index);
  switch (divergence.kind) {
    case Divergence::Kind::differs:
      return part + " differs (recorded " + part_hash(divergence.recorded) + ", now " + part_hash(divergence.computed) +
             ")";
    case Divergence::Kind::missing:
      return part + " is missing (recorded " + part_hash(divergence.recorded) + ", now not there)";
    case Divergence::Kind::extra:
      return part + " is new (not recorded there, now " + part_hash(divergence.computed) + ")";
    case Divergence::Kind::combined:
      return "the state differs (recorded " + to_hex(divergence.recorded) + ", now " + to_hex(divergence.computed) +
             ") though no single part shows it";
  }
  assert(false && "no such kind of divergence");
  return part;
}

std::uint64_t hash_bytes(std::string_view bytes) {
  std::uint64_t hash = 0xcbf2'9ce4'8422'2325U;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100'0000'01b3U;
  return hash;
}

std::string to_hex(std::uint64_t value) { return hex_digits(value, 16); }
std::string to_hex(std::uint32_t value) { return hex_digits(value, 8); }

}  // namespace ribbon::box2d
