#include <cassert>
#include <cerrno>
#include <concepts>
#include <limits>
#include <system_error>

#include "engine/replay/replay.h"
#include "engine/replay/replay_format.h"
#include "engine/replay/replay_header.h"

namespace engine {
namespace {

using namespace replay_format;

template <std::unsigned_integral T>
void put(std::vector<std::uint8_t>& out, T value) {
  const std::uint64_t bits = value;
  for (std::size_t i = 0; i < sizeof(T); ++i) out.push_back(static_cast<std::uint8_t>(bits >> (8 * i) & 0xFFU));
}

void put_text(std::vector<std::uint8_t>& out, const std::string& text) {
  out.insert(out.end(), text.begin(), text.end());
}

std::string system_reason() { return errno == 0 ? "reason unknown" : std::generic_category().message(errno); }

/// Returns the part of the message that reports what the file still contains.
std::string ticks_in_file(std::uint32_t ticks) {
  return ticks == 0 ? "" : "; the file keeps the " + std::to_string(ticks) + " ticks before";
}

}  // namespace

ReplayWriter::ReplayWriter(const std::string& path, const ReplayHeader& header)
    : path_(path), crc_(0), has_second_(header.players == max_players) {
  // Errors in the header are found before the file is overwritten.
  std::string line;
  try {
    line = replay_header_line(header);
  } catch (const ReplayError& error) {
    fail(error.what());
  }
  errno = 0;
  file_.reset(std::fopen(path.c_str(), "wb"));
  if (!file_) fail(system_reason());
  put_text(record_, std::string(magic) + std::to_string(version) + "\n" + line);
  append_record();
}

void ReplayWriter::write(const TickInput& input, const ribbon::box2d::StateHash& state) {
  if (failed_) return;
  assert(file_ && "a finished replay takes no more ticks");
  if (state.parts().size() > max_parts) {
    fail("tick " + std::to_string(ticks_ + 1) + " has " + std::to_string(state.parts().size()) +
         " parts, accepted is up to " + std::to_string(max_parts));
  }
  if (ticks_ == std::numeric_limits<std::uint32_t>::max()) fail("the replay is full");

  const bool has_pointer = has_second_ && input.second_has_pointer;
  const auto count = static_cast<std::uint16_t>(state.parts().size() | (has_pointer ? second_pointer_flag : 0U));
  record_.clear();
  put(record_, tick_tag);
  put(record_, count);
  put(record_, static_cast<std::uint16_t>(~count));
  put(record_, input.buttons);
  put(record_, static_cast<std::uint16_t>(input.pointer_x_cm));
  put(record_, static_cast<std::uint16_t>(input.pointer_y_cm));
  if (has_second_) put(record_, input.second_buttons);
  if (has_pointer) {
    put(record_, static_cast<std::uint16_t>(input.second_pointer_x_cm));
    put(record_, static_cast<std::uint16_t>(input.second_pointer_y_cm));
  }
  for (const ribbon::box2d::StatePart& part : state.parts()) {
    put(record_, static_cast<std::uint8_t>(part.subsystem));
    put(record_, part.index);
    put(record_, part.hash);
  }
  put(record_, state.combined());
  append_record();
  ++ticks_;
}

void ReplayWriter::finish() {
  if (failed_ || !file_) return;
  record_.clear();
  put(record_, end_tag);
  put(record_, ticks_);
  append_record();
  errno = 0;
  if (std::fclose(file_.release()) != 0) fail(system_reason());
}

void ReplayWriter::append_record() {
  crc_ = crc32(crc_, record_);
  put(record_, crc_);
  errno = 0;
  const std::size_t written = std::fwrite(record_.data(), 1, record_.size(), file_.get());
  if (written != record_.size() || std::fflush(file_.get()) != 0) fail(system_reason());
}

void ReplayWriter::fail(const std::string& reason) {
  failed_ = true;
  file_.reset();
  throw ReplayError(path_ + ": cannot write the replay: " + reason + ticks_in_file(ticks_));
}

}  // namespace engine
