#include "game/program/film.h"

#include <algorithm>
#include <stdexcept>

#include "game/words/words.h"

namespace game {
namespace {

constexpr std::int64_t frame_ns = 1'000'000'000 / engine::VideoWriter::frames_per_second;
constexpr std::int64_t max_gap_ns = 500'000'000;  // longer gaps between frames are shortened to this

}  // namespace

std::string Film::toggle(const engine::Raster& raster) {
  if (writer_) return finish();
  due_ns_ = frame_ns;  // the first frame is due
  try {
    path_ = files_.next(".mp4");
    writer_.emplace(path_, raster.width(), raster.height());
  } catch (const std::runtime_error& error) {
    return words::filled(words::film_failed, {{"reason", error.what()}});
  }
  return words::filled(words::film_begins, {{"file", files_.to_tell(path_)}});
}

std::string Film::take(const engine::Raster& raster, std::int64_t elapsed_ns) {
  if (!writer_) return {};
  if (raster.width() != writer_->width() || raster.height() != writer_->height()) {
    return end_with(words::film_resized);
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

std::string Film::finish() { return writer_ ? end_with(words::film_ends) : ""; }

std::string Film::end_with(const char* message) {
  try {
    writer_->finish();
    writer_.reset();
    return words::filled(message, {{"file", files_.to_tell(path_)}});
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
