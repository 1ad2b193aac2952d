#include <concepts>
#include <fstream>
#include <istream>
#include <span>
#include <string_view>
#include <utility>

#include "engine/files/ranges.h"
#include "engine/files/regular_file.h"
#include "engine/replay/replay.h"
#include "engine/replay/replay_format.h"
#include "engine/replay/replay_header.h"

namespace engine {
namespace {

using namespace replay_format;

/// Removes a little-endian number from the front of `bytes` and returns it.
template <std::unsigned_integral T>
T take(std::span<const std::uint8_t>& bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) value |= std::uint64_t{bytes[i]} << (8 * i);
  bytes = bytes.subspan(sizeof(T));
  return static_cast<T>(value);
}

RecordedTick parse_tick(std::span<const std::uint8_t> body, std::size_t part_count, int players,
                        bool has_second_pointer) {
  TickInput input;
  input.buttons = take<std::uint16_t>(body);
  input.pointer_x_cm = static_cast<std::int16_t>(take<std::uint16_t>(body));
  input.pointer_y_cm = static_cast<std::int16_t>(take<std::uint16_t>(body));
  if (players == max_players) input.second_buttons = take<std::uint16_t>(body);
  input.second_has_pointer = has_second_pointer;
  if (has_second_pointer) {
    input.second_pointer_x_cm = static_cast<std::int16_t>(take<std::uint16_t>(body));
    input.second_pointer_y_cm = static_cast<std::int16_t>(take<std::uint16_t>(body));
  }
  std::vector<ribbon::box2d::StatePart> parts(part_count);
  for (ribbon::box2d::StatePart& part : parts) {
    const auto subsystem = take<std::uint8_t>(body);
    if (subsystem >= ribbon::box2d::subsystem_count) {
      throw ReplayError("subsystem is " + std::to_string(subsystem) + ", accepted is 0 to " +
                        std::to_string(ribbon::box2d::subsystem_count - 1));
    }
    part.subsystem = static_cast<ribbon::box2d::Subsystem>(subsystem);
    part.index = take<std::uint16_t>(body);
    part.hash = take<std::uint32_t>(body);
  }
  return {input, ribbon::box2d::StateHash(std::move(parts), take<std::uint64_t>(body))};
}

/// Reads a stream with one record in memory at a time. A size in the file never causes an allocation before its bytes
/// are read.
class RecordingReader {
 public:
  RecordingReader(std::istream& in, const std::string& name) : in_(in), name_(name) {}

  Replay read() {
    read_version();
    read_header();
    while (read_record()) {
    }
    return std::move(replay_);
  }

 private:
  [[noreturn]] void fail(std::uint64_t offset, const std::string& sentence) const {
    throw ReplayError(name_ + ": byte " + std::to_string(offset) + ": " + sentence);
  }
  /// All records before the current one have valid checksums: they are a replay that is cut short there.
  [[noreturn]] void fail_record(const std::string& sentence) const {
    if (record_start_ == 0) fail(0, "damaged in the header: " + sentence);
    fail(record_start_, "damaged after tick " + std::to_string(replay_.ticks.size()) + ": " + sentence +
                            "; the bytes before are a good replay, cut short");
  }

  bool append(std::size_t count);
  bool append_line(std::size_t max_bytes);
  std::span<const std::uint8_t> checked_content();
  void read_version();
  void read_header();
  bool read_record();
  bool read_tick();
  bool read_end();

