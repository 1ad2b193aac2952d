#include "game/program/film.h"

#include <algorithm>
#include <filesystem>

namespace game {
namespace {

constexpr std::int64_t frame_ns = 1'000'000'000 / engine::VideoWriter::frames_per_second;
constexpr std::int64_t max_gap_ns = 500'000'000;  // longer gaps between frames are shortened to this

}  // namespace

std::string free_name(const std::string& ending) {
  for (int number = 1;; ++number) {
    std::string name = "ropeswing-" + std::to_string(number) + ending;
    if (!std::filesystem::exists(name)) return name;
  }
}

std::string Film::toggle(const engine::Raster& raster) {
  if (writer_) return finish();
  name_ = free_name(".mp4");
  due_ns_ = frame_ns;  // the first frame is due
  try {
    writer_.emplace(name_, raster.width(), raster.height());
  } catch (const engine::VideoError& error) {
    return error.what();
  }
  return "Recording a video to " + name_;
}

std::string Film::take(const engine::Raster& raster, std::int64_t elapsed_ns) {
  if (!writer_) return {};
  if (raster.width() != writer_->width() || raster.height() != writer_->height()) {
    return end_with("The window has another size now; ");
  }
  due_ns_ += std::min(elapsed_ns, max_gap_ns);
  try {
    for (; due_ns_ >= frame_ns; due_ns_ -= frame_ns) writer_->write(raster.pixels());
  } catch (const engine::VideoError& error) {
    writer_.reset();
    return error.what();
  }
  return {};
}

std::string Film::finish() { return writer_ ? end_with("") : ""; }

std::string Film::end_with(const std::string& reason) {
  try {
    writer_->finish();
    writer_.reset();
    return reason + (reason.empty() ? "Video: " : "video: ") + name_;
  } catch (const engine::VideoError& error) {
    writer_.reset();
    return error.what();
  }
}

void draw_filming_mark(engine::Canvas& canvas, double text_scale) {
  const double size = 18.0 * text_scale;
  canvas.panel({0.5 * (canvas.width() - size), 12.0 * text_scale}, {size, size}, 0.5 * size, {225, 40, 40});
}

}  // namespace game
