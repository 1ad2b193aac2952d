#include "tests/extremes/any_scene/play.h"

#include <algorithm>
#include <chrono>
#include <limits>

namespace any_scene {

using ribbon::Vec2;

namespace {

constexpr double no_scale = 1e-12;  // J

/// Energies are compared with what has been in motion so far.
class Balance {
 public:
  explicit Balance(const Scene& scene) : skipped_(is_driven(scene)) {}

  void start(const World& world) {
    weight_ = world.weight();
    take(world, nullptr);
  }

  void take(const World& world, Sample* sample) {
    const World::Energy now = world.energy();
    const Vec2 heights = world.heights();
    heights_ = {std::min(heights_.x, heights.x), std::max(heights_.y, heights.y)};
    kinetic_ = std::max(kinetic_, now.kinetic);
    const double scale = kinetic_ + weight_ * (heights_.y - heights_.x) + no_scale;
    lowest_ = std::min(lowest_, now.total);
    if (sample != nullptr) {
      sample->energy = now.total;
      if (!skipped_) sample->gain = std::max(0.0, now.total - before_) / scale;
      if (!skipped_) sample->rise = (now.total - lowest_) / scale;
    }
    before_ = now.total;
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  bool skipped_;
  double weight_ = 0.0;
  Vec2 heights_{infinity, -infinity};
  double kinetic_ = 0.0;
  double lowest_ = infinity;
  double before_ = 0.0;
};

void look(const World& world, const Oracles& oracles, const Snapshot& before, const Snapshot& after, Sample& sample) {
  sample.work = world.work();
  sample.unconverged = world.unconverged();
  sample.speed = world.fastest();
  sample.gap = world.grip_gap();
  const Lengths worst = lengths(world.coupling());
  sample.stretch = worst.stretch;
  sample.strain = worst.strain;
  sample.penetration = oracles.penetration(after);
  sample.crossings = oracles.crossings(before, after);
}

void run(const Scene& scene, double max_seconds, Outcome& outcome) {
  using Clock = std::chrono::steady_clock;
  const auto begun = Clock::now();
  World world(scene);
  const Oracles oracles(scene);
  Balance balance(scene);
  balance.start(world);
  Snapshot before = world.snapshot();
  int inside_out = inverted(world.coupling());
  for (int k = 0; k < scene.ticks; ++k) {
    Sample sample;
    sample.milliseconds = world.tick(k);
    sample.finite = world.is_finite();
    if (sample.finite) {
      Snapshot after = world.snapshot();
      look(world, oracles, before, after, sample);
      balance.take(world, &sample);
      const int now_inside_out = inverted(world.coupling());
      sample.inverted = std::max(0, now_inside_out - inside_out);
      inside_out = now_inside_out;
      before = std::move(after);
    }
    outcome.ticks.push_back(sample);
    if (!sample.finite) outcome.end = End::broken;
    if (std::chrono::duration<double>(Clock::now() - begun).count() > max_seconds && k + 1 < scene.ticks) {
      outcome.end = End::cut;
    }
    if (outcome.end != End::whole) return;
  }
}

}  // namespace

std::string_view name(End end) {
  constexpr std::string_view names[] = {"whole", "cut", "broken", "refused", "crashed"};
  return names[static_cast<std::size_t>(end)];
}

Outcome play(const Scene& scene, double max_seconds) {
  Outcome outcome;
  try {
    run(scene, max_seconds, outcome);
  } catch (const ribbon::DefinitionError& error) {
    outcome.end = End::refused;
    outcome.message = error.what();
  }
  return outcome;
}

}  // namespace any_scene
