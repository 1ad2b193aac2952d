#include "game/screens/hint.h"

#include <gtest/gtest.h>

#include "game/simulation/buttons.h"

namespace game {
namespace {

void tick(Hint& hint, int buttons, int ticks, bool holds = false) {
  for (int k = 0; k < ticks; ++k) hint.tick(static_cast<std::uint16_t>(buttons), holds);
}

TEST(Hint, StaysUntilAllThatItNamesWasDoneAndAMomentLonger) {
  Hint hint;
  EXPECT_FALSE(hint.is_shown());
  hint.begin("{right} runs, hold {grab} at a rope");
  tick(hint, 0, 3600);
  EXPECT_TRUE(hint.is_shown()) << "before any input";
  tick(hint, button_right | button_jump, 600);
  EXPECT_TRUE(hint.is_shown()) << "the rope was not caught yet";
  tick(hint, button_grab, 600);
  EXPECT_TRUE(hint.is_shown()) << "the key was pressed in the air";
  tick(hint, button_grab, 1, true);
  tick(hint, 0, 120);
  EXPECT_TRUE(hint.is_shown());
  tick(hint, 0, 120);
  EXPECT_FALSE(hint.is_shown());
  hint.begin("{right} runs");
  EXPECT_TRUE(hint.is_shown()) << "in the next run";
}

TEST(Hint, ToClimbIsDoneOnlyOnARope) {
  Hint hint;
  hint.begin("climb with {up}");
  tick(hint, button_up, 600);
  EXPECT_TRUE(hint.is_shown());
  tick(hint, 0, 600, true);
  EXPECT_TRUE(hint.is_shown()) << "it hangs still";
  tick(hint, button_up, 300, true);
  EXPECT_FALSE(hint.is_shown());
}

TEST(Hint, ThatNamesNoKeyStaysUntilAnyInput) {
  Hint hint;
  hint.begin("Mind the balls");
  tick(hint, 0, 3600);
  EXPECT_TRUE(hint.is_shown());
  tick(hint, button_left, 1);
  tick(hint, 0, 240);
  EXPECT_FALSE(hint.is_shown());
}

}  // namespace
}  // namespace game
