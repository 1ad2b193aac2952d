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
#include <string>
#include <vector>

#include "tests/engine/replay/recorded_replay.h"
#include "tests/support/files.h"
#include "tests/support/refusal.h"

// Writing a replay: refusals, full disks, killed processes.

namespace engine {
namespace {

using test_support::bytes_of;
using test_support::refusal;
using test_support::says;
using test_support::scratch;

TEST(ReplayWriter, AKilledGameHasWrittenAllItsTicks) {
  const std::string path = scratch("killed");
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

TEST(ReplayWriter, AFileThatWasNotFinishedIsTruncated) {
  const Replay replay = parse(recorded(3, false, "abandoned"));
  EXPECT_FALSE(replay.complete);
  expect_first_ticks(replay, 3);
}

TEST(ReplayWriter, ReportsWhyItCannotOpen) {
  const auto error = [](const std::string& path, const ReplayHeader& header) {
    return refusal<ReplayError>([&] { ReplayWriter(path, header).finish(); });
  };
  EXPECT_EQ(error("/nowhere/a", some_header()), "/nowhere/a: cannot write the replay: No such file or directory");
  EXPECT_TRUE(says(error(testing::TempDir(), some_header()), "Is a directory"));
  EXPECT_EQ(error("/dev/full", some_header()), "/dev/full: cannot write the replay: No space left on device");
}

/// Returns the error of `work` for an unprivileged user, as file permissions do not restrict root.
std::string error_without_rights(const std::function<void()>& work) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return "no pipe";
  const pid_t child = fork();
  if (child == 0) {
    constexpr uid_t unprivileged = 65534;
    std::string error = "none";
    if (geteuid() == 0 && setuid(unprivileged) != 0) error = "still root";
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

TEST(ReplayFile, WithoutPermissionIsNamedWithTheReason) {
  namespace fs = std::filesystem;
  const std::string folder = scratch("locked");
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

TEST(ReplayWriter, RefusesAnInvalidHeaderAndDoesNotTouchTheFile) {
  const std::string path = scratch("bad_header");
  std::ofstream(path) << "precious";
  ReplayHeader not_finite = some_header();
  not_finite.settings["gravity"] = std::numeric_limits<double>::infinity();
  ReplayHeader not_utf8 = some_header();
  not_utf8.level = "\xff";
  ReplayHeader no_rate = some_header();
  no_rate.tick_rate = 0;
  ReplayHeader three = some_header();
  three.players = 3;
  ReplayHeader too_long = some_header();
  too_long.level.assign(70'000, 'a');
  for (const ReplayHeader& header : {not_finite, not_utf8, no_rate, three, too_long}) {
    EXPECT_THROW(ReplayWriter(path, header), ReplayError);
  }
  EXPECT_EQ(bytes_of(path), "precious");
}

TEST(ReplayWriter, AFullDiskIsReportedOnceAndWrittenTicksStay) {
  const std::string path = scratch("full_disk");
  ReplayWriter writer(path, some_header());

  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit tight{1000, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &tight), 0);
  std::uint16_t written = 0;
  const std::string error = refusal<ReplayError>([&] {
    for (; written < 1000; ++written) writer.write(some_input(written), some_state(written));
  });
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
  const std::string path = scratch("parts");
  ReplayWriter writer(path, some_header());
  const ribbon::box2d::StateHash most(std::vector<ribbon::box2d::StatePart>(4096), 1);
  const ribbon::box2d::StateHash too_many(std::vector<ribbon::box2d::StatePart>(4097), 1);
  writer.write({}, most);
  EXPECT_THROW(writer.write({}, too_many), ReplayError);
  EXPECT_EQ(load_replay(path).ticks.size(), 1U);
}

}  // namespace
}  // namespace engine
