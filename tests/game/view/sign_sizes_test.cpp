// Signs and the masses of weights are set in all sizes in the first frame: a size that a later frame sets takes
// milliseconds.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "engine/window/sdl_canvas.h"
#include "game/simulation/recorded_run.h"
#include "game/view/view.h"
#include "tests/game/program.h"

namespace game {
namespace {

/// Records which texts are measured in which size, as each text is before it is drawn.
class MeasuredTexts : public engine::HeadlessCanvas {
 public:
  using HeadlessCanvas::HeadlessCanvas;

  double text_width(std::string_view utf8, double size) const override {
    texts.emplace(utf8, static_cast<int>(std::lround(size)));
    return HeadlessCanvas::text_width(utf8, size);
  }

  mutable std::set<std::pair<std::string, int>> texts;
};

TEST(SignSizes, AreAllPreparedInTheFirstFrame) {
  for (const char* const level : {"first_steps", "line_and_knife", "heavy_load"}) {
    RunOptions asked;
    asked.replay = std::string(TEST_ASSETS "/replays/") + level + ".replay";
    RecordedRun run(asked);
    View view(run.simulation());
    MeasuredTexts canvas(1920, 1080);
    run.tick({});
    view.draw(canvas, 1.0, {});
    const auto first = std::exchange(canvas.texts, {});
    while (!run.is_over()) {
      run.tick({});
      if (run.simulation().ticks() % 4 == 0) view.draw(canvas, 1.0, {});
    }
    std::set<int> sizes;
    for (const auto& [text, size] : canvas.texts) {
      const auto& signs = run.level().signs;
      const bool is_sign =
          std::any_of(signs.begin(), signs.end(), [&shown = text](const Sign& sign) { return sign.text == shown; });
      if (is_sign) sizes.insert(size);
      if (!is_sign && !text.ends_with(" kg")) continue;  // else the clock, which changes in each frame
      EXPECT_TRUE(first.contains({text, size})) << level << ": " << text << ", " << size;
    }
    EXPECT_GT(sizes.size(), 2U) << level << ": the camera zooms";
  }
}

}  // namespace
}  // namespace game
