#include "engine/files/file_watch.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

namespace {

using engine::FileWatch;
using Stamp = FileWatch::Stamp;

constexpr std::int64_t period = FileWatch::period_ns;

/// A simulated file whose state the test sets.
struct Told {
  std::optional<Stamp> now = Stamp{10, 100};
  int looks = 0;
  FileWatch watch{"a.tmj", [this](const std::string&) {
                    ++looks;
                    return now;
                  }};
};

TEST(FileWatch, AChangeIsReportedOnceAndAfterItHasSettled) {
  Told file;
  EXPECT_FALSE(file.watch.poll(period));
  file.now = Stamp{20, 100};
  EXPECT_FALSE(file.watch.poll(period)) << "it may be half written";
  EXPECT_TRUE(file.watch.poll(period));
  for (int k = 0; k < 5; ++k) EXPECT_FALSE(file.watch.poll(period));
}

TEST(FileWatch, AFileThatIsBeingWrittenIsNotYetReported) {
  Told file;
  for (std::uintmax_t size = 0; size < 10; ++size) {
    file.now = Stamp{20, size};
    EXPECT_FALSE(file.watch.poll(period)) << size;
  }
  EXPECT_TRUE(file.watch.poll(period));
}

TEST(FileWatch, ABrieflyMissingFileHasNotChanged) {
  Told file;
  file.now.reset();
  for (int k = 0; k < 4; ++k) EXPECT_FALSE(file.watch.poll(period));
  file.now = Stamp{10, 100};
  for (int k = 0; k < 4; ++k) EXPECT_FALSE(file.watch.poll(period));
  file.now.reset();
  EXPECT_FALSE(file.watch.poll(period));
  file.now = Stamp{11, 100};
  EXPECT_FALSE(file.watch.poll(period));
  EXPECT_TRUE(file.watch.poll(period));
}

TEST(FileWatch, ItChecksTwiceASecond) {
  Told file;
  const int before = file.looks;
  for (int frame = 0; frame < 600; ++frame) file.watch.poll(1'000'000'000 / 60);
  EXPECT_LE(file.looks - before, 20);
  EXPECT_GE(file.looks - before, 18);
}

TEST(FileWatch, ItSeesRealFiles) {
  const std::string path = testing::TempDir() + "watched.tmj";
  EXPECT_FALSE(FileWatch::stamp_of("/no/such/file"));
  std::ofstream(path) << "one";
  const auto one = FileWatch::stamp_of(path);
  ASSERT_TRUE(one);
  EXPECT_EQ(one->size, 3U);
  std::filesystem::last_write_time(path, std::filesystem::last_write_time(path) + std::chrono::seconds(1));
  EXPECT_NE(FileWatch::stamp_of(path), one);
  std::filesystem::remove(path);
}

}  // namespace
