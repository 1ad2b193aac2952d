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

/// Replays: the level, the settings, the input of each tick and a hash of the state after each tick.
///
/// The file, version 1 (numbers are little-endian, without padding):
///
///     "ropeswing-replay 1\n"
///     one line of JSON, at most 65536 bytes with its line feed:
///       {"level": text, "level_hash": 16 hexadecimal digits, "tick_rate": integer, "settings": {name: text or number},
///        "players": 2, only in a run of two players}
///     u32 checksum
///     for each tick:
///       u8 'T' · u16 n, the number of parts, at most 4096, plus 32768 if the second player has a pointer · u16 ~n
///       u16 buttons · i16 pointer x · i16 pointer y (cm) · in a run of two players: u16 buttons of the second
///       if the second player has a pointer, only in a run of two: i16 its x · i16 its y (cm)
///       n × { u8 subsystem · u16 index · u32 hash }
///       u64 combined hash · u32 checksum
///     if closed cleanly:
///       u8 'E' · u32 number of ticks · u32 checksum, and nothing after it
///
/// Each checksum is the CRC-32 (as in zlib) of all bytes of the file before it except earlier checksums, so the first
/// checksum after a record that is changed, lost, repeated or moved detects it.
///
/// Cut short or damaged: the writer only appends, so if it is killed, the file is the beginning of a good one. Exactly
/// such a file is accepted as cut short: the header is complete, every complete record is valid, and the file ends at
/// the end of a record or within one (whose bytes are dropped). Anything else is damage and an error, for instance a
/// wrong checksum even in the last record, a part count that does not match its complement, or bytes after the end
/// marker. The error has the byte at which the first bad record begins. Cut there (`head -c BYTE`), the file is a
/// replay of the ticks before.
namespace engine {

/// A replay cannot be written, read or used. The message names the file, the byte or tick if there is one, what was
/// found and what is accepted.
class ReplayError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A finite number or a text. Whole numbers above 2^53 must be stored as text.
using Setting = std::variant<double, std::string>;

/// What must be equal for a replay to run as it was recorded.
struct ReplayHeader {
  std::string level;             ///< Name of the level, UTF-8.
  std::uint64_t level_hash = 0;  ///< hash_bytes() of the level file.
  int tick_rate = 60;            ///< Ticks per second, 1 … 1'000'000.
  std::map<std::string, Setting> settings;
  int players = 1;  ///< 1 or 2; buttons and pointer of a second one are recorded only in a run of two.

  bool operator==(const ReplayHeader&) const = default;
};

/// Throws a ReplayError with the first field that differs and both values. Compares level, level hash, tick rate,
/// players, then the settings by name; a setting that only one side has differs.
void check_header(const ReplayHeader& recorded, const ReplayHeader& current);

/// One recorded tick: its input and the hash of the state after it.
struct RecordedTick {
  TickInput input;
  ribbon::box2d::StateHash state;

  bool operator==(const RecordedTick&) const = default;
};

struct Replay {
  ReplayHeader header;
  std::vector<RecordedTick> ticks;
  bool complete = false;  ///< False if the recording was cut short after these ticks.
};

/// Reads a replay from a regular file. Throws a ReplayError if the file is not a replay, has another version or is
/// damaged.
Replay load_replay(const std::string& path);
/// Reads a replay from a stream; messages use `name` as the path.
Replay read_replay(std::istream& in, const std::string& name);

/// Writes a replay while the game runs. Each call passes its tick to the operating system, so the replay of a game that
/// is killed has all ticks.
class ReplayWriter {
 public:
  /// Creates or overwrites the file and writes the header. Throws a ReplayError if the file cannot be written or the
  /// header cannot be recorded (not UTF-8, a number that is not finite, over 64 KiB, tick rate or number of players out
  /// of range).
  ReplayWriter(const std::string& path, const ReplayHeader& header);

  /// Appends one tick of at most 4096 parts. The first write that fails throws a ReplayError and ends the recording;
  /// later calls do nothing, so that a game can report the error once and continue. What was written before stays.
  void write(const TickInput& input, const ribbon::box2d::StateHash& state);

  /// Marks the recording as complete and closes the file; throws like write(). Without it the file counts as cut short.
  void finish();

  /// True after a write has failed.
  bool failed() const { return failed_; }
  /// The number of ticks written so far.
  std::uint32_t tick_count() const { return ticks_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void append_record();
  [[noreturn]] void fail(const std::string& reason);

  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
  std::vector<std::uint8_t> record_;  // scratch, reused in each tick
  std::uint32_t crc_;
  std::uint32_t ticks_ = 0;
  bool has_second_ = false;  // player, whose buttons are recorded
  bool failed_ = false;
};

enum class VerifyOutcome { verified, diverged, cut_short };

/// The exit status of a program that verifies a replay: 0 verified, 1 diverged, 2 cut short.
int exit_status(VerifyOutcome outcome);

struct VerifyResult {
  VerifyOutcome outcome = VerifyOutcome::verified;
  std::size_t ticks = 0;   ///< Number of equal ticks.
  std::uint64_t hash = 0;  ///< Combined hash after the last tick computed; 0 before the first.
  std::string difference;  ///< If diverged: `cord 2 differs (…)`.

  /// A line for the user: `verified 600 ticks, hash 0123456789abcdef`, `tick 120: cord 2 differs (recorded 89abcdef,
  /// now 01234567)` or `cut short after 400 ticks`.
  std::string message() const;
};

/// Compares a run with its recording. Ticks count from 1: tick n is the state after n ticks. The game runs the loop:
///
///     ReplayVerifier verifier(replay);
///     while (!verifier.done()) verifier.check(play_one_tick(verifier.input()));
///     print(verifier.result().message());
class ReplayVerifier {
 public:
  /// `replay` must outlive the verifier.
  explicit ReplayVerifier(const Replay& replay) : replay_(&replay) {}

  /// True after all recorded ticks have been compared or one differed.
  bool done() const { return difference_ || next_ == replay_->ticks.size(); }
  /// The recorded input of the next tick. Precondition: not done().
  const TickInput& input() const;
  /// Compares the state after that tick with the recorded one; returns false if it differs. Precondition: not done().
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
