#include "game/simulation/verified_time.h"

#include <exception>
#include <utility>

#include "engine/replay/replay.h"
#include "game/simulation/buttons.h"
#include "game/simulation/level.h"
#include "game/simulation/run_header.h"
#include "game/simulation/simulation.h"

namespace game {
namespace {

constexpr std::size_t ticks_per_report = 30;

/// The best time of the runs of a simulation.
class BestTime {
 public:
  explicit BestTime(VerifiedTime& best) : best_(&best) {}

  void add(const Simulation& simulation, const engine::TickInput& input) {
    if (simulation.run_ticks() <= run_ticks_) dragged_ = reached_ = false;  // restarted
    run_ticks_ = simulation.run_ticks();
    if ((input.buttons & button_drag) != 0) dragged_ = true;
    const auto goal = simulation.goal_ticks();
    if (!goal || std::exchange(reached_, true)) return;
    const bool assisted = dragged_ || simulation.level().assists.any();
    const bool is_better = !best_->ticks || std::pair(assisted, *goal) < std::pair(best_->assisted, *best_->ticks);
    if (!is_better) return;
    best_->ticks = goal;
    best_->assisted = assisted;
    best_->medal = assisted ? Medal::none : medal_for(*goal, simulation.level().medals);
  }

 private:
  VerifiedTime* best_;
  int run_ticks_ = 0;
  bool dragged_ = false;
  bool reached_ = false;
};

void run_again(const engine::Replay& replay, VerifiedTime& time, const std::function<void(double)>& report) {
  Level level = load_level(replay.header.level);
  time.title = level.title;
  time.number = level.number;
  take_settings(level, replay.header);
  engine::check_header(replay.header, replay_header(level));
  Simulation simulation(level);
  engine::ReplayVerifier verifier(replay);
  BestTime best(time);
  for (std::size_t done = 0; !verifier.done(); ++done) {
    const engine::TickInput input = verifier.input();
    simulation.tick(input);
    if (verifier.check(simulation.hash())) best.add(simulation, input);
    if (report && done % ticks_per_report == 0) {
      report(static_cast<double>(done) / static_cast<double>(replay.ticks.size()));
    }
  }
  if (const engine::VerifyResult result = verifier.result(); result.outcome != engine::VerifyOutcome::verified) {
    time.fault = result.message();
  }
}

}  // namespace

VerifiedTime verify_time(const std::string& path, const std::function<void(double share)>& report) {
  VerifiedTime time;
  try {
    const engine::Replay replay = engine::load_replay(path);
    time.level = replay.header.level;
    run_again(replay, time, report);
  } catch (const std::exception& error) {
    time.fault = error.what();
    if (time.fault.starts_with(path + ": ")) time.fault.erase(0, path.size() + 2);
  }
  if (!time.fault.empty()) {
    time.ticks.reset();
    time.medal = Medal::none;
  }
  return time;
}

}  // namespace game
