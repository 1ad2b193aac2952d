#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ribbon/vec2.h"

namespace ribbon::box2d {

/// A 64-bit hash of a sequence of numbers; every add() feeds one 64-bit word (a Vec2: two). Not cryptographic.
///
/// It works on values, never on memory, so the result is the same on any byte order. Floating-point numbers count by
/// their bits: 0.0 and −0.0 differ, and so do two not-a-numbers with different bits. Two sequences of equal length that
/// differ in exactly one word never have the same value().
class Hasher {
 public:
  /// Feeds a number; a Vec2 counts as two.
  /// @{
  void add(std::integral auto value) { mix(static_cast<std::uint64_t>(value)); }
  void add(double value) { mix(std::bit_cast<std::uint64_t>(value)); }
  void add(float value) { mix(std::bit_cast<std::uint32_t>(value)); }
  void add(Vec2 v) {
    add(v.x);
    add(v.y);
  }
  /// @}

  /// Returns the hash of all values added so far.
  std::uint64_t value() const;

 private:
  // One to one both in the word and in the state before it: that is what keeps a single difference alive to the end.
  // The addition keeps a run of zero words from being a fixed point.
  void mix(std::uint64_t word) {
    state_ = (state_ ^ word) * 0x9e37'79b9'7f4a'7c15U + 0xd1b5'4a32'd192'ed03U;
    state_ ^= state_ >> 32;
    ++words_;
  }

  std::uint64_t state_ = 0x243f'6a88'85a3'08d3U;
  std::uint64_t words_ = 0;
};

/// The kind of a part of the state. The numbers are stored in recordings: append new ones, never renumber.
enum class Subsystem : std::uint8_t { game = 0, cord = 1, body = 2 };
inline constexpr int subsystem_count = 3;  ///< number of kinds

/// Returns "game", "cord" or "body".
std::string_view subsystem_name(Subsystem subsystem);

/// The hash of one cord, body or other part; used to name what differs.
struct StatePart {
  Subsystem subsystem = Subsystem::game;  ///< What it is.
  std::uint16_t index = 0;                ///< Which cord, which body.
  std::uint32_t hash = 0;                 ///< The lower half of its Hasher's value.

  bool operator==(const StatePart&) const = default;
};

/// The hash of a whole state: 32 bits per part, to name what differs, and 64 bits over the full hashes of all parts, to
/// detect any difference. Reuse one object and clear it before each tick: then it allocates memory only when the number
/// of parts grows.
class StateHash {
 public:
  StateHash() = default;
  /// Creates a hash that was read from a recording.
  StateHash(std::vector<StatePart> parts, std::uint64_t combined) : parts_(std::move(parts)), combined_(combined) {}

  /// Removes all parts and keeps their memory.
  void clear();
  /// Appends a part. The order of parts matters.
  void add(Subsystem subsystem, std::uint16_t index, const Hasher& hasher);

  std::span<const StatePart> parts() const { return parts_; }  ///< in the order of adding
  std::uint64_t combined() const { return combined_; }         ///< over all parts

  bool operator==(const StateHash&) const = default;

 private:
  std::vector<StatePart> parts_;
  std::uint64_t combined_ = 0;
};

/// The first difference of two states.
struct Divergence {
  /// The kind of a difference.
  enum class Kind {
    differs,   ///< The part is in both, with different hashes.
    missing,   ///< The part was recorded and is not there now.
    extra,     ///< The part is there now (or comes earlier now) and was not recorded.
    combined,  ///< All 32-bit hashes agree and the 64-bit one does not; subsystem and index say nothing.
  };
  Kind kind = Kind::differs;              ///< In what way.
  Subsystem subsystem = Subsystem::game;  ///< Of what.
  std::uint16_t index = 0;                ///< Which cord, which body.
  std::uint64_t recorded = 0;  ///< 32-bit hashes of the part, or both combined hashes; 0 where there is none.
  std::uint64_t computed = 0;  ///< The same of the other state.
};

/// Returns the first part, in recorded order, in which `computed` differs from `recorded`, or nothing if they are
/// equal.
std::optional<Divergence> first_difference(const StateHash& recorded, const StateHash& computed);

/// Returns a description, such as `cord 2 differs (recorded 89abcdef, now 01234567)`.
std::string describe(const Divergence& divergence);

/// Returns the 64-bit FNV-1a hash of the bytes.
std::uint64_t hash_bytes(std::string_view bytes);

/// Returns 16 lower-case hexadecimal digits.
std::string to_hex(std::uint64_t value);
/// Returns 8 lower-case hexadecimal digits.
std::string to_hex(std::uint32_t value);

}  // namespace ribbon::box2d
