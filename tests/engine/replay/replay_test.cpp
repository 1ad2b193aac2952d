#include "engine/replay/replay.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>

#include "tests/engine/replay/recorded_replay.h"
#include "tests/support/files.h"
#include "tests/support/refusal.h"

namespace engine {
namespace {

using test_support::bytes_of;
using test_support::refusal;
using test_support::says;
using test_support::scratch;

/// Returns the CRC-32 by its definition, one bit at a time, independent of the writer's code.
std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = 0xFFFF'FFFF;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1U) != 0 ? crc >> 1 ^ 0xEDB8'8320U : crc >> 1;
  }
  return ~crc;
}

/// A hand-made file with correct checksums.
class HandMade {
 public:
  explicit HandMade(const std::string& json) { add("ropeswing-replay 1\n" + json + "\n"); }

  HandMade& add(std::string_view record) {
    content_ += record;
    file_ += record;
    const std::uint32_t crc = crc32(content_);
    for (int shift = 0; shift < 32; shift += 8) file_ += static_cast<char>(crc >> shift & 0xFFU);
    return *this;
  }

  const std::string& file() const { return file_; }

 private:
  std::string content_;
  std::string file_;
};

const std::string json = R"({"level":"a","level_hash":"00000000000000ff","settings":{},"tick_rate":50})";

template <std::size_t N>
std::string_view bytes(const char (&literal)[N]) {
  return {literal, N - 1};
}

TEST(Replay, ReadsBackWhatWasWritten) {
  const std::string path = scratch("round_trip");
  ReplayWriter writer(path, some_header());
  write_ticks(writer, 5);
  EXPECT_EQ(writer.tick_count(), 5U);
  writer.finish();

  const Replay replay = load_replay(path);
  EXPECT_TRUE(replay.complete);
  expect_first_ticks(replay, 5);
}

TEST(Replay, WithoutTicksIsComplete) {
  const Replay replay = parse(recorded(0, true, "no_ticks"));
  EXPECT_TRUE(replay.complete);
  expect_first_ticks(replay, 0);
}

TEST(Replay, SettingsKeepEveryBitOfTheirNumbers) {
  ReplayHeader header;
  header.settings = {{"third", 1.0 / 3.0},
                     {"least", std::numeric_limits<double>::denorm_min()},
                     {"most", std::numeric_limits<double>::max()},
                     {"whole", 3.0},
                     {"text", "3"},
                     {"line\nfeed", "a\nb"}};
  const std::string path = scratch("settings");
  ReplayWriter(path, header).finish();
  EXPECT_EQ(load_replay(path).header, header);
}

TEST(Replay, TheFileIsAsDocumented) {
  // Byte by byte from the description of the format: a change of either breaks all existing replays.
  const std::string path = scratch("as_documented");
  ReplayWriter writer(path, {.level = "a", .level_hash = 0xff, .tick_rate = 50, .settings = {}});
  const ribbon::box2d::StateHash state({{ribbon::box2d::Subsystem::cord, 0x0102, 0x11223344}}, 0x0102030405060708);
  writer.write({.buttons = 0x8001, .pointer_x_cm = -2, .pointer_y_cm = 258}, state);
  writer.finish();

  HandMade expected(json);
  expected.add(
      bytes("T\x01\x00\xfe\xff"
            "\x01\x80\xfe\xff\x02\x01"
            "\x01\x02\x01\x44\x33\x22\x11"
            "\x08\x07\x06\x05\x04\x03\x02\x01"));
  expected.add(bytes("E\x01\x00\x00\x00"));
  EXPECT_EQ(bytes_of(path), expected.file());
}

/// A run of two players, whose ticks are longer.
std::string recorded_of_two(std::uint16_t ticks, const std::string& name) {
  const std::string path = scratch(name);
  ReplayHeader header = some_header();
  header.players = 2;
  ReplayWriter writer(path, header);
  for (std::uint16_t i = 0; i < ticks; ++i) {
    TickInput input = some_input(i);
    input.second_buttons = static_cast<std::uint16_t>(0x8000 + i);
    writer.write(input, some_state(i));
  }
  writer.finish();
  return bytes_of(path);
}

