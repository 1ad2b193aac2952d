#include "engine/replay/replay.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace engine {
namespace {

/// This process's own directory, so that test runs side by side do not meet; gone when it ends.
class TempDirectory {
 public:
  TempDirectory() : path_(testing::TempDir() + "replay_test_" + std::to_string(getpid()) + "/") {
    std::filesystem::create_directories(path_);
  }
  TempDirectory(const TempDirectory&) = delete;
  TempDirectory& operator=(const TempDirectory&) = delete;
  ~TempDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

std::string temp_path(const std::string& name) {
  static const TempDirectory directory;
  return directory.path() + name;
}

std::string bytes_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  return bytes.str();
}

testing::AssertionResult says(const std::string& message, const std::string& part) {
  if (message.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "the message is: " << message << "\nand should say: " << part;
}

Replay parse(const std::string& bytes) {
  std::istringstream in(bytes);
  return read_replay(in, "swing.replay");
}

/// The error that reading these bytes ends in; empty if they are accepted.
std::string error_of(const std::string& bytes) {
  try {
    parse(bytes);
  } catch (const ReplayError& error) {
    return error.what();
  }
  return {};
}

ReplayHeader some_header() {
  return {.level = "Lianen-Übung.tmj",
          .level_hash = 0x0123456789abcdef,
          .tick_rate = 60,
          .settings = {{"gravity", -9.81}, {"solver", "implicit"}}};
}

TickInput some_input(std::uint16_t i) {
  return {i, static_cast<std::int16_t>(-300 - i), static_cast<std::int16_t>(0x7F00 + i)};
}

/// Tick i has i + 1 parts.
ribbon::box2d::StateHash some_state(std::uint16_t i) {
  ribbon::box2d::StateHash state;
  for (std::uint16_t part = 0; part <= i; ++part) {
    ribbon::box2d::Hasher hasher;
    hasher.add(i);
    hasher.add(part);
    state.add(static_cast<ribbon::box2d::Subsystem>(part % ribbon::box2d::subsystem_count), part, hasher);
  }
  return state;
}

void write_ticks(ReplayWriter& writer, std::uint16_t count) {
  for (std::uint16_t i = 0; i < count; ++i) writer.write(some_input(i), some_state(i));
}

std::string recorded(std::uint16_t ticks, bool finished, const std::string& name) {
  const std::string path = temp_path(name);
  {
    ReplayWriter writer(path, some_header());
    write_ticks(writer, ticks);
    if (finished) writer.finish();
  }
  return bytes_of(path);
}

/// That this is what was recorded, up to some tick.
void expect_first_ticks(const Replay& replay, std::size_t count) {
  EXPECT_EQ(replay.header, some_header());
  ASSERT_EQ(replay.ticks.size(), count);
  for (std::uint16_t i = 0; i < static_cast<std::uint16_t>(count); ++i) {
    EXPECT_EQ(replay.ticks[i].input, some_input(i));
    EXPECT_EQ(replay.ticks[i].state, some_state(i));
  }
}

/// CRC-32 by its definition, one bit at a time: independent of the writer's.
std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = 0xFFFF'FFFF;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1U) != 0 ? crc >> 1 ^ 0xEDB8'8320U : crc >> 1;
  }
  return ~crc;
}

/// A file made by hand, with the checksums as they should be.
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
  const std::string path = temp_path("round_trip");
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
  const std::string path = temp_path("settings");
  ReplayWriter(path, header).finish();
  EXPECT_EQ(load_replay(path).header, header);
}

