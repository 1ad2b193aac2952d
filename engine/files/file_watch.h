#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace engine {

/// Detects changes of a file by its modification time and size, which it polls twice a second.
class FileWatch {
 public:
  struct Stamp {
    std::int64_t changed_ns = 0;  ///< ns, of the file system's clock
    std::uintmax_t size = 0;      ///< bytes
    bool operator==(const Stamp&) const = default;
  };
  /// Returns the stamp of a file, or nothing if it does not exist.
  using ReadStamp = std::function<std::optional<Stamp>(const std::string& path)>;
  static std::optional<Stamp> stamp_of(const std::string& path);

  static constexpr std::int64_t period_ns = 500'000'000;

  /// Changes count from the present state of the file.
  explicit FileWatch(std::string path, ReadStamp read_stamp = stamp_of);

  /// Advances by `elapsed_ns`. Returns true once per change, as soon as two polls in a row find the same stamp: a file
  /// that is being written or does not exist for a moment is not reported yet.
  bool poll(std::int64_t elapsed_ns);

  const std::string& path() const { return path_; }

 private:
  std::string path_;
  ReadStamp read_stamp_;
  std::optional<Stamp> reported_;
  std::optional<Stamp> last_;  // of the last poll
  std::int64_t waited_ns_ = 0;
};

}  // namespace engine
