#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace game {

/// The key of a level in the records. A level whose file changes has another key.
struct LevelKey {
  std::string name;
  std::uint64_t hash = 0;

  bool operator==(const LevelKey&) const = default;
};

struct Best {
  int ticks = 0;
  bool assisted = false;

  bool operator==(const Best&) const = default;
  /// A run without assists is better than any with assists.
  bool is_better_than(const Best& other) const { return assisted == other.assisted ? ticks < other.ticks : !assisted; }
};

/// The best run of each level: best.json, and a recording best/NAME-HASH.replay for each.
class Records {
 public:
  /// An empty folder: records are lost at the end of the game.
  explicit Records(std::string folder) : folder_(std::move(folder)) {}

  /// Reads the file. If it is invalid, there are no records, the file is renamed, and `notice` reports it.
  void load(std::string& notice);

  std::optional<Best> best(const LevelKey& level) const;
  /// Stores a run and its recording (empty: none) if it is the best so far. Returns whether it is. `notice` reports the
  /// first time that writing fails.
  bool offer(const LevelKey& level, const Best& run, const std::string& recording, std::string& notice);
  /// Returns the path of the recording of the best run, which may not exist. Empty without a folder.
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
