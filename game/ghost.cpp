#include "game/ghost.h"

#include <array>
#include <utility>

namespace game {

using ribbon::Vec2;

Ghost::Ghost(engine::Replay replay, Level level)
    : replay_(std::move(replay)),
      level_(std::move(level)),
      simulation_(level_),
      track_{simulation_.player().position()} {}

std::unique_ptr<Ghost> Ghost::load(const std::string& path, const Level& level) {
  if (path.empty()) return nullptr;
  try {
    engine::Replay replay = engine::load_replay(path);
    Level same = level;
    Simulation::take_assists(same, replay.header);
    engine::check_header(replay.header, Simulation::replay_header(same));
    return std::unique_ptr<Ghost>(new Ghost(std::move(replay), std::move(same)));
  } catch (const engine::ReplayError&) {  // it is only a ghost
    return nullptr;
  }
}

bool Ghost::advance(int run_tick) {
  const std::size_t done = track_.size() - 1;
  if (done >= replay_.ticks.size() || static_cast<int>(done) >= run_tick + ahead) return false;
  const engine::RecordedTick& recorded = replay_.ticks[done];
  simulation_.tick(recorded.input);
  if (simulation_.hash().combined() != recorded.state.combined()) {
    replay_.ticks.resize(done);
    return false;
  }
  track_.push_back(simulation_.player().position());
  return true;
}

std::optional<Vec2> Ghost::at(int run_tick) const {
  if (run_tick < 0 || static_cast<std::size_t>(run_tick) >= track_.size()) return std::nullopt;
  return track_[static_cast<std::size_t>(run_tick)];
}

void draw_ghost(engine::Canvas& canvas, Vec2 at) {
  constexpr engine::Color pale{255, 255, 255, 110};
  canvas.polyline(std::array{at + Vec2{0.0, -0.6}, at + Vec2{0.0, 0.15}}, 0.42, pale);
  canvas.circle(at + Vec2{0.0, 0.52}, 0.27, pale);
}

}  // namespace game
