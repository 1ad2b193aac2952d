#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <iosfwd>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "engine/tick/input.h"
#include "ribbon/box2d/state_hash.h"

/// Replays: the level and settings played, every tick's input, and a hash of the state after every tick.
///
/// The file, version 1 (numbers are little-endian, without padding):
///
///     "ropeswing-replay 1\n"
///     one line of JSON, at most 65536 bytes with its line feed:
///       {"level": text, "level_hash": 16 hexadecimal digits, "tick_rate": integer, "settings": {name: text or number}}
///     u32 checksum
///     for each tick:
///       u8 'T' · u16 n, the number of parts, at most 4096 · u16 ~n
///       u16 buttons · i16 pointer x · i16 pointer y (cm)
///       n × { u8 subsystem · u16 index · u32 hash }
///       u64 combined hash · u32 checksum
///     if closed cleanly:
///       u8 'E' · u32 number of ticks · u32 checksum, and nothing after it
///
/// Every checksum is the CRC-32 (as in zlib) of all bytes of the file before it except earlier checksums, so a record
/// that is changed, lost, repeated or moved is noticed at the first checksum after it.
///
/// Cut short or damaged: the writer only ever appends, so whatever kills it leaves a beginning of a good file. Exactly
/// that is accepted as cut short: the header is whole, every whole record is right, and the file ends at a record's end
/// or within one (whose bytes are dropped). Anything else, such as a wrong checksum even in the very last record, a
/// part count that disagrees with its complement, or bytes after the end marker, is damage and refused: with the byte
/// at which the first bad record begins. Cut there (`head -c BYTE`), the file is a replay of the ticks before.
namespace engine {

/// A replay that cannot be written, read or used here. The sentence names the file, and the byte or tick in it where
/// there is one, what was found and what is accepted.
class ReplayError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A finite number or a text. (A whole number that must survive beyond 2^53 goes as text.)
using Setting = std::variant<double, std::string>;

/// What must be the same for a replay to play as it was recorded.
struct ReplayHeader {
  std::string level;             ///< The level's name, in UTF-8.
  std::uint64_t level_hash = 0;  ///< hash_bytes() of the level file.
  int tick_rate = 60;            ///< Ticks a second, 1 to 1'000'000.
  std::map<std::string, Setting> settings;

  bool operator==(const ReplayHeader&) const = default;
};

/// Throws a ReplayError naming the first field in which the two differ, with both values: level, level hash, tick rate,
/// then the settings by name (one that only one side has differs too).
void check_header(const ReplayHeader& recorded, const ReplayHeader& current);

/// One tick as recorded: the input it ran with and the hash of the state after it.
struct RecordedTick {
  TickInput input;
  ribbon::box2d::StateHash state;

  bool operator==(const RecordedTick&) const = default;
};

struct Replay {
  ReplayHeader header;
  std::vector<RecordedTick> ticks;
  bool complete = false;  ///< False: the recording was cut short after these ticks.
};

/// Reads a replay from a regular file. Throws a ReplayError if it is none, of another version, or damaged.
Replay load_replay(const std::string& path);
/// The same from a stream; `name` stands for the path in messages.
Replay read_replay(std::istream& in, const std::string& name);

/// Writes a replay while the game runs. After each call the tick is with the operating system: a game that is killed
/// leaves a replay up to its last tick.
class ReplayWriter {
 public:
  /// Creates or empties the file and writes the header. Throws a ReplayError if the file cannot be written, or if the
  /// header cannot be recorded (not UTF-8, a number that is not finite, over 64 KiB, tick rate out of range).
  ReplayWriter(const std::string& path, const ReplayHeader& header);

  /// Appends one tick; at most 4096 parts. The first write that fails throws a ReplayError, and the recording is over:
  /// later calls do nothing, so that a game may tell its player once and play on. What was written before stays.
  void write(const TickInput& input, const ribbon::box2d::StateHash& state);

  /// Marks the recording complete and closes the file; throws like write(). Without it the file reads as cut short.
  void finish();

  /// True once a write has failed.
  bool failed() const { return failed_; }
  /// Ticks written so far.
  std::uint32_t tick_count() const { return ticks_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void append_record();
  [[noreturn]] void fail(const std::string& reason);

  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
  std::vector<std::uint8_t> record_;  // reused from tick to tick
  std::uint32_t crc_;
  std::uint32_t ticks_ = 0;
  bool failed_ = false;
};

enum class VerifyOutcome { verified, diverged, cut_short };

/// What a program that verifies a replay ends with: 0 verified, 1 diverged, 2 cut short.
int exit_status(VerifyOutcome outcome);

struct VerifyResult {
  VerifyOutcome outcome = VerifyOutcome::verified;
  std::size_t ticks = 0;   ///< Ticks compared and found equal.
  std::uint64_t hash = 0;  ///< Combined hash after the last tick computed; 0 before the first.
  std::string difference;  ///< If diverged: `cord 2 differs (…)`.

  /// The line to end with: `verified 600 ticks, hash 0123456789abcdef`, `tick 120: cord 2 differs (recorded 89abcdef,
  /// now 01234567)` or `cut short after 400 ticks`.
  std::string message() const;
};

/// Holds a run against its recording. Ticks count from 1: tick n is the state after n ticks. The loop is the game's:
///
///     ReplayVerifier verifier(replay);
///     while (!verifier.done()) verifier.check(play_one_tick(verifier.input()));
///     print(verifier.result().message());
class ReplayVerifier {
 public:
  /// `replay` must outlive the verifier.
  explicit ReplayVerifier(const Replay& replay) : replay_(&replay) {}

  /// True when all recorded ticks have been compared, or one differed.
  bool done() const { return difference_ || next_ == replay_->ticks.size(); }
  /// The recorded input of the tick to run next. Only while not done().
  const TickInput& input() const;
  /// Compares the state after running that tick with the recorded one; false if it differs. Only while not done().
  bool check(const ribbon::box2d::StateHash& computed);
  /// The result so far; before done() a run without a difference counts as cut short.
  VerifyResult result() const;

 private:
  const Replay* replay_;
  std::size_t next_ = 0;
  std::uint64_t hash_ = 0;
  std::optional<ribbon::box2d::Divergence> difference_;
};

}  // namespace engine
