#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

namespace engine {

/// A video that cannot be written, in a sentence that names the file and the reason.
class VideoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A video file that the program ffmpeg makes of frames, 30 a second: a GIF of 64 colours if its name ends in .gif,
/// else H.264 in a .mp4. (For its palette a GIF is held in memory by ffmpeg until it is finished: half a megabyte a
/// frame of 480 x 270.)
class VideoWriter {
 public:
  static constexpr int frames_per_second = 30;

  /// Starts ffmpeg, which is looked for in PATH. Throws VideoError if it is not there, for another ending, and for
  /// sizes that are not 2 … 16384.
  VideoWriter(const std::string& path, int width, int height);
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;
  /// One that is not finished is given up: ffmpeg ends with what it got.
  ~VideoWriter();

  int width() const { return width_; }
  int height() const { return height_; }

  /// A frame, row by row from the top, 0x00RRGGBB. The caller sees to it that there are width · height pixels. Throws
  /// VideoError, with what ffmpeg said, if it takes no more.
  void write(std::span<const std::uint32_t> pixels);
  /// Completes the file. Throws VideoError if ffmpeg could not.
  void finish();

 private:
  void start(const std::string& path);
  void close_input();
  /// The exit status, −1 of one that a signal ended.
  int wait();
  [[noreturn]] void fail();

  std::string path_;
  int width_;
  int height_;
  int input_ = -1;   // a socket to ffmpeg's standard input
  int errors_ = -1;  // a pipe from its standard error
  int process_ = -1;
};

/// Throws VideoError unless it ends in .gif or .mp4.
void check_video_name(const std::string& path);

}  // namespace engine
