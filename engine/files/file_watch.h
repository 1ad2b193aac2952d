#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace engine {

/// Tells when a file has changed, by its time and size, looked at twice a second.
class FileWatch {
 public:
  struct Stamp {
    std::int64_t changed_ns = 0;  ///< by whatever clock the file system has
    std::uintmax_t size = 0;      ///< bytes
    bool operator==(const Stamp&) const = default;
  };
  /// What the file is like; nothing if there is none.
  using Look = std::function<std::optional<Stamp>(const std::string& path)>;
  static std::optional<Stamp> stamp_of(const std::string& path);

  static constexpr std::int64_t period_ns = 500'000'000;

  /// A change is one from what the file is like now.
  explicit FileWatch(std::string path, Look look = stamp_of);

  /// After so much more time. True once for each change, when the file has stayed the same from one look to the next:
  /// one that is being written, or is away for a moment, is waited for.
  bool pass(std::int64_t elapsed_ns);

  const std::string& path() const { return path_; }

 private:
  std::string path_;
  Look look_;
  std::optional<Stamp> known_;
  std::optional<Stamp> last_;  // seen
  std::int64_t waited_ns_ = 0;
};

}  // namespace engine
