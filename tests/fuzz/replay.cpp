// Replay files: a file loads, or is refused with a message that names it. A loaded replay verifies against itself. No
// complete replay stays complete with a flipped bit or a missing end.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include "engine/replay/replay.h"
#include "tests/fuzz/demand.h"

namespace {

using fuzz::demand;

const std::string file = "fuzz.replay";

std::optional<engine::Replay> read(std::string_view bytes) {
  std::istringstream in{std::string(bytes)};
  try {
    return engine::read_replay(in, file);
  } catch (const engine::ReplayError& error) {
    fuzz::demand_sentence(error.what(), file);
    return std::nullopt;
  }
}

void verify(const engine::Replay& replay) {
  engine::ReplayVerifier verifier(replay);
  for (const engine::RecordedTick& tick : replay.ticks) {
    demand(!verifier.done() && verifier.input() == tick.input, "the verifier asks for each tick's input");
    demand(verifier.check(tick.state), "a tick is as recorded");
  }
  const engine::VerifyResult result = verifier.result();
  demand(verifier.done() && result.ticks == replay.ticks.size(), "all ticks are verified", result.message());
  demand((result.outcome == engine::VerifyOutcome::verified) == replay.complete, "complete is verified",
         result.message());
}

/// Verifies against the ticks one later; the verifier must find each difference.
void verify_otherwise(const engine::Replay& replay) {
  engine::ReplayVerifier verifier(replay);
  for (std::size_t k = 1; k < replay.ticks.size() && !verifier.done(); ++k) {
    const bool same = replay.ticks[k].state == replay.ticks[k - 1].state;
    demand(verifier.check(replay.ticks[k].state) == same, "what differs is found", verifier.result().message());
  }
  demand(!verifier.result().message().empty(), "there is a result");
}

void check_headers(const engine::ReplayHeader& header) {
  engine::check_header(header, header);
  try {
    engine::check_header(header, {"first_swing", 1, 60, {{"velocity_iterations", 8.0}, {"cord_method", "direct"}}});
  } catch (const engine::ReplayError& error) {
    fuzz::demand_sentence(error.what(), "the replay does not fit");
  }
}

/// Flips a bit, and cuts the file, at `where` modulo the size.
void damage(std::string_view bytes, const engine::Replay& replay, std::size_t where) {
  std::string damaged(bytes);
  char& byte = damaged[where % damaged.size()];
  byte = static_cast<char>(byte ^ (1 << where % 8));
  const std::optional<engine::Replay> read_on = read(damaged);
  demand(!read_on || (!replay.complete && read_on->ticks == replay.ticks), "a turned bit is noticed");

  const std::optional<engine::Replay> cut = read(bytes.substr(0, where % bytes.size()));
  if (!cut) return;
  demand(!cut->complete && cut->header == replay.header && cut->ticks.size() <= replay.ticks.size(),
         "what is cut short is a beginning");
  for (std::size_t k = 0; k < cut->ticks.size(); ++k) demand(cut->ticks[k] == replay.ticks[k], "of the same ticks");
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
