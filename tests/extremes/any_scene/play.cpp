#include "tests/extremes/any_scene/play.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>
#include <utility>

#include "tests/extremes/any_scene/figures.h"

namespace any_scene {

using ribbon::Vec2;

namespace {

constexpr double moved_of_hanging = 0.05;  // share of the points: what is driven moves nevertheless
constexpr int recovery_ticks = 60;         // after all that drives has ended

void look(const World& world, const Oracles& oracles, const Snapshot& before, const Snapshot& after, Sample& sample) {
  sample.work = work(world.coupling());
  sample.unconverged = unconverged(world.coupling());
  sample.hangs = sample.unconverged > 0 && world.moved_share() < moved_of_hanging;
  sample.left = world.coupling().last_step().report().position_error;
  sample.speed = world.fastest();
  sample.gaps = world.grip_gaps();
  const Lengths worst = lengths(world);
  sample.stretch = worst.stretch;
  sample.strain = worst.strain;
  sample.penetration = oracles.penetration(after);
  sample.crossings = oracles.crossings(before, after);
}

void run(const Scene& scene, double max_seconds, Outcome& outcome) {
  using Clock = std::chrono::steady_clock;
  const auto begun = Clock::now();
  World world(scene);
  Scene present = scene;
  std::optional<Oracles> oracles(std::in_place, present);
  EnergyBalance balance(world.energy(), world.weight(), world.heights());
  bool driven = is_driven(scene);
  Snapshot before = world.snapshot();
  int inside_out = inverted(world.coupling());
  const int ticks = scene.ticks + scene.calm_ticks;
  for (int k = 0; k < ticks; ++k) {
    Sample sample;
    sample.late = k >= scene.ticks + recovery_ticks;
    if (k == scene.ticks) world.calm_down();
    if (k == scene.ticks + recovery_ticks) {
      driven = false;
      balance = EnergyBalance(world.energy(), world.weight(), world.heights());
    }
    const auto look_at_pieces = [&] {
      present = world.present_scene();
      oracles.emplace(present);
      inside_out = inverted(world.coupling());
    };
    const Inertia uncut = scene.cuts.empty() ? Inertia{} : inertia(world.coupling());
    if (k < scene.ticks && world.drive(k)) {
      look_at_pieces();
      if (!scene.cuts.empty()) sample.imbalance = difference(uncut, inertia(world.coupling()), world.fastest());
      before = world.snapshot();
      sample.gain = balance.take(world.energy(), world.heights()).in_tick;  // by the cut
    }
    const bool draws_together = world.draws_together();
    sample.milliseconds = world.tick();
    sample.finite = world.is_finite();
    if (sample.finite) {
      if (world.has_broken()) {
        look_at_pieces();
        before = world.snapshot();  // crossings of the tick are not looked for
        if (world.has_lost_a_cord()) balance.leave_out(world.energy());
      }
      Snapshot after = world.snapshot();
      look(world, *oracles, before, after, sample);
      sample.energy = world.energy().total;
      const EnergyBalance::Gain gain = balance.take(world.energy(), world.heights());
      sample.gain = driven || draws_together ? 0.0 : std::max(sample.gain, gain.in_tick);
      if (!driven) sample.rise = gain.since_lowest;
      const int now_inside_out = inverted(world.coupling());
      sample.inverted = std::max(0, now_inside_out - inside_out);
      inside_out = now_inside_out;
      before = std::move(after);
    }
    outcome.ticks.push_back(sample);
    if (!sample.finite) outcome.end = End::broken;
    if (std::chrono::duration<double>(Clock::now() - begun).count() > max_seconds && k + 1 < ticks) {
      outcome.end = End::timed_out;
    }
    if (outcome.end != End::completed) return;
  }
}

}  // namespace

std::string_view name(End end) {
  constexpr std::string_view names[] = {"completed", "timed_out", "broken", "refused", "crashed"};
  return names[static_cast<std::size_t>(end)];
}

Outcome play(const Scene& scene, double max_seconds) {
  Outcome outcome;
  try {
    run(scene, max_seconds, outcome);
  } catch (const ribbon::DefinitionError& error) {
    outcome = {{}, End::refused, error.what()};
  } catch (const ribbon::CallError& error) {  // what holds a cord on a wheel, or a pulley of a stiff one
    outcome = {{}, End::refused, error.what()};
  }
  return outcome;
}

}  // namespace any_scene