TEST(ReplayOfTwo, IsAsDocumented) {
  const std::string path = scratch("two_as_documented");
  ReplayWriter writer(path, {.level = "a", .level_hash = 0xff, .tick_rate = 50, .settings = {}, .players = 2});
  writer.write({.buttons = 0x8001, .pointer_x_cm = -2, .pointer_y_cm = 258, .second_buttons = 0x0203},
               ribbon::box2d::StateHash({}, 0x0102030405060708));
  writer.finish();

  HandMade expected(R"({"level":"a","level_hash":"00000000000000ff","players":2,"settings":{},"tick_rate":50})");
  expected.add(
      bytes("T\x00\x00\xff\xff"
            "\x01\x80\xfe\xff\x02\x01"
            "\x03\x02"
            "\x08\x07\x06\x05\x04\x03\x02\x01"));
  expected.add(bytes("E\x01\x00\x00\x00"));
  EXPECT_EQ(bytes_of(path), expected.file());
}

TEST(ReplayOfTwo, KeepsTheButtonsOfBoth) {
  const Replay replay = parse(recorded_of_two(3, "two"));
  EXPECT_EQ(replay.header.players, 2);
  EXPECT_TRUE(replay.complete);
  ASSERT_EQ(replay.ticks.size(), 3U);
  for (std::uint16_t i = 0; i < 3; ++i) {
    EXPECT_EQ(replay.ticks[i].input.buttons, i);
    EXPECT_EQ(replay.ticks[i].input.second_buttons, 0x8000 + i);
    EXPECT_EQ(replay.ticks[i].state, some_state(i));
  }
}

TEST(ReplayOfTwo, IsRefusedAfterAnyChangeToAByte) { expect_every_bit_to_matter(recorded_of_two(2, "two_flipped")); }

TEST(ReplayOfTwo, CutShortKeepsItsWholeTicks) {
  const std::string whole = recorded_of_two(3, "two_cut");
  const std::size_t header_size = recorded_of_two(0, "two_header").size() - 9;  // without the end marker
  std::size_t ticks = 0;
  for (std::size_t size = header_size; size < whole.size(); ++size) {
    const Replay replay = parse(whole.substr(0, size));
    EXPECT_FALSE(replay.complete);
    ASSERT_GE(replay.ticks.size(), ticks);
    ticks = replay.ticks.size();
    for (std::size_t k = 0; k < ticks; ++k) EXPECT_EQ(replay.ticks[k].input.second_buttons, 0x8000 + k);
  }
  EXPECT_EQ(ticks, 3U);
}

TEST(Replay, OfOnePlayerHasNoWordOfASecond) {
  const std::string path = scratch("one");
  ReplayWriter writer(path, {.level = "a", .level_hash = 0xff, .tick_rate = 50, .settings = {}});
  writer.write({.buttons = 1, .second_buttons = 0x0203}, ribbon::box2d::StateHash({}, 0));
  writer.finish();
  EXPECT_EQ(bytes_of(path).find("players"), std::string::npos);
  EXPECT_EQ(load_replay(path).ticks.at(0).input.second_buttons, 0);
}

TEST(Replay, ATruncatedFileIsAPrefixOrRefused) {
  const std::string whole = recorded(4, true, "truncated");
  const std::size_t header_size = recorded(0, false, "header_only").size();
  std::size_t ticks_before = 0;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    SCOPED_TRACE("cut to " + std::to_string(size) + " bytes");
    const std::string cut = whole.substr(0, size);
    if (size < header_size) {
      const std::string error = error_of(cut);
      EXPECT_TRUE(says(error, "swing.replay: byte "));
      EXPECT_TRUE(says(error, size == 0 ? "the file is empty" : "the file ends within"));
      continue;
    }
    const Replay replay = parse(cut);
    EXPECT_FALSE(replay.complete);
    ASSERT_GE(replay.ticks.size(), ticks_before);
    ticks_before = replay.ticks.size();
    expect_first_ticks(replay, replay.ticks.size());
  }
  EXPECT_EQ(ticks_before, 4U) << "a file without its end marker has all its ticks";
}

TEST(Replay, EveryChangeToAByteOfACompleteFileIsRefused) {
  const std::string whole = recorded(3, true, "flipped");
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string changed = whole;
    for (int value = 0; value < 256; ++value) {
      changed[at] = static_cast<char>(value);
      if (changed[at] == whole[at]) continue;
      ASSERT_TRUE(says(error_of(changed), "swing.replay: byte ")) << "byte " << at << " set to " << value;
    }
  }
}

