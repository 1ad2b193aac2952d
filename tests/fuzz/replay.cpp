// Replay files: a file loads, or is refused with a message that names it. A loaded replay verifies against itself. No
// complete replay stays complete with a flipped bit or a missing end.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include "engine/replay/replay.h"
#include "tests/fuzz/require.h"

namespace {

using fuzz::require;

const std::string file = "fuzz.replay";

std::optional<engine::Replay> read(std::string_view bytes) {
  std::istringstream in{std::string(bytes)};
  try {
    return engine::read_replay(in, file);
  } catch (const engine::ReplayError& error) {
    fuzz::require_message(error.what(), file);
    return std::nullopt;
  }
}

void verify(const engine::Replay& replay) {
  engine::ReplayVerifier verifier(replay);
  for (const engine::RecordedTick& tick : replay.ticks) {
    require(!verifier.done() && verifier.input() == tick.input, "the verifier returns the input of each tick");
    require(verifier.check(tick.state), "the hash of a tick equals the recorded one");
  }
  const engine::VerifyResult result = verifier.result();
  require(verifier.done() && result.ticks == replay.ticks.size(), "all ticks are verified", result.message());
  require((result.outcome == engine::VerifyOutcome::verified) == replay.complete, "a complete replay is verified",
          result.message());
}

/// Verifies against the ticks one later; the verifier must find each difference.
void verify_otherwise(const engine::Replay& replay) {
  engine::ReplayVerifier verifier(replay);
  for (std::size_t k = 1; k < replay.ticks.size() && !verifier.done(); ++k) {
    const bool same = replay.ticks[k].state == replay.ticks[k - 1].state;
    require(verifier.check(replay.ticks[k].state) == same, "a difference is detected", verifier.result().message());
  }
  require(!verifier.result().message().empty(), "the result has a message");
}

void check_headers(const engine::ReplayHeader& header) {
  engine::check_header(header, header);
  try {
    engine::check_header(header, {"first_swing", 1, 60, {{"velocity_iterations", 8.0}, {"cord_method", "direct"}}});
  } catch (const engine::ReplayError& error) {
    fuzz::require_message(error.what(), "the replay does not fit");
  }
}

/// Flips a bit, and cuts the file, at `where` modulo the size.
void damage(std::string_view bytes, const engine::Replay& replay, std::size_t where) {
  std::string damaged(bytes);
  char& byte = damaged[where % damaged.size()];
  byte = static_cast<char>(byte ^ (1 << where % 8));
  const std::optional<engine::Replay> read_on = read(damaged);
  require(!read_on || (!replay.complete && read_on->ticks == replay.ticks), "a flipped bit is detected");

  const std::optional<engine::Replay> cut = read(bytes.substr(0, where % bytes.size()));
  if (!cut) return;
  require(!cut->complete && cut->header == replay.header && cut->ticks.size() <= replay.ticks.size(),
          "a cut replay is a prefix");
  for (std::size_t k = 0; k < cut->ticks.size(); ++k)
    require(cut->ticks[k] == replay.ticks[k], "a cut replay has the same ticks");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::optional<engine::Replay> replay = read(bytes);
  if (!replay) return 0;
  verify(*replay);
  verify_otherwise(*replay);
  check_headers(replay->header);
  damage(bytes, *replay, static_cast<std::size_t>(ribbon::box2d::hash_bytes(bytes)));
  return 0;
}
