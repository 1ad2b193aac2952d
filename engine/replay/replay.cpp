#include "engine/replay/replay.h"

#include <cassert>

#include "engine/files/ranges.h"

namespace engine {
namespace {

std::string in_words(double number) { return number_in_words(number); }
std::string in_words(const std::string& text) { return in_quotes(text); }
std::string in_words(const Setting& setting) {
  return std::visit([](const auto& value) { return in_words(value); }, setting);
}

[[noreturn]] void refuse_field(const std::string& field, const std::string& recorded, const std::string& current) {
  throw ReplayError("the replay does not fit: " + field + " differs (recorded " + recorded + ", now " + current + ")");
}

std::string setting_or_none(const std::map<std::string, Setting>& settings, const std::string& key) {
  const auto found = settings.find(key);
  return found == settings.end() ? "none" : in_words(found->second);
}

void check_settings(const std::map<std::string, Setting>& recorded, const std::map<std::string, Setting>& current) {
  std::map<std::string, Setting> all = recorded;
  all.insert(current.begin(), current.end());
  for (const auto& [key, value] : all) {
    const auto was = recorded.find(key);
    const auto is = current.find(key);
    if (was != recorded.end() && is != current.end() && was->second == is->second) continue;
    refuse_field("setting " + in_quotes(key), setting_or_none(recorded, key), setting_or_none(current, key));
  }
}

}  // namespace

void check_header(const ReplayHeader& recorded, const ReplayHeader& current) {
  if (recorded.level != current.level) refuse_field("level", in_words(recorded.level), in_words(current.level));
  if (recorded.level_hash != current.level_hash) {
    refuse_field("level hash", ribbon::box2d::to_hex(recorded.level_hash), ribbon::box2d::to_hex(current.level_hash));
  }
  if (recorded.tick_rate != current.tick_rate) {
    refuse_field("tick rate", std::to_string(recorded.tick_rate), std::to_string(current.tick_rate));
  }
  if (recorded.players != current.players) {
    refuse_field("number of players", std::to_string(recorded.players), std::to_string(current.players));
  }
  check_settings(recorded.settings, current.settings);
}

int exit_status(VerifyOutcome outcome) {
  switch (outcome) {
    case VerifyOutcome::verified: return 0;
    case VerifyOutcome::diverged: return 1;
    case VerifyOutcome::cut_short: return 2;
  }
  assert(false && "no such outcome");
  return 1;
}

std::string VerifyResult::message() const {
  switch (outcome) {
    case VerifyOutcome::verified:
      return "verified " + std::to_string(ticks) + " ticks, hash " + ribbon::box2d::to_hex(hash);
    case VerifyOutcome::diverged: return "tick " + std::to_string(ticks + 1) + ": " + difference;
    case VerifyOutcome::cut_short: return "cut short after " + std::to_string(ticks) + " ticks";
  }
  assert(false && "no such outcome");
  return difference;
}

const TickInput& ReplayVerifier::input() const {
  assert(!done());
  return replay_->ticks[next_].input;
}

bool ReplayVerifier::check(const ribbon::box2d::StateHash& computed) {
  assert(!done());
  hash_ = computed.combined();
  difference_ = ribbon::box2d::first_difference(replay_->ticks[next_].state, computed);
  if (difference_) return false;
  ++next_;
  return true;
}

VerifyResult ReplayVerifier::result() const {
  VerifyResult result{.outcome = VerifyOutcome::verified, .ticks = next_, .hash = hash_, .difference = {}};
  if (difference_) {
    result.outcome = VerifyOutcome::diverged;
    result.difference = describe(*difference_);
  } else if (!replay_->complete || next_ < replay_->ticks.size()) {
    result.outcome = VerifyOutcome::cut_short;
  }
  return result;
}

}  // namespace engine