TEST(Replay, NoChangeToAByteOfATruncatedFileAltersItsTicks) {
  const std::string whole = recorded(3, true, "flipped_cut");
  const std::string cut = whole.substr(0, whole.size() - 9 - 12);  // within the last tick
  ASSERT_EQ(parse(cut).ticks.size(), 2U);
  for (std::size_t at = 0; at < cut.size(); ++at) {
    std::string changed = cut;
    for (int value = 0; value < 256; ++value) {
      changed[at] = static_cast<char>(value);
      try {
        const Replay replay = parse(changed);
        ASSERT_FALSE(replay.complete);
        expect_first_ticks(replay, 2);
      } catch (const ReplayError&) {
      }
    }
  }
}

TEST(Replay, RecordsLostRepeatedOrMovedAreRefused) {
  // Each record is valid; only its place in the file is wrong.
  const std::string header = recorded(0, false, "r0");
  const std::string one = recorded(1, false, "r1").substr(header.size());
  const std::string two = recorded(2, false, "r2").substr(header.size() + one.size());
  ASSERT_EQ(parse(header + one + two).ticks.size(), 2U);
  EXPECT_TRUE(says(error_of(header + two), "damaged after tick 0: the checksum is"));
  EXPECT_TRUE(says(error_of(header + two + one), "damaged after tick 0"));
  EXPECT_TRUE(says(error_of(header + one + one), "damaged after tick 1"));
}

TEST(Replay, DamageInTheMiddleNamesByteAndTick) {
  std::string damaged = recorded(4, true, "damaged");
  const std::size_t third = recorded(2, false, "before_damage").size();
  damaged[third + 7] = static_cast<char>(damaged[third + 7] ^ 0x10);
  EXPECT_TRUE(says(error_of(damaged),
                   "swing.replay: byte " + std::to_string(third) + ": damaged after tick 2: the checksum is "));
}

/// Returns the number after `word` in a message.
std::size_t number_after(const std::string& message, const std::string& word) {
  return std::stoul(message.substr(message.find(word) + word.size()));
}

TEST(Replay, ThePartBeforeTheDamagedByteIsAValidReplay) {
  const std::string whole = recorded(4, true, "salvaged");
  for (std::size_t at = recorded(0, false, "salvaged_header").size(); at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x04);
    const std::string error = error_of(damaged);
    SCOPED_TRACE(error);
    const Replay kept = parse(damaged.substr(0, number_after(error, "byte ")));
    EXPECT_FALSE(kept.complete);
    expect_first_ticks(kept, number_after(error, "after tick "));
  }
}

/// A file on a disk that fails after `good` bytes.
class FailingDisk : public std::stringbuf {
 public:
  FailingDisk(const std::string& bytes, std::streamsize good) : std::stringbuf(bytes), left_(good) {}

 protected:
  std::streamsize xsgetn(char* to, std::streamsize count) override {
    if (count > left_) throw std::runtime_error("Input/output error");
    left_ -= count;
    return std::stringbuf::xsgetn(to, count);
  }

 private:
  std::streamsize left_;
};

TEST(Replay, AReadErrorIsNotTheEndOfTheFile) {
  const std::string whole = recorded(4, true, "failing_disk");
  const std::size_t two = recorded(2, false, "failing_after").size();
  FailingDisk disk(whole, static_cast<std::streamsize>(two + 20));
  std::istream in(&disk);
  const std::string error = refusal<ReplayError>([&] { read_replay(in, "swing.replay"); });
  EXPECT_TRUE(says(error, "swing.replay: byte "));
  EXPECT_TRUE(says(error, "reading failed after tick 2"));
}

