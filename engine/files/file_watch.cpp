#include "engine/files/file_watch.h"

#include <chrono>
#include <filesystem>
#include <system_error>
#include <utility>

namespace engine {

std::optional<FileWatch::Stamp> FileWatch::stamp_of(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code no_time;
  std::error_code no_size;
  const auto time = fs::last_write_time(path, no_time);
  const std::uintmax_t size = fs::file_size(path, no_size);
  if (no_time || no_size) return std::nullopt;
  return Stamp{std::chrono::duration_cast<std::chrono::nanoseconds>(time.time_since_epoch()).count(), size};
}

FileWatch::FileWatch(std::string path, ReadStamp read_stamp)
    : path_(std::move(path)), read_stamp_(std::move(read_stamp)), reported_(read_stamp_(path_)), last_(reported_) {}

bool FileWatch::poll(std::int64_t elapsed_ns) {
  waited_ns_ += elapsed_ns;
  if (waited_ns_ < period_ns) return false;
  waited_ns_ = 0;
  const std::optional<Stamp> now = read_stamp_(path_);
  const bool is_settled = now == last_;
  last_ = now;
  if (!now || !is_settled || now == reported_) return false;
  reported_ = now;
  return true;
}

}  // namespace engine
