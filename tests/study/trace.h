#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/replay/replay.h"
#include "engine/tick/input.h"
#include "game/simulation/level.h"
#include "game/simulation/simulation.h"
#include "ribbon/study/accuracies.h"
#include "tests/study/figures.h"
#include "tests/study/tunnelling.h"
#include "tests/tradeoff/measure.h"

namespace study {

/// What is compared as the same cord in two runs: a cord that is cut has another version from then on, and so have its
/// pieces.
struct CordVersion {
  ribbon::box2d::CordId cord = 0;
  int version = 0;  ///< number of changes of its number of columns

  bool operator==(const CordVersion&) const = default;
  bool operator<(const CordVersion& other) const {
    return cord != other.cord ? cord < other.cord : version < other.version;
  }
};

/// The recorded motion of a run of a level, at places that do not depend on the cords' numbers of points.
struct Trace {
  static constexpr int stations = 33;  ///< evenly spaced places on a cord

  std::vector<double> lengths;                    ///< m, by cord: at rest when it was made; 0: it never existed
  std::vector<std::vector<CordVersion>> cords;    ///< by tick: those that exist, ascending
  std::vector<std::vector<ribbon::Vec2>> places;  ///< m, by tick: of all stations of these cords
  std::vector<ribbon::Vec2> player;               ///< m, by tick
  std::vector<std::vector<ribbon::Vec2>> bodies;  ///< m, by tick: of the second player and the dynamic bodies
  std::vector<double> stretch;                    ///< by tick: maximum over cords, relative to the whole length
  std::vector<Figures> figures;                   ///< by tick
  Crossings declared;                             ///< what its cords must not pass through
  std::vector<Crossings> crossings;               ///< by tick
  double mass = 0.0;                              ///< kg, of cords and dynamic bodies
  double gravity = 0.0;                           ///< m/s², magnitude
  ribbon::IslandReport work;                      ///< of all islands and ticks of the direct solver
  int contacts = 0;                               ///< sum over cords and ticks, after each tick
  int unconverged_ticks = 0;                      ///< ticks with an unconverged cord of the direct solver
  std::vector<std::int64_t> tick_work;            ///< by tick: IslandReport::work of all cords of the direct solver
  std::string failure;                            ///< why it ended early; empty if it did not

  /// Returns whether any cord existed in any tick.
  bool has_cords() const;
};

/// A substitute that moves a level's cords in place of their own solver.
struct Method {
  game::MakeMover make_mover = {};
  std::function<void()> show = {};  ///< sets the cords' positions; to be called before they are read
  std::uint16_t categories = 0;     ///< of the substitute's bodies
};

/// A run that can be restarted, for timing.
class LevelRun {
 public:
  /// Stores references to level and inputs.
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

/// Stores references to level and inputs. The time of `show` is the rest of a tick, not a cost of the method.
tradeoff::Timed timed_run(const game::Level& level, std::span<const engine::TickInput> inputs, Method method = {});

std::vector<engine::TickInput> inputs_of(const engine::Replay& replay);

/// Returns the middles of a cord's columns, m, from the first to the last.
std::vector<ribbon::Vec2> middle_line(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord);

/// A change of the accuracy of all cords of the direct solver in a run.
struct AccuracyChange {
  std::size_t tick = 0;  ///< the first with it
  ribbon::Accuracy accuracy;
};

/// A run of all inputs, or until a position is NaN or beyond a kilometre, that is recorded tick by tick.
class RecordedRun {
 public:
  /// Stores references to level, inputs and method.
  RecordedRun(const game::Level& level, std::span<const engine::TickInput> inputs, const Method& method);
  RecordedRun(const RecordedRun&) = delete;
  RecordedRun& operator=(const RecordedRun&) = delete;
  ~RecordedRun();

  /// Adds to the horizontal velocity [m/s] of all points and dynamic bodies.
  void kick(double speed);
  /// Runs the next tick, if there is one, with an accuracy of all cords of the direct solver; none: the level's own.
  void tick(const ribbon::Accuracy* accuracy);
  bool has_ended() const;
  const Trace& trace() const;
  Trace take_trace();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Returns the record of a whole run.
Trace run(const game::Level& level, std::span<const engine::TickInput> inputs, const Method& method = {},
          const std::optional<AccuracyChange>& change = {});

/// How a part of a run is played.
struct PartSetting {
  std::optional<ribbon::Accuracy> accuracy{};  ///< of all cords of the direct solver; none: the level's own
  double kick = 0.0;  ///< m/s, added at its begin to the horizontal velocity of all points and dynamic bodies
  std::map<ribbon::box2d::CordId, ribbon::Accuracy> by_cord{};  ///< of some cords, in place of `accuracy`
};

/// A run that has come to a tick, and continues once from there.
class StartedRun {
 public:
  /// Runs the ticks before `begin`: with the level's own settings, the last `lead_in` of them with 16 substeps.
  /// (Contacts are compliant, and stiffer with more substeps: without a lead-in, 64 substeps push apart what presses on
  /// the contacts of one.) Stores references to level and inputs.
  StartedRun(const game::Level& level, std::span<const engine::TickInput> inputs, std::size_t begin,
             std::size_t lead_in = 0);

  /// Returns whether a run ends with the last tick of its record.
  using Ends = std::function<bool(const Trace&)>;
  /// Runs up to `ticks` more ticks, or until a position is as in `run`, or until it `ends`; without it not before. A
  /// line has the level's own setting in the tick in which it arrives.
  Trace finish(std::size_t ticks, const PartSetting& setting, const Ends& ends = {});

 private:
  LevelRun run_;
  std::span<const engine::TickInput> inputs_;
  std::size_t begin_;
  ribbon::study::Accuracies accuracies_;
};

/// Runs `ticks` ticks from `begin` on, as a StartedRun does.
struct Part {
  std::size_t begin = 0;
  std::size_t ticks = 0;
  std::size_t lead_in = 0;
  PartSetting setting{};
};
Trace run_part(const game::Level& level, std::span<const engine::TickInput> inputs, const Part& part);

}  // namespace study
