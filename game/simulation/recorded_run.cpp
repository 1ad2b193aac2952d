#include "game/simulation/recorded_run.h"
#include "game/simulation/run_header.h"

#include <utility>

namespace game {
namespace {

std::optional<engine::Replay> replay_for(const RunOptions& options) {
  if (options.replay.empty()) return std::nullopt;
  return engine::load_replay(options.replay);
}

/// Loads the level of the replay, or the one given by name, which must be the same.
Level level_for(const RunOptions& options, const std::optional<engine::Replay>& replay) {
  const std::string from_replay = replay ? replay->header.level : default_level;
  Level level;
  try {
    level = load_level(options.level.value_or(from_replay));
  } catch (const engine::MapError& error) {
    if (!replay || options.level) throw;
    throw engine::MapError(std::string(error.what()) + "; the replay is of that level: give its map with --level");
  }
  level.assists = options.assists;
  if (replay) take_settings(level, replay->header);
  if (replay) engine::check_header(replay->header, replay_header(level));
  return level;
}

}  // namespace

RecordedRun::RecordedRun(const RunOptions& options)
    : record_path_(options.record),
      replay_(replay_for(options)),
      level_(level_for(options, replay_)),
      simulation_(level_) {
  if (replay_ && options.verify) verifier_.emplace(*replay_);
}

void RecordedRun::start_recording() {
  if (!record_path_.empty()) writer_.emplace(record_path_, replay_header(level_));
}

void RecordedRun::begin(const std::string& record_path) {
  writer_.reset();
  make_simulation();
  inputs_.clear();
  can_be_repeated_ = true;
  is_tuned_ = level_is_tuned_;
  record_path_ = record_path;
  start_recording();
}

bool RecordedRun::is_over() const {
  if (verifier_) return verifier_->done();
  return replay_ && next_ == replay_->ticks.size();
}

void RecordedRun::tick(const engine::TickInput& input) {
  const engine::TickInput used = replay_ ? replay_->ticks[next_++].input : input;
  if (!replay_) inputs_.push_back(used);
  simulation_->tick(used);
  if (verifier_) verifier_->check(simulation_->hash());
  if (writer_) writer_->write(used, simulation_->hash());
}

Simulation& RecordedRun::tune() {
  is_tuned_ = true;
  can_be_repeated_ = false;
  end_recording();
  simulation_->keep_changes();
  return *simulation_;
}

void RecordedRun::set_level(Level level, bool tuned) {
  level_is_tuned_ = tuned;
  can_be_repeated_ = false;
  end_recording();
  level_ = std::move(level);
}

void RecordedRun::watch(ribbon::box2d::StepWatcher* watcher) {
  watcher_ = watcher;
  simulation_->watch(watcher);
}

void RecordedRun::use(const ribbon::ParallelFor& parallel_for) {
  parallel_for_ = parallel_for;
  simulation_->use(parallel_for);
}

void RecordedRun::make_simulation() {
  simulation_.emplace(level_);
  simulation_->watch(watcher_);
  simulation_->use(parallel_for_);
}

void RecordedRun::end_recording() {
  if (!writer_) return;
  engine::ReplayWriter ended = std::move(*writer_);
  writer_.reset();
  ended.finish();
}

void RecordedRun::seek(int tick) {
  if (!replay_) throw engine::ReplayError("there is no replay to seek in; accepted is a run with one");
  if (verifier_ || !record_path_.empty()) {
    throw engine::ReplayError(
        "a run that is verified or recorded goes tick by tick; accepted is one that is only played");
  }
  const auto last = static_cast<int>(replay_->ticks.size());
  if (tick < 0 || tick > last) {
    throw engine::ReplayError("tick " + std::to_string(tick) + " is not in the replay; accepted is 0 to " +
                              std::to_string(last));
  }
  const auto wanted = static_cast<std::size_t>(tick);
  if (wanted < next_) {
    make_simulation();
    next_ = 0;
  }
  while (next_ + 2 < wanted) simulation_->skip(replay_->ticks[next_++].input);
  while (next_ < wanted) simulation_->tick(replay_->ticks[next_++].input);
}

std::vector<engine::TickInput> RecordedRun::inputs() const {
  if (!replay_) return inputs_;
  std::vector<engine::TickInput> inputs;
  for (std::size_t k = 0; k < next_; ++k) inputs.push_back(replay_->ticks[k].input);
  return inputs;
}

void RecordedRun::finish() {
  if (writer_) writer_->finish();
}

std::string RecordedRun::closing_line() const {
  if (verifier_) return verifier_->result().message();
  if (replay_ && !replay_->complete && is_over()) {
    return "the recording was cut short after " + std::to_string(next_) + " ticks";
  }
  return "hash " + ribbon::box2d::to_hex(simulation_->hash().combined());
}

int RecordedRun::exit_status() const { return verifier_ ? engine::exit_status(verifier_->result().outcome) : 0; }

}  // namespace game
