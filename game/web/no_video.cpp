#include "engine/draw/video_writer.h"

/// In place of video_writer.cpp, for a browser starts no program.
namespace engine {

void check_video_name(const std::string& path) {
  throw VideoError("cannot write the video " + path + ": a browser does not run ffmpeg, which makes videos");
}

VideoWriter::VideoWriter(const std::string& path, int width, int height) : path_(path), width_(width), height_(height) {
  check_video_name(path);
}

VideoWriter::~VideoWriter() = default;
void VideoWriter::write(std::span<const std::uint32_t>) { fail(); }
void VideoWriter::finish() { fail(); }
void VideoWriter::fail() { throw VideoError("cannot write the video " + path_ + ": it was not begun"); }

}  // namespace engine
