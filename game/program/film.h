#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/draw/canvas.h"
#include "engine/draw/canvas_raster.h"
#include "engine/draw/video_writer.h"

namespace game {

/// A video of what a window shows, from one press of a key to the next.
class Film {
 public:
  /// Begins, or ends, and says so. It goes into a free name in the working folder.
  std::string toggle(const engine::Raster& raster);
  bool is_running() const { return writer_.has_value(); }
  /// A drawn frame, so long after the one before. Says why when the video cannot go on; else nothing.
  std::string take(const engine::Raster& raster, std::int64_t elapsed_ns);
  /// Completes what is running, and says so, or why not; nothing if none is.
  std::string finish();

 private:
  std::string end_with(const std::string& reason);

  std::optional<engine::VideoWriter> writer_;
  std::string name_;
  std::int64_t due_ns_ = 0;  // frames that are still to be written
};

/// A red dot at the top of a picture that is being filmed. Not in the film.
void draw_filming_mark(engine::Canvas& canvas, double text_scale);

/// A free name: ropeswing-1.mp4, -2.mp4, …
std::string free_name(const std::string& ending);

}  // namespace game
