#include "game/screens/played_run.h"

#include <cstdio>
#include <utility>

#include "game/words/words.h"

namespace game {

PlayedRun::PlayedRun(Session& session, const RunOptions& options, bool direct)
    : session_(&session), options_(options), direct_(direct), run_(options) {}

bool PlayedRun::is_over() const {
  return run_.is_over() || (options_.ticks && run_.simulation().ticks() >= *options_.ticks);
}

void PlayedRun::notice_tuning() {
  if (!run_.is_tuned()) return;
  assisted_ = true;
  recording_.clear();  // it ended when the tuning began
}

void PlayedRun::begin() {
  finish();
  recording_ = session_->runs.next_path(run_.level().name);
  if (run_.level_is_tuned()) {
    recording_.clear();
  } else if (recording_.empty()) {
    session_->report_no_recordings();
  }
  try {
    run_.begin(recording_);
  } catch (const engine::ReplayError& error) {
    std::fprintf(stderr, "ropeswing: %s\n", error.what());
    session_->report_no_recordings();
    recording_.clear();
  }
  assisted_ = run_.is_tuned();
}

void PlayedRun::tick(const engine::TickInput& input) {
  try {
    run_.tick(input);
  } catch (const engine::ReplayError& error) {  // thrown once; the run continues without a recording
    report_failure(error);
  }
}

void PlayedRun::set_level(Level level, bool tuned) {
  try {
    run_.set_level(std::move(level), tuned);
  } catch (const engine::ReplayError& error) {
    report_failure(error);
  }
}

void PlayedRun::finish() {
  try {
    run_.finish();
  } catch (const engine::ReplayError& error) {
    report_failure(error);
  }
}

void PlayedRun::begin_building() {
  if (!records_runs()) session_->notice.show(words::recording_ended_by_building);
  options_.record.clear();
  build(with_start_at(run_.level().yard, run_.simulation()));
}

void PlayedRun::build(const Yard& yard) {
  Level level = run_.level();
  set_yard(level, yard);
  set_level(std::move(level), run_.level_is_tuned());
  run_.begin("");
}

void PlayedRun::report_failure(const engine::ReplayError& error) {
  std::fprintf(stderr, "ropeswing: %s\n", error.what());
  recording_.clear();  // it is incomplete
  if (records_runs()) return session_->report_no_recordings();
  recording_failed_ = true;
}

}  // namespace game
