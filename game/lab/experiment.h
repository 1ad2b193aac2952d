#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/tick/input.h"
#include "game/lab/bench.h"
#include "game/lab/scene.h"
#include "ribbon/parallel_for.h"

namespace game::lab {

/// Is told when the tick of each bench begins and ends, to measure what it costs. It cannot change a run.
class BenchWatch {
 public:
  BenchWatch() = default;
  BenchWatch(const BenchWatch&) = delete;
  BenchWatch& operator=(const BenchWatch&) = delete;
  virtual ~BenchWatch() = default;
  virtual void begins(std::size_t bench) = 0;
  virtual void ends(std::size_t bench) = 0;
};

/// A scene of the lab that runs: the same inputs and changes at the same ticks give the same bits.
class Experiment {
 public:
  /// The scene must outlive it.
  explicit Experiment(const Scene& scene);

  const Scene& scene() const { return *scene_; }
  const KnobValues& values() const { return values_; }
  /// The bench with cords, and behind it the one with chains, if there is one.
  std::span<const std::unique_ptr<Bench>> benches() const { return benches_; }
  int ticks() const { return ticks_; }
  /// Returns the sum of energies [J] of a bench at the start.
  double first_energy(std::size_t bench) const { return first_energies_[bench]; }

  /// Sets a knob that the scene has to a value within its range: at once, or by a restart if the range says so. The
  /// knob preset sets substeps and tolerance too. Throws ribbon::CallError for a knob that the scene does not have and
  /// ribbon::DefinitionError for a value that is out of its range, and changes nothing.
  void set(Knob knob, double value);
  /// Begins again, with the values that the knobs have.
  void restart();
  /// Runs a tick of 1/60 s of all benches.
  void tick(const engine::TickInput& input = {}, BenchWatch* watch = nullptr);
  /// Ends a drag, as a tick without button_drag would before anything moves.
  void let_go();
  /// Sets how cords are solved in parallel; the bits are the same.
  void use(const ribbon::ParallelFor& parallel_for);

  /// Returns a hash of the states of all benches.
  std::uint64_t hash() const;

 private:
  void build();
  void apply(Knob knob);

  const Scene* scene_;
  KnobValues values_;
  std::vector<std::unique_ptr<Bench>> benches_;
  std::vector<double> first_energies_;  // J
  ribbon::ParallelFor parallel_for_;
  int ticks_ = 0;
};

}  // namespace game::lab
