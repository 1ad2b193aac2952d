#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace game {

/// A level as records know it: one whose file changes is another one.
struct LevelKey {
  std::string name;
  std::uint64_t hash = 0;

  bool operator==(const LevelKey&) const = default;
};

struct Best {
  int ticks = 0;
  bool assisted = false;

  bool operator==(const Best&) const = default;
  /// A run without assists counts more than one with them.
  bool is_better_than(const Best& other) const { return assisted == other.assisted ? ticks < other.ticks : !assisted; }
};

/// The best runs, by level: best.json, and best/NAME-HASH.replay for each.
class Records {
 public:
  /// An empty folder: they last until the game ends.
  explicit Records(std::string folder) : folder_(std::move(folder)) {}

  /// Reads the file. If it cannot be used there are no records, it is kept aside, and `notice` says so.
  void load(std::string& notice);

  std::optional<Best> best(const LevelKey& level) const;
  /// Takes a run if it is the best one so far, with its recording (empty: there is none). True if it is. If that
  /// cannot be written `notice` says so the first time.
  bool offer(const LevelKey& level, const Best& run, const std::string& recording, std::string& notice);
  /// Where the recording of the best run is; it may not be there. Empty without a folder.
  std::string replay_path(const LevelKey& level) const;

 private:
  struct Entry {
    LevelKey level;
    Best best;
  };

  std::string file() const { return folder_ + "/best.json"; }
  std::string text() const;
  static std::vector<Entry> parse(const std::string& text, const std::string& where);
  void write(const LevelKey& level, const std::string& recording, std::string& notice);

  std::string folder_;
  std::vector<Entry> entries_;
  bool failed_ = false;
};

}  // namespace game