TEST(Replay, TheFileIsAsDocumented) {
  // Byte by byte from the description of the format: a change to either breaks every replay that exists.
  const std::string path = temp_path("as_documented");
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

TEST(Replay, CutAnywhereIsAPrefixOrRefused) {
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

TEST(Replay, NoChangeToAByteOfAFileCutShortAltersWhatIsRead) {
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
  // Each record is sound by itself: only its place in the file is wrong.
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

/// The number after `word` in a message.
std::size_t number_after(const std::string& message, const std::string& word) {
  return std::stoul(message.substr(message.find(word) + word.size()));
}

TEST(Replay, WhatIsBeforeTheByteNamedAsDamagedIsAGoodReplay) {
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

/// A file on a disk that fails after so many bytes.
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

TEST(Replay, AReadingErrorIsNotTakenForTheEnd) {
  const std::string whole = recorded(4, true, "failing_disk");
  const std::size_t two = recorded(2, false, "failing_after").size();
  FailingDisk disk(whole, static_cast<std::streamsize>(two + 20));
  std::istream in(&disk);
  std::string error;
  try {
    read_replay(in, "swing.replay");
  } catch (const ReplayError& refused) {
    error = refused.what();
  }
  EXPECT_TRUE(says(error, "swing.replay: byte "));
  EXPECT_TRUE(says(error, "reading failed after tick 2"));
}

TEST(Replay, OtherVersionsAndOtherFilesAreRefused) {
  std::string other = recorded(1, true, "version");
  other.replace(17, 1, "2");
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

TEST(Replay, WhatFollowsTheEndMarkerIsRefused) {
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
  };
  for (const Case& wrong : cases) {
    EXPECT_TRUE(says(error_of(HandMade(wrong.json).file()), wrong.expected));
    EXPECT_TRUE(says(error_of(HandMade(wrong.json).file()), "swing.replay: byte 19: the header"));
  }
  EXPECT_TRUE(says(error_of(HandMade(std::string(60'000, '[')).file()), "levels deep"));
}

TEST(Replay, WhatIsNoFileIsRefused) {
  const auto error = [](const std::string& path) -> std::string {
    try {
      load_replay(path);
    } catch (const ReplayError& refused) {
      return refused.what();
    }
    return {};
  };
  EXPECT_EQ(error(testing::TempDir()), testing::TempDir() + ": is a directory, accepted is a file");
  EXPECT_EQ(error(temp_path("nowhere")), temp_path("nowhere") + ": there is no such file");
  EXPECT_EQ(error("/dev/zero"), "/dev/zero: is a device or pipe, accepted is a file");
}

TEST(ReplayWriter, AKilledGameLeavesAllItsTicks) {
  const std::string path = temp_path("killed");
  const pid_t child = fork();
  if (child == 0) {
    ReplayWriter writer(path, some_header());
    write_ticks(writer, 3);
    kill(getpid(), SIGKILL);
    _exit(0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  const Replay replay = load_replay(path);
  EXPECT_FALSE(replay.complete);
  expect_first_ticks(replay, 3);
}

TEST(ReplayWriter, DestroyedWithoutFinishReadsAsCutShort) {
  const Replay replay = parse(recorded(3, false, "abandoned"));
  EXPECT_FALSE(replay.complete);
  expect_first_ticks(replay, 3);
}

TEST(ReplayWriter, SaysWhyItCannotOpen) {
  const auto error = [](const std::string& path, const ReplayHeader& header) -> std::string {
    try {
      ReplayWriter(path, header).finish();
    } catch (const ReplayError& refused) {
      return refused.what();
    }
    return {};
  };
  EXPECT_EQ(error("/nowhere/a", some_header()), "/nowhere/a: cannot write the replay: No such file or directory");
  EXPECT_TRUE(says(error(testing::TempDir(), some_header()), "Is a directory"));
  EXPECT_EQ(error("/dev/full", some_header()), "/dev/full: cannot write the replay: No space left on device");
}

/// What the work ends in for somebody who is not root, and so has no right that a file does not give him.
std::string error_without_rights(const std::function<void()>& work) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return "no pipe";
  const pid_t child = fork();
  if (child == 0) {
    constexpr uid_t nobody = 65534;
    std::string error = "none";
    if (geteuid() == 0 && setuid(nobody) != 0) error = "still root";
    try {
      work();
    } catch (const std::exception& refused) {
      error = refused.what();
    }
    _exit(write(ends[1], error.data(), error.size()) < 0 ? 1 : 0);
  }
  close(ends[1]);
  std::array<char, 4096> buffer{};
  const ssize_t got = read(ends[0], buffer.data(), buffer.size());
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return {buffer.data(), got < 0 ? 0 : static_cast<std::size_t>(got)};
}

TEST(ReplayFile, WithoutTheRightToItIsNamedWithTheReason) {
  namespace fs = std::filesystem;
  const std::string folder = temp_path("locked");
  fs::create_directories(folder);
  const std::string path = folder + "/swing.replay";
  ReplayWriter(path, some_header()).finish();
  const std::string before = bytes_of(path);
  fs::permissions(path, fs::perms::none);
  constexpr fs::perms everybody_reads{0555};
  fs::permissions(folder, everybody_reads);

  EXPECT_EQ(error_without_rights([&] { load_replay(path); }), path + ": cannot be opened: Permission denied");
  const std::string refused = ": cannot write the replay: Permission denied";
  EXPECT_EQ(error_without_rights([&] { ReplayWriter(path, some_header()); }), path + refused);
  EXPECT_EQ(error_without_rights([&] { ReplayWriter(folder + "/b", some_header()); }), folder + "/b" + refused);

  fs::permissions(folder, fs::perms::owner_all);
  fs::permissions(path, fs::perms::owner_all);
  EXPECT_EQ(bytes_of(path), before);
}

TEST(ReplayWriter, RefusesAHeaderItCouldNotReadBackAndLeavesTheFileAlone) {
  const std::string path = temp_path("bad_header");
  std::ofstream(path) << "precious";
  ReplayHeader not_finite = some_header();
  not_finite.settings["gravity"] = std::numeric_limits<double>::infinity();
  ReplayHeader not_utf8 = some_header();
  not_utf8.level = "\xff";
  ReplayHeader no_rate = some_header();
  no_rate.tick_rate = 0;
  ReplayHeader too_long = some_header();
  too_long.level.assign(70'000, 'a');
  for (const ReplayHeader& header : {not_finite, not_utf8, no_rate, too_long}) {
    EXPECT_THROW(ReplayWriter(path, header), ReplayError);
  }
  EXPECT_EQ(bytes_of(path), "precious");
}

TEST(ReplayWriter, AFullDiskIsToldOnceAndWhatWasWrittenStays) {
  const std::string path = temp_path("full_disk");
  ReplayWriter writer(path, some_header());

  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit tight{1000, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &tight), 0);
  std::string error;
  std::uint16_t written = 0;
  try {
    for (; written < 1000; ++written) writer.write(some_input(written), some_state(written));
  } catch (const ReplayError& refused) {
    error = refused.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);

  EXPECT_EQ(error, path + ": cannot write the replay: File too large; the file keeps the " + std::to_string(written) +
                       " ticks before");
  EXPECT_TRUE(writer.failed());
  EXPECT_NO_THROW(writer.write(some_input(written), some_state(written)));
  EXPECT_NO_THROW(writer.finish());
  const Replay replay = load_replay(path);
  EXPECT_FALSE(replay.complete);
  EXPECT_GT(written, 3);
  EXPECT_EQ(writer.tick_count(), written);
  expect_first_ticks(replay, written);
}

TEST(ReplayWriter, RefusesMorePartsThanAReaderAccepts) {
  const std::string path = temp_path("parts");
  ReplayWriter writer(path, some_header());
  const ribbon::box2d::StateHash most(std::vector<ribbon::box2d::StatePart>(4096), 1);
  const ribbon::box2d::StateHash too_many(std::vector<ribbon::box2d::StatePart>(4097), 1);
  writer.write({}, most);
  EXPECT_THROW(writer.write({}, too_many), ReplayError);
  EXPECT_EQ(load_replay(path).ticks.size(), 1U);
}

TEST(ReplayHeader, FitsWhatItWasRecordedWith) { EXPECT_NO_THROW(check_header(some_header(), some_header())); }

TEST(ReplayHeader, NamesTheFirstFieldThatDiffers) {
  const auto error = [](const ReplayHeader& current) -> std::string {
    try {
      check_header(some_header(), current);
    } catch (const ReplayError& refused) {
      return refused.what();
    }
    return {};
  };
  ReplayHeader other = some_header();
  other.settings["solver"] = "thesis";
  EXPECT_EQ(error(other),
            "the replay does not fit: setting \"solver\" differs (recorded \"implicit\", now \"thesis\")");
  other.settings["gravity"] = -1.62;
  EXPECT_TRUE(says(error(other), "setting \"gravity\" differs (recorded -9.81, now -1.62)"));
  other.settings.erase("gravity");
  EXPECT_TRUE(says(error(other), "setting \"gravity\" differs (recorded -9.81, now none)"));
  other.settings["friction"] = "0.5";
  EXPECT_TRUE(says(error(other), "setting \"friction\" differs (recorded none, now \"0.5\")"));
  other.tick_rate = 120;
  EXPECT_TRUE(says(error(other), "tick rate differs (recorded 60, now 120)"));
  other.level_hash = 1;
  EXPECT_TRUE(says(error(other), "level hash differs (recorded 0123456789abcdef, now 0000000000000001)"));
  other.level = "b";
  EXPECT_TRUE(says(error(other), "level differs (recorded \"Lianen-Übung.tmj\", now \"b\")"));
}

TEST(ReplayVerifier, AllTicksEqualIsVerified) {
  const Replay replay = parse(recorded(3, true, "verified"));
  ReplayVerifier verifier(replay);
  for (std::uint16_t i = 0; i < 3; ++i) {
    ASSERT_FALSE(verifier.done());
    EXPECT_EQ(verifier.input(), some_input(i));
    EXPECT_TRUE(verifier.check(some_state(i)));
  }
  EXPECT_TRUE(verifier.done());
  EXPECT_EQ(verifier.result().outcome, VerifyOutcome::verified);
  EXPECT_EQ(verifier.result().message(), "verified 3 ticks, hash " + ribbon::box2d::to_hex(some_state(2).combined()));
  EXPECT_EQ(exit_status(verifier.result().outcome), 0);
}

TEST(ReplayVerifier, StopsAtTheFirstDifferenceAndNamesTickAndPart) {
  Replay replay = parse(recorded(5, true, "diverged"));
  const ribbon::box2d::StateHash first({{ribbon::box2d::Subsystem::cord, 2, 0x89abcdef}}, 1);
  const ribbon::box2d::StateHash now({{ribbon::box2d::Subsystem::cord, 2, 0x01234567}}, 2);
  replay.ticks[2].state = first;
  ReplayVerifier verifier(replay);
  EXPECT_TRUE(verifier.check(some_state(0)));
  EXPECT_TRUE(verifier.check(some_state(1)));
  EXPECT_FALSE(verifier.check(now));
  EXPECT_TRUE(verifier.done());
  EXPECT_EQ(verifier.result().outcome, VerifyOutcome::diverged);
  EXPECT_EQ(verifier.result().message(), "tick 3: cord 2 differs (recorded 89abcdef, now 01234567)");
  EXPECT_EQ(exit_status(verifier.result().outcome), 1);
}

TEST(ReplayVerifier, CutShortIsSaidAfterItsTicksAreVerified) {
  const Replay replay = parse(recorded(2, false, "cut"));
  ReplayVerifier agreeing(replay);
  EXPECT_TRUE(agreeing.check(some_state(0)));
  EXPECT_TRUE(agreeing.check(some_state(1)));
  EXPECT_TRUE(agreeing.done());
  EXPECT_EQ(agreeing.result().message(), "cut short after 2 ticks");
  EXPECT_EQ(exit_status(agreeing.result().outcome), 2);

  ReplayVerifier diverging(replay);
  EXPECT_FALSE(diverging.check(some_state(1)));
  EXPECT_EQ(exit_status(diverging.result().outcome), 1) << "a difference outweighs the missing end";
}

TEST(ReplayVerifier, LeftBeforeTheEndIsNotVerified) {
  const Replay replay = parse(recorded(2, true, "left"));
  ReplayVerifier verifier(replay);
  verifier.check(some_state(0));
  EXPECT_EQ(verifier.result().outcome, VerifyOutcome::cut_short);
  EXPECT_EQ(verifier.result().message(), "cut short after 1 ticks");
}

TEST(ReplayVerifier, AnEmptyReplayIsVerifiedAtOnce) {
  const Replay replay = parse(recorded(0, true, "empty"));
  const ReplayVerifier verifier(replay);
  EXPECT_TRUE(verifier.done());
  EXPECT_EQ(verifier.result().message(), "verified 0 ticks, hash 0000000000000000");
}

}  // namespace
}  // namespace engine
