#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

namespace engine {

/// A video cannot be written. The message has the file and the reason.
class VideoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Writes a video file of 30 frames per second with the program ffmpeg: a GIF of 64 colours if the name ends in .gif,
/// or H.264 if it ends in .mp4. ffmpeg holds all frames of a GIF in memory to compute its palette: 0.5 MB per frame of
/// 480 × 270.
class VideoWriter {
 public:
  static constexpr int frames_per_second = 30;

  /// Starts ffmpeg from PATH. Throws VideoError if it is not found, for other endings of the name, and for sizes
  /// outside 2 … 16384 px.
  VideoWriter(const std::string& path, int width, int height);
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;
  /// Without finish(), ffmpeg ends with the frames so far, and its errors are ignored.
  ~VideoWriter();

  int width() const { return width_; }
  int height() const { return height_; }

  /// Writes a frame of width · height pixels, row by row from the top, 0x00RRGGBB. Throws VideoError, with the output
  /// of ffmpeg, if ffmpeg has ended.
  void write(std::span<const std::uint32_t> pixels);
  /// Completes the file. Throws VideoError if ffmpeg could not.
  void finish();

 private:
  void start(const std::string& path);
  void close_input();
  /// Waits for ffmpeg and returns its exit status, or −1 if a signal ended it.
  int wait();
  [[noreturn]] void fail();

  std::string path_;
  int width_;
  int height_;
  int input_ = -1;   // a socket to ffmpeg's standard input
  int errors_ = -1;  // a pipe from its standard error
  int process_ = -1;
};

/// Throws VideoError unless the path ends in .gif or .mp4.
void check_video_name(const std::string& path);

}  // namespace engine