  std::istream& in_;
  const std::string& name_;
  Replay replay_;
  std::vector<std::uint8_t> record_;  // the bytes of the current record read so far
  std::uint64_t offset_ = 0;          // of the next byte in the file
  std::uint64_t record_start_ = 0;
  std::uint32_t crc_ = 0;  // of all records before the current one
};

/// Reads `count` more bytes of the record. Returns false if the file ends before.
bool RecordingReader::append(std::size_t count) {
  const std::size_t had = record_.size();
  record_.resize(had + count);
  in_.read(reinterpret_cast<char*>(record_.data() + had), static_cast<std::streamsize>(count));
  if (in_.bad()) fail(offset_, "reading failed after tick " + std::to_string(replay_.ticks.size()));
  const auto got = static_cast<std::size_t>(in_.gcount());
  record_.resize(had + got);
  offset_ += got;
  return got == count;
}

/// Reads up to and including a line feed. Returns false if there is none within `max_bytes` or the file.
bool RecordingReader::append_line(std::size_t max_bytes) {
  for (std::size_t i = 0; i < max_bytes && append(1); ++i) {
    if (record_.back() == '\n') return true;
  }
  return false;
}

/// Checks the checksum of the record and returns the bytes before it.
std::span<const std::uint8_t> RecordingReader::checked_content() {
  const std::span<const std::uint8_t> record(record_);
  const auto content = record.first(record.size() - checksum_bytes);
  std::span<const std::uint8_t> rest = record.last(checksum_bytes);
  const auto recorded = take<std::uint32_t>(rest);
  crc_ = crc32(crc_, content);
  if (recorded != crc_) {
    fail_record("the checksum is " + ribbon::box2d::to_hex(recorded) + ", that of the bytes is " +
                ribbon::box2d::to_hex(crc_));
  }
  return content;
}

void RecordingReader::read_version() {
  constexpr std::size_t max_first_line = 64;
  const std::string expected = std::string(magic) + std::to_string(version);
  const bool whole = append_line(max_first_line);
  std::string line(record_.begin(), record_.end());
  if (line.empty()) fail(0, "the file is empty, accepted is a replay, which begins with " + in_quotes(expected));
  if (whole) line.pop_back();
  if (!whole && expected.starts_with(line)) fail(offset_, "the file ends within its first line");
  if (!line.starts_with(magic)) {
    fail(0, "not a replay: it begins with " + in_quotes(line) + ", accepted is " + in_quotes(expected));
  }
  if (line != expected) {
    fail(magic.size(), "the version is " + in_quotes(line.substr(magic.size())) + ", accepted is \"" +
                           std::to_string(version) + "\"");
  }
}

void RecordingReader::read_header() {
  const std::uint64_t start = offset_;
  const std::size_t first_line = record_.size();
  if (!append_line(max_header_bytes)) {
    if (record_.size() - first_line < max_header_bytes) fail(offset_, "the file ends within the header");
    fail(start, "the header has no end within the " + std::to_string(max_header_bytes) + " bytes accepted");
  }
  if (!append(checksum_bytes)) fail(offset_, "the file ends within the header's checksum");
  const auto content = checked_content();
  const std::string line(content.begin() + static_cast<std::ptrdiff_t>(first_line), content.end() - 1);
  try {
    replay_.header = parse_replay_header(line);
  } catch (const ReplayError& error) {
    fail(start, error.what());
  }
}

/// Reads one record. Returns false at the end of the replay, complete or cut short.
bool RecordingReader::read_record() {
  record_.clear();
  record_start_ = offset_;
  if (!append(1)) return false;
  if (record_[0] == tick_tag) return read_tick();
  if (record_[0] == end_tag) return read_end();
  fail_record("a record begins with " + in_quotes({reinterpret_cast<const char*>(record_.data()), 1}) +
              ", accepted is \"T\" or \"E\"");
}

bool RecordingReader::read_tick() {
  if (!append(tick_head_bytes - 1)) return false;
  auto head = std::span<const std::uint8_t>(record_).subspan(1);
  const auto flagged = take<std::uint16_t>(head);
  // The count determines the length of the record. Without the complement, a damaged count could look like a record
  // that is cut short.
  const auto complement = take<std::uint16_t>(head);
  if (complement != static_cast<std::uint16_t>(~flagged)) fail_record("the part count and its complement disagree");
  const int players = replay_.header.players;
  const bool has_pointer = players == max_players && (flagged & second_pointer_flag) != 0;
  const std::size_t count = has_pointer ? flagged - second_pointer_flag : flagged;
  if (count > max_parts) {
    fail_record("the part count is " + std::to_string(count) + ", accepted is up to " + std::to_string(max_parts));
  }
  if (!append(tick_body_bytes(count, players, has_pointer))) return false;
  const auto body = checked_content().subspan(tick_head_bytes);
  try {
    replay_.ticks.push_back(parse_tick(body, count, players, has_pointer));
  } catch (const ReplayError& error) {
    fail_record(error.what());
  }
  return true;
}

bool RecordingReader::read_end() {
  if (!append(end_bytes - 1)) return false;
  auto content = checked_content().subspan(1);
  const auto count = take<std::uint32_t>(content);
  if (count != replay_.ticks.size()) {
    fail_record("the end marker counts " + std::to_string(count) + " ticks, the file has " +
                std::to_string(replay_.ticks.size()));
  }
  record_start_ = offset_;
  if (append(1)) fail_record("bytes follow the end marker, accepted is nothing after it");
  replay_.complete = true;
  return false;
}

}  // namespace

Replay read_replay(std::istream& in, const std::string& name) { return RecordingReader(in, name).read(); }

Replay load_replay(const std::string& path) {
  std::ifstream in;
  try {
    in = open_regular_file(path);
  } catch (const std::runtime_error& error) {
    throw ReplayError(error.what());
  }
  return read_replay(in, path);
}

}  // namespace engine
