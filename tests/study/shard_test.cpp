#include "tests/study/shard.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "tests/support/refusal.h"

namespace study {
namespace {

TEST(Shard, AllShardsTogetherHaveEachItemOnceInOrder) {
  for (const std::size_t items : {0U, 1U, 7U, 100U}) {
    for (const std::size_t count : {1U, 2U, 3U, 8U, 120U}) {
      std::vector<std::size_t> all;
      for (std::size_t number = 1; number <= count; ++number) {
        std::size_t own = 0;
        for (std::size_t item = 0; item < items; ++item) {
          if (!(Shard{number, count}.has(item, items))) continue;
          all.push_back(item);
          ++own;
        }
        EXPECT_LE(own, items / count + 1);
        EXPECT_GE(own, items / count);
      }
      ASSERT_EQ(all.size(), items) << count;
      for (std::size_t item = 0; item < items; ++item) EXPECT_EQ(all[item], item);
    }
  }
}

TEST(Shard, IsTwoNumbers) {
  EXPECT_EQ(shard_of("2/8").number, 2U);
  EXPECT_EQ(shard_of("2/8").count, 8U);
  EXPECT_TRUE(shard_of("1/1").is_whole());
  for (const char* text : {"", "2", "/", "0/8", "9/8", "2/8x", "a/8", "-1/8", "1/0", "1/100001", "2 /8"}) {
    const std::string said = test_support::refusal<std::invalid_argument>([&] { shard_of(text); });
    EXPECT_NE(said.find("accepted is K/N"), std::string::npos) << text << ": " << said;
  }
}

}  // namespace
}  // namespace study
