#include "game/words/words.h"

#include <gtest/gtest.h>

namespace game::words {
namespace {

TEST(Words, NamesInBracesAreReplaced) {
  EXPECT_EQ(filled("{first} and {second}, {first}", {{"first", "a"}, {"second", "{first}"}}), "a and {first}, a");
  EXPECT_EQ(filled("no names", {{"first", "a"}}), "no names");
  EXPECT_EQ(filled("", {}), "");
}

TEST(Words, OtherBracesStay) {
  EXPECT_EQ(filled("{other} {first", {{"first", "a"}}), "{other} {first");
  EXPECT_EQ(filled("{{first}}", {{"first", "a"}}), "{a}");
  EXPECT_EQ(filled("}{", {}), "}{");
}

}  // namespace
}  // namespace game::words
