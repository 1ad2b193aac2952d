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
  /// The ticks when the run first entered each checkpoint of the level; nothing for one that it did not enter. Empty:
  /// not known, or a level without checkpoints.
  std::vector<std::optional<int>> splits{};

  bool operator==(const Best&) const = default;
  /// A run without assists is better than any with assists.
  bool is_better_than(const Best& other) const { return assisted == other.assisted ? ticks < other.ticks : !assisted; }
};

/// The best run of each level: best.json (version 2; version 1 has no splits), and a recording best/NAME-HASH.replay
/// for each.
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
  /// Adds the splits to a best run that has none, if it is still that of `ticks`. `notice` as in offer().
  void add_splits(const LevelKey& level, int ticks, std::vector<std::optional<int>> splits, std::string& notice);
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
  template <typename Write>
  void try_to_write(Write write, std::string& notice);

  std::string folder_;
  std::vector<Entry> entries_;
  bool failed_ = false;
};

}  // namespace game
