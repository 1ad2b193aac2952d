#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <sstream>
#include <string>

#include "engine/replay/replay.h"
#include "tests/support/files.h"
#include "tests/support/refusal.h"

namespace engine {

using test_support::bytes_of;
using test_support::refusal;
using test_support::scratch;

inline Replay parse(const std::string& bytes) {
  std::istringstream in(bytes);
  return read_replay(in, "swing.replay");
}

inline std::string error_of(const std::string& bytes) {
  return refusal<ReplayError>([&] { parse(bytes); });
}

/// Expects that a recording is refused after a change to any bit of it.
inline void expect_every_bit_to_matter(const std::string& whole) {
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string changed = whole;
    for (int bit = 0; bit < 8; ++bit) {
      changed[at] = static_cast<char>(static_cast<unsigned char>(whole[at]) ^ (1U << bit));
      ASSERT_TRUE(test_support::says(error_of(changed), "swing.replay: byte ")) << "byte " << at << ", bit " << bit;
    }
  }
}

inline ReplayHeader some_header() {
  return {.level = "Lianen-Übung.tmj",
          .level_hash = 0x0123456789abcdef,
          .tick_rate = 60,
          .settings = {{"gravity", -9.81}, {"solver", "implicit"}}};
}

inline TickInput some_input(std::uint16_t i) {
  return {i, static_cast<std::int16_t>(-300 - i), static_cast<std::int16_t>(0x7F00 + i)};
}

/// Tick i has i + 1 parts.
inline ribbon::box2d::StateHash some_state(std::uint16_t i) {
  ribbon::box2d::StateHash state;
  for (std::uint16_t part = 0; part <= i; ++part) {
    ribbon::box2d::Hasher hasher;
    hasher.add(i);
    hasher.add(part);
    state.add(static_cast<ribbon::box2d::Subsystem>(part % ribbon::box2d::subsystem_count), part, hasher);
  }
  return state;
}

inline void write_ticks(ReplayWriter& writer, std::uint16_t count) {
  for (std::uint16_t i = 0; i < count; ++i) writer.write(some_input(i), some_state(i));
}

inline std::string recorded(std::uint16_t ticks, bool finished, const std::string& name) {
  const std::string path = scratch(name);
  {
    ReplayWriter writer(path, some_header());
    write_ticks(writer, ticks);
    if (finished) writer.finish();
  }
  return bytes_of(path);
}

/// Checks that the replay has the recorded header and the first `count` recorded ticks.
inline void expect_first_ticks(const Replay& replay, std::size_t count) {
  EXPECT_EQ(replay.header, some_header());
  ASSERT_EQ(replay.ticks.size(), count);
  for (std::uint16_t i = 0; i < static_cast<std::uint16_t>(count); ++i) {
    EXPECT_EQ(replay.ticks[i].input, some_input(i));
    EXPECT_EQ(replay.ticks[i].state, some_state(i));
  }
}

}  // namespace engine
