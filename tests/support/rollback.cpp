#include "tests/support/rollback.h"

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "game/simulation/run_header.h"
#include "ribbon/box2d/state_hash.h"

namespace test_support {
namespace {

double largest_distance(const std::vector<ribbon::Vec2>& a, const std::vector<ribbon::Vec2>& b) {
  double largest = 0.0;
  for (std::size_t p = 0; p < std::min(a.size(), b.size()); ++p) largest = std::max(largest, length(a[p] - b[p]));
  return largest;
}

}  // namespace

Rollback::Rollback(const std::string& name)
    : replay_(engine::load_replay(game::assets_folder() + "/replays/" + name + ".replay")),
      level_(game::load_level(replay_.header.level)) {
  game::take_settings(level_, replay_.header);
}

/// The last tick updates hash and positions.
void Rollback::run(int to) {
  for (; tick_ < to; ++tick_) {
    const engine::TickInput& input = replay_.ticks[static_cast<std::size_t>(tick_)].input;
    tick_ + 1 < to ? simulation_->skip(input) : simulation_->tick(input);
    simulation_->save(saved(tick_ + 1));
  }
}

void Rollback::seek(int tick) {
  simulation_.emplace(level_);
  simulation_->scene().world().SetAllowSleeping(allows_sleep_);
  tick_ = 0;
  simulation_->save(saved(0));
  run(tick);
}

int Rollback::points() const {
  const ribbon::box2d::Coupling& coupling = simulation_->scene().coupling();
  int sum = 0;
  for (const int cord : coupling.cords()) sum += static_cast<int>(coupling.cord(cord).positions().size());
  return sum;
}

bool Rollback::back_and_forward() {
  const int now = tick_;
  const int then = now - ticks;
  if (!simulation_->restore(saved(then), then > 0 ? &saved(then - 1) : nullptr)) return false;
  tick_ = then;
  run(now);
  return true;
}

std::optional<Rollback::Difference> Rollback::go_back(int tick) {
  seek(tick);
  const ribbon::box2d::StateHash hash = simulation_->hash();
  const game::Snapshot before = simulation_->current();
  const auto start = std::chrono::steady_clock::now();
  if (!back_and_forward()) return std::nullopt;
  Difference difference;
  difference.us = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
  const game::Snapshot& after = simulation_->current();
  for (std::size_t c = 0; c < before.cords.size(); ++c) {
    difference.cord = std::max(difference.cord, largest_distance(before.cords[c], after.cords.at(c)));
  }
  for (std::size_t b = 0; b < before.bodies.size(); ++b) {
    difference.body = std::max(difference.body, length(before.bodies[b].position - after.bodies[b].position));
  }
  const auto differs = first_difference(hash, simulation_->hash());
  difference.same_bits = !differs;
  if (differs) difference.first = describe(*differs);
  return difference;
}

std::vector<std::string> recorded_runs() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(game::assets_folder() + "/replays")) {
    if (entry.path().extension() == ".replay") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace test_support