TEST(Replay, OtherVersionsAndOtherFilesAreRefused) {
  std::string other = recorded(1, true, "version");
  other[17] = '2';
  EXPECT_EQ(error_of(other), "swing.replay: byte 17: the version is \"2\", accepted is \"1\"");
  other.replace(17, 1, "10");
  EXPECT_TRUE(says(error_of(other), "the version is \"10\""));
  EXPECT_TRUE(says(error_of("{\n  \"type\": \"map\"\n}\n"), "not a replay: it begins with \"{\""));
  EXPECT_TRUE(says(error_of(std::string(100'000, '\0')), "not a replay"));
  EXPECT_TRUE(says(error_of("ropeswing-replay 1\r\n{}\n"), "the version is \"1\\x0d\""));
  EXPECT_TRUE(says(error_of(""), "the file is empty"));
}

TEST(Replay, ImpossibleSizesAreRefusedAtOnce) {
  EXPECT_TRUE(
      says(error_of("ropeswing-replay 1\n" + std::string(100'000, ' ')), "no end within the 65536 bytes accepted"));
  const std::string header = HandMade(json).file();
  EXPECT_TRUE(says(error_of(header + std::string(bytes("T\xff\xff\x00\x00"))),
                   "the part count is 65535, accepted is up to 4096"));
  EXPECT_TRUE(says(error_of(header + std::string(bytes("T\x01\x10\xfe\xef"))), "the part count is 4097"));
  EXPECT_TRUE(says(error_of(header + std::string(bytes("T\xff\x00\x01\xff"))), "complement"));
}

TEST(Replay, DataAfterTheEndMarkerIsRefused) {
  const std::string whole = recorded(2, true, "trailing");
  EXPECT_TRUE(says(error_of(whole + '\0'), "bytes follow the end marker"));
  EXPECT_TRUE(says(error_of(whole + whole), "bytes follow the end marker"));
  EXPECT_TRUE(says(error_of(HandMade(json).add(bytes("E\x07\x00\x00\x00")).file()),
                   "the end marker counts 7 ticks, the file has 0"));
}

TEST(Replay, AnUnknownSubsystemIsRefused) {
  const HandMade file =
      HandMade(json).add(bytes("T\x01\x00\xfe\xff"
                               "\0\0\0\0\0\0"
                               "\x03\0\0\0\0\0\0"
                               "\0\0\0\0\0\0\0\0"));
  EXPECT_TRUE(says(error_of(file.file()), "subsystem is 3, accepted is 0 to 2"));
}

TEST(Replay, HeaderFaultsNameTheField) {
  struct Case {
    const char* json;
    const char* expected;
  };
  const std::array cases{
      Case{"[1, 2]", "found is an array, accepted is an object"},
      Case{"{\"level\":", "not valid JSON: parse error at line 1"},
      Case{R"({"level_hash":"00000000000000ff","settings":{},"tick_rate":50})", "\"level\" is missing"},
      Case{R"({"level":7,"level_hash":"00000000000000ff","settings":{},"tick_rate":50})", "\"level\" is 7"},
      Case{R"({"level":"a","level_hash":"FF","settings":{},"tick_rate":50})", "\"level_hash\" is \"FF\""},
      Case{R"({"level":"a","level_hash":"00000000000000ff","settings":{},"tick_rate":0})",
           "\"tick_rate\" is 0, accepted is a whole number from 1 to 1000000"},
      Case{R"({"level":"a","level_hash":"00000000000000ff","settings":{},"tick_rate":18446744073709551615})",
           "\"tick_rate\" is 18446744073709551615"},
      Case{R"({"level":"a","level_hash":"00000000000000ff","settings":{},"tick_rate":60.5})", "\"tick_rate\" is 60.5"},
      Case{R"({"level":"a","level_hash":"00000000000000ff","settings":[],"tick_rate":50})",
           "\"settings\" is an array, accepted is an object"},
      Case{R"({"level":"a","level_hash":"00000000000000ff","settings":{"x":true},"tick_rate":50})",
           "settings: \"x\" is true, accepted is a number or a text"},
      Case{R"({"level":"a","level_hash":"00000000000000ff","settings":{"x\u0000y":true},"tick_rate":50})",
           "settings: \"x\\x00y\" is true, accepted is a number or a text"},
      Case{R"({"level":"a","level_hash":"00000000000000ff","settings":{},"tick_rate":50,"z":1})", "\"z\" is unknown"},
      Case{R"({"level":"a","level_hash":"00000000000000ff","settings":{},"tick_rate":50,"players":3})",
           "\"players\" is 3, accepted is a whole number from 1 to 2"},
  };
  for (const Case& wrong : cases) {
    EXPECT_TRUE(says(error_of(HandMade(wrong.json).file()), wrong.expected));
    EXPECT_TRUE(says(error_of(HandMade(wrong.json).file()), "swing.replay: byte 19: the header"));
  }
  EXPECT_TRUE(says(error_of(HandMade(std::string(60'000, '[')).file()), "levels deep"));
}

TEST(Replay, FoldersDevicesAndMissingFilesAreRefused) {
  const auto error = [](const std::string& path) { return refusal<ReplayError>([&] { load_replay(path); }); };
  EXPECT_EQ(error(testing::TempDir()), testing::TempDir() + ": is a directory, accepted is a file");
  EXPECT_EQ(error(scratch("nowhere")), scratch("nowhere") + ": there is no such file");
  EXPECT_EQ(error("/dev/zero"), "/dev/zero: is a device or pipe, accepted is a file");
}

}  // namespace
}  // namespace engine
