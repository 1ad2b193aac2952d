#include "engine/draw/video_writer.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <system_error>
#include <utility>
#include <vector>

extern "C" char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to its users

namespace engine {
namespace {

std::string reason_of(int error) { return std::generic_category().message(error); }

bool is_gif(const std::string& path) { return path.ends_with(".gif"); }

std::vector<std::string> arguments_for(const std::string& path, int width, int height) {
  const std::string rate = std::to_string(VideoWriter::frames_per_second);
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  std::vector<std::string> all = {"ffmpeg", "-hide_banner", "-loglevel", "error", "-y",
                                  "-f",     "rawvideo",     "-pix_fmt",  "bgr0",  "-s",
                                  size,     "-framerate",   rate,        "-i",    "pipe:0"};
  const std::vector<std::string> gif = {"-filter_complex",
                                        "split[a][b];[a]palettegen=max_colors=64[p];[b][p]paletteuse=dither=bayer"};
  const std::vector<std::string> mp4 = {"-vf",       "crop=trunc(iw/2)*2:trunc(ih/2)*2",
                                        "-c:v",      "libx264",
                                        "-preset",   "veryfast",
                                        "-crf",      "20",
                                        "-pix_fmt",  "yuv420p",
                                        "-movflags", "+faststart"};
  const std::vector<std::string>& form = is_gif(path) ? gif : mp4;
  all.insert(all.end(), form.begin(), form.end());
  all.push_back("file:" + path);  // also for names that look like an option or a protocol
  return all;
}

void close_one(int& file) {
  if (file >= 0) close(std::exchange(file, -1));
}

/// Owns the file actions of posix_spawn.
struct FileActions {
  posix_spawn_file_actions_t actions{};
  FileActions() { posix_spawn_file_actions_init(&actions); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  ~FileActions() { posix_spawn_file_actions_destroy(&actions); }
};

/// Reads until the other end is closed.
std::string read_all(int file) {
  std::string text;
  std::array<char, 4096> block{};
  while (true) {
    const ssize_t got = read(file, block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return text;
    text.append(block.data(), static_cast<std::size_t>(got));
  }
}

std::string last_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

}  // namespace

void check_video_name(const std::string& path) {
  if (is_gif(path) || path.ends_with(".mp4")) return;
  throw VideoError("cannot write the video " + path + ": accepted are names that end in .gif or .mp4");
}

VideoWriter::VideoWriter(const std::string& path, int width, int height) : path_(path), width_(width), height_(height) {
  check_video_name(path);
  if (width < 2 || height < 2 || width > 16384 || height > 16384) {
    throw VideoError("cannot write the video " + path + " of " + std::to_string(width) + " x " +
                     std::to_string(height) + " pixels; accepted are 2 to 16384 each way");
  }
  start(path);
}

VideoWriter::~VideoWriter() {
  close_input();
  if (process_ >= 0) wait();
  close_one(errors_);
}

/// Starts ffmpeg. The frames go through a socket, not a pipe: with MSG_NOSIGNAL, writing after ffmpeg has ended is an
/// error without a signal.
void VideoWriter::start(const std::string& path) {
  std::array<int, 2> frames{-1, -1};
  std::array<int, 2> errors{-1, -1};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, frames.data()) != 0 || pipe2(errors.data(), O_CLOEXEC) != 0) {
    const int reason = errno;
    for (int& file : frames) close_one(file);
    throw VideoError("cannot write the video " + path + ": " + reason_of(reason));
  }
  FileActions files;
  posix_spawn_file_actions_adddup2(&files.actions, frames[1], STDIN_FILENO);
  posix_spawn_file_actions_addopen(&files.actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&files.actions, errors[1], STDERR_FILENO);
  std::vector<std::string> arguments = arguments_for(path, width_, height_);
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  pid_t process = -1;
  const int failed = posix_spawnp(&process, "ffmpeg", &files.actions, nullptr, pointers.data(), environ);
  close_one(frames[1]);
  close_one(errors[1]);
  input_ = frames[0];
  errors_ = errors[0];
  if (failed == 0) {
    process_ = process;
    return;
  }
  close_one(input_);
  close_one(errors_);
  const bool missing = failed == ENOENT;
  throw VideoError("cannot write the video " + path + ": " +
                   (missing ? "the program ffmpeg is not installed" : "ffmpeg does not start: " + reason_of(failed)));
}

void VideoWriter::close_input() { close_one(input_); }

int VideoWriter::wait() {
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void VideoWriter::fail() {
  close_input();
  const std::string output = last_line(read_all(errors_));
  const int status = process_ >= 0 ? wait() : 0;
  throw VideoError("cannot write the video " + path_ + ": ffmpeg ended with status " + std::to_string(status) +
                   (output.empty() ? "" : ": " + output));
}

void VideoWriter::write(std::span<const std::uint32_t> pixels) {
  const char* bytes = reinterpret_cast<const char*>(pixels.data());
  std::size_t left = pixels.size_bytes();
  while (left > 0) {
    const ssize_t sent = send(input_, bytes, left, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) fail();
    bytes += sent;
    left -= static_cast<std::size_t>(sent);
  }
}

void VideoWriter::finish() {
  close_input();
  const std::string output = last_line(read_all(errors_));
  const int status = wait();
  if (status == 0) return;
  throw VideoError("cannot write the video " + path_ + ": ffmpeg ended with status " + std::to_string(status) +
                   (output.empty() ? "" : ": " + output));
}

}  // namespace engine
