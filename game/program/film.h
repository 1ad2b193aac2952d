#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "engine/draw/canvas.h"
#include "engine/draw/canvas_raster.h"
#include "engine/draw/video_writer.h"
#include "game/program/saved_files.h"

namespace game {

/// Records a video of the window. The functions return a message for the player, or an empty text.
class Film {
 public:
  /// `folder`: for the videos; empty: there is none.
  explicit Film(std::string folder) : files_(std::move(folder)) {}

  /// Starts or stops. The file has a free name in the folder.
  std::string toggle(const engine::Raster& raster);
  bool is_running() const { return writer_.has_value(); }
  /// Adds a frame `elapsed_ns` after the last one. Ends the video if that fails.
  std::string take(const engine::Raster& raster, std::int64_t elapsed_ns);
  /// Completes the video, if one is running.
  std::string finish();

 private:
  std::string end_with(const char* message);

  std::optional<engine::VideoWriter> writer_;
  SavedFiles files_;
  std::string path_;
  std::int64_t due_ns_ = 0;  // time of frames that are still to be written
};

/// Draws a red dot at the top of the window while a video is recorded.
void draw_filming_mark(engine::Canvas& canvas, double text_scale);

}  // namespace game
