#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/replay/replay.h"
#include "engine/tick/input.h"
#include "game/simulation/level.h"
#include "game/simulation/simulation.h"
#include "tests/study/figures.h"
#include "tests/study/passages.h"
#include "tests/tradeoff/measure.h"

namespace study {

/// What a run of a level came to, at places that do not depend on how many points a cord has.
struct Trace {
  static constexpr int stations = 33;  ///< of a cord, evenly along it

  std::vector<double> lengths;                    ///< m, of the cords at rest
  std::vector<std::vector<ribbon::Vec2>> places;  ///< m, by tick: of all stations of all cords
  std::vector<ribbon::Vec2> player;               ///< m, by tick
  std::vector<double> stretch;                    ///< by tick: the most of a cord's whole length, as a share
  std::vector<Figures> figures;                   ///< by tick
  Passages declared;                              ///< what its cords must not go through
  std::vector<Passages> passages;                 ///< by tick
  double mass = 0.0;                              ///< kg, of cords and dynamic bodies
  double gravity = 0.0;                           ///< m/s², its size
  ribbon::CordReport work;                        ///< of all cords and ticks of the direct solver
  int contacts = 0;                               ///< of all its cords, after each tick, summed up
  int unconverged_ticks = 0;                      ///< in which a cord of it was left unconverged
  std::string failure;                            ///< what became of it, if it ended before its time
};

/// A substitute that moves a level's cords in place of their own solver.
struct Method {
  game::MakeMover make_mover = {};
  std::function<void()> show = {};  ///< lays the cords where they have been moved to; before every look at them
  std::uint16_t categories = 0;     ///< of what moves them
};

/// A run that may be begun again, for the clock.
class LevelRun {
 public:
  /// Keeps references to level and inputs.
  LevelRun(const game::Level& level, std::span<const engine::TickInput> inputs, Method method = {})
      : level_(&level), inputs_(inputs), method_(std::move(method)) {}

  void reset();
  /// After a tick the caller must call `show`.
  void tick();
  void show() const;
  const game::Simulation& simulation() const { return *simulation_; }
  game::Simulation& simulation() { return *simulation_; }

 private:
  const game::Level* level_;
  std::span<const engine::TickInput> inputs_;
  Method method_;
  std::unique_ptr<game::Simulation> simulation_;
  std::size_t next_ = 0;
};

/// Keeps references to level and inputs. What a method takes to show is its rest, and is not its cost.
tradeoff::Timed timed_run(const game::Level& level, std::span<const engine::TickInput> inputs, Method method = {});

std::vector<engine::TickInput> inputs_of(const engine::Replay& replay);

/// m, of a cord's columns, from its first to its last: their middles.
std::vector<ribbon::Vec2> middle_line(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord);

/// Runs all inputs, or until a place is no number or further off than a kilometre.
Trace run(const game::Level& level, std::span<const engine::TickInput> inputs, const Method& method = {});

/// Runs `ticks` of the inputs, or as many as there are, from the tick `begin` on, up to which the level is as it says,
/// with all cords of the direct solver solved so.
Trace run_from(const game::Level& level, std::span<const engine::TickInput> inputs, std::size_t begin,
               std::size_t ticks, const ribbon::Accuracy& accuracy);

/// How far a run is from a reference, each error of its own kind. What one of the runs lacks is no number.
///
/// Energy and momentum are not drifts: the player adds and removes both, so each is compared with that of the reference
/// in the same tick.
struct Errors {
  double position_m = 0.0;       ///< RMS over all stations and ticks
  double position_share = 0.0;   ///< the same of each cord's own length
  double player_m = 0.0;         ///< RMS over all ticks
  double stretch = 0.0;          ///< of the peak, as a share of a cord's length
  double tension = lacking;      ///< of the peak, as a share of the reference's peak
  double penetration = lacking;  ///< the run's own deepest after any tick, as a share of the cord's radius
  double energy = lacking;       ///< the greatest after any tick, as a share of weight of all × longest cord
  double momentum = lacking;     ///< the greatest after any tick, as a share of mass of all × √(g × longest cord)

  /// m, the greatest of those that are lengths.
  double greatest_length() const { return position_m > player_m ? position_m : player_m; }
};

/// How far `run` is from `reference`, a run of the same level, in the first `ticks`, at most as many as both have.
Errors difference(const Trace& run, const Trace& reference, std::size_t ticks);

/// The first tick after which two runs are further apart than `most` metres anywhere, or all there are: beyond that
/// what a run does is chance.
std::size_t ticks_together(const Trace& a, const Trace& b, double most);

}  // namespace study
