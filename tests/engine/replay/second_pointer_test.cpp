// The pointer of a second player in recordings, which those without one do not have.

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "tests/engine/replay/recorded_replay.h"

namespace engine {
namespace {

using test_support::says;

constexpr std::size_t end_marker = 9;  // bytes

ReplayHeader header_for(int players) {
  ReplayHeader header = some_header();
  header.players = players;
  return header;
}

/// Every other tick has a pointer of the second player.
TickInput input_of_tick(std::uint16_t i) {
  TickInput input = some_input(i);
  input.second_buttons = static_cast<std::uint16_t>(0x4000 + i);
  if (i % 2 == 1) set_second_pointer(input, {-1.5 - i, 300.0});
  return input;
}

std::string recorded_with_pointers(std::uint16_t ticks, const std::string& name, int players = 2) {
  const std::string path = scratch(name);
  ReplayWriter writer(path, header_for(players));
  for (std::uint16_t i = 0; i < ticks; ++i) writer.write(input_of_tick(i), some_state(i));
  writer.finish();
  return bytes_of(path);
}

std::string bytes_from(std::vector<int> values) { return {values.begin(), values.end()}; }

TEST(SecondPointer, IsInItsTicksOnly) {
  const Replay replay = parse(recorded_with_pointers(4, "pointers"));
  ASSERT_EQ(replay.ticks.size(), 4U);
  EXPECT_TRUE(replay.complete);
  for (std::uint16_t i = 0; i < 4; ++i) {
    EXPECT_EQ(replay.ticks[i].input, input_of_tick(i)) << i;
    EXPECT_EQ(replay.ticks[i].state, some_state(i)) << i;
  }
  EXPECT_EQ(second_pointer(replay.ticks[1].input), (ribbon::Vec2{-2.5, 300.0}));
  EXPECT_FALSE(second_pointer(replay.ticks[2].input));
}

TEST(SecondPointer, IsAsDocumented) {
  const std::string path = scratch("documented_pointer");
  {
    ReplayWriter writer(path, header_for(2));
    TickInput input{.buttons = 0x8001, .pointer_x_cm = -2, .pointer_y_cm = 258, .second_buttons = 0x0203};
    set_second_pointer(input, {0.03, -0.04});
    writer.write(input, ribbon::box2d::StateHash({}, 0x0102030405060708));
    writer.finish();
  }
  const std::string none = recorded_with_pointers(0, "no_pointer");
  const std::string tick = bytes_of(path).substr(none.size() - end_marker);
  EXPECT_EQ(tick.substr(0, 25),
            bytes_from({'T',  0x00, 0x80, 0xff, 0x7f, 0x01, 0x80, 0xfe, 0xff, 0x02, 0x01, 0x03, 0x02,
                        0x03, 0x00, 0xfc, 0xff, 0x08, 0x07, 0x06, 0x05, 0x04, 0x03, 0x02, 0x01}));
}

TEST(SecondPointer, IsNotRecordedOfOnePlayer) {
  const std::string bytes = recorded_with_pointers(2, "pointer_of_one", 1);
  EXPECT_FALSE(parse(bytes).ticks.at(1).input.second_has_pointer);
  EXPECT_EQ(bytes, recorded(2, true, "plain_one")) << "the same bytes as ever";
}

TEST(SecondPointer, IsRefusedAfterAnyChangeToAByte) {
  expect_every_bit_to_matter(recorded_with_pointers(2, "pointers_flipped"));
}

/// A longer record would look like one that is cut short.
TEST(SecondPointer, AFlagThatIsDamagedIsNoCut) {
  const std::string header = recorded_with_pointers(0, "flag_header");
  const std::string one = recorded_with_pointers(1, "flag_of_one");
  std::string unfinished = one.substr(0, one.size() - end_marker);
  ASSERT_EQ(parse(unfinished).ticks.size(), 1U);
  constexpr std::size_t flag_byte = 2;  // of the record
  char& flag = unfinished[header.size() - end_marker + flag_byte];
  flag = static_cast<char>(static_cast<unsigned char>(flag) ^ 0x80U);
  EXPECT_TRUE(says(error_of(unfinished), "the part count and its complement disagree"));
}

TEST(SecondPointer, CutShortKeepsWholeTicks) {
  const std::string whole = recorded_with_pointers(3, "pointers_cut");
  const std::size_t header = recorded_with_pointers(0, "pointers_header").size() - end_marker;
  std::size_t ticks = 0;
  for (std::size_t size = header; size < whole.size(); ++size) {
    const Replay replay = parse(whole.substr(0, size));
    ASSERT_FALSE(replay.complete);
    ASSERT_GE(replay.ticks.size(), ticks);
    ticks = replay.ticks.size();
    for (std::size_t k = 0; k < ticks; ++k) {
      EXPECT_EQ(replay.ticks[k].input, input_of_tick(static_cast<std::uint16_t>(k)));
    }
  }
  EXPECT_EQ(ticks, 3U);
}

}  // namespace
}  // namespace engine
