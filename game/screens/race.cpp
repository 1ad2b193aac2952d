#include "game/screens/race.h"

#include <cstdio>

#include "engine/window/sdl_window.h"
#include "game/screens/level_facts.h"
#include "game/view/hud.h"
#include "game/words/words.h"

namespace game {
namespace {

constexpr std::int64_t budget_ns = 1'500'000;  // per frame
constexpr int shown_ticks = 150;               // of a split

}  // namespace

void Race::check(const Level& level) const {
  if (rival_.empty()) return;
  try {
    Ghost::open(rival_, level);
  } catch (const engine::ReplayError& error) {
    throw engine::ReplayError(words::filled(words::rival_refused, {{"file", rival_}, {"reason", error.what()}}));
  }
}

void Race::begin(const Level& level) {
  level_ = level_key(level);
  timer_ = {};
  message_ticks_ = 0;
  reference_.clear();
  ghost_.reset();
  scout_.reset();
  const bool by_rival = !rival_.empty();
  const std::string path = by_rival ? rival_ : session_->records.replay_path(level_);
  if (session_->settings.ghost || by_rival) ghost_ = Ghost::load(path, level);
  if (by_rival && !ghost_) session_->notice.show(words::rival_of_other_version);
  if (const auto best = session_->records.best(level_); best && !by_rival) reference_ = best->splits;
  const bool is_known = !reference_.empty() || level.checkpoints.empty();
  if (!is_known) scout_ = Ghost::load(path, level);
}

void Race::tick(const Simulation& simulation) {
  if (message_ticks_ > 0) --message_ticks_;
  const auto entered = timer_.update(simulation);
  if (!entered) return;
  const int ticks = *timer_.splits()[*entered];
  message_ = {seconds_in_words(ticks), "", false};
  message_ticks_ = shown_ticks;
  if (*entered >= reference_.size() || !reference_[*entered]) return;
  message_.difference = difference_in_words(ticks, *reference_[*entered]);
  message_.is_ahead = ticks <= *reference_[*entered];
}

void Race::advance(int ticks, int run_tick) {
  const std::int64_t end = engine::now_ns() + budget_ns;
  if (scout_) find_reference(end);
  if (!ghost_) return;
  for (int k = 0; k < ticks || engine::now_ns() < end; ++k) {
    if (!ghost_->advance(run_tick)) return;
  }
}

/// Simulates the compared run while there is time. Its splits are known as far as it has come.
void Race::find_reference(std::int64_t end_ns) {
  while (engine::now_ns() < end_ns) {
    if (scout_->advance_far()) continue;
    reference_ = scout_->splits();
    scout_.reset();
    const auto best = session_->records.best(level_);
    if (!rival_.empty() || !best) return;
    std::string error;
    session_->records.add_splits(level_, best->ticks, reference_, error);
    if (!error.empty()) session_->notice.show(error);
    return;
  }
  reference_ = scout_->splits();
}

std::optional<GhostPose> Race::ghost_at(int run_tick, int player) const {
  const bool is_shown = session_->settings.ghost || !rival_.empty();
  return ghost_ && is_shown ? ghost_->at(run_tick, player) : std::nullopt;
}

}  // namespace game
