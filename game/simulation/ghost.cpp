#include "game/simulation/ghost.h"
#include "game/simulation/run_header.h"

#include <utility>

#include "ribbon/box2d/convert.h"

namespace game {
namespace {

GhostPose pose_of(const Player& player, const ribbon::box2d::Coupling& coupling) {
  GhostPose pose{player.position(), ribbon::box2d::to_double(player.body().GetLinearVelocity()), player.faces_left(),
                 player.is_on_ground()};
  if (const auto held = player.held_place(coupling)) {
    pose.held = coupling.cord(held->cord).position(held->point, held->along);
  }
  return pose;
}

}  // namespace

Ghost::Ghost(engine::Replay replay, Level level)
    : replay_(std::move(replay)), level_(std::move(level)), simulation_(level_), track_{poses()} {}

std::unique_ptr<Ghost> Ghost::open(const std::string& path, const Level& level) {
  engine::Replay replay = engine::load_replay(path);
  Level same = level;
  take_settings(same, replay.header);
  engine::check_header(replay.header, replay_header(same));
  return std::unique_ptr<Ghost>(new Ghost(std::move(replay), std::move(same)));
}

std::unique_ptr<Ghost> Ghost::load(const std::string& path, const Level& level) {
  if (path.empty()) return nullptr;
  try {
    return open(path, level);
  } catch (const engine::ReplayError&) {  // a run without a ghost is not an error
    return nullptr;
  }
}

bool Ghost::advance(int run_tick) { return static_cast<int>(track_.size()) - 1 < run_tick + max_lead && advance_far(); }

bool Ghost::advance_far() {
  const std::size_t done = track_.size() - 1;
  if (done >= replay_.ticks.size()) return false;
  const engine::RecordedTick& recorded = replay_.ticks[done];
  simulation_.tick(recorded.input);
  if (simulation_.hash().combined() != recorded.state.combined()) {
    replay_.ticks.resize(done);
    return false;
  }
  splits_.update(simulation_);
  track_.push_back(poses());
  return true;
}

Ghost::Poses Ghost::poses() const {
  Poses poses;
  for (int k = 0; k < simulation_.players(); ++k) {
    poses[static_cast<std::size_t>(k)] = pose_of(simulation_.player(k), simulation_.scene().coupling());
  }
  return poses;
}

std::optional<GhostPose> Ghost::at(int run_tick, int player) const {
  if (run_tick < 0 || static_cast<std::size_t>(run_tick) >= track_.size() || player >= level_.players())
    return std::nullopt;
  return track_[static_cast<std::size_t>(run_tick)][static_cast<std::size_t>(player)];
}

}  // namespace game
