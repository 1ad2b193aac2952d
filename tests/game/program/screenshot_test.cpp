// Screenshots by a key, in the folder of the user.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/game/program/journey.h"
#include "tests/support/environment.h"

namespace game {
namespace {

TEST_F(Journey, AScreenshotGoesToTheUsersFolderWhosePathIsToldOnce) {
  const test_support::Environment pictures("XDG_PICTURES_DIR", nullptr);
  open();
  app->draw();
  const std::string folder = data() + "/ropeswing/pictures";
  tap(Key::f12);
  app->draw();
  EXPECT_EQ(app->session().notice.text(), "Screenshot: " + folder + "/ropeswing-1.png");
  EXPECT_TRUE(std::filesystem::exists(folder + "/ropeswing-1.png"));
  tap(Key::f12);
  app->draw();
  EXPECT_EQ(app->session().notice.text(), "Screenshot: ropeswing-2.png");
  EXPECT_TRUE(std::filesystem::exists(folder + "/ropeswing-2.png"));
}

TEST_F(Journey, AScreenshotThatCannotBeWrittenIsReported) {
  const test_support::Environment pictures("XDG_PICTURES_DIR", "/proc/nowhere");
  open();
  app->draw();
  tap(Key::f12);
  app->draw();
  EXPECT_NE(app->session().notice.text().find("/proc/nowhere"), std::string::npos) << app->session().notice.text();
}

}  // namespace
}  // namespace game
