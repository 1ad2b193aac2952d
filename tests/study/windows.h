#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ribbon/cord_def.h"
#include "tests/study/errors.h"

namespace study {

/// RMS errors, m; NaN if not compared.
struct WindowErrors {
  double position_m = unavailable;  ///< over all stations
  double player_m = unavailable;
  double body_m = unavailable;  ///< over the second player and the dynamic bodies
  std::string failure{};        ///< why it does not count: it blew up in a window; empty if it counts
  bool spends_budget = false;   ///< in some tick the budget of work (Accuracy::max_work) did not suffice

  /// 0 if nothing is compared.
  double greatest() const;
};

/// The errors of a setting in windows of a quarter of a second along a run (multiple shooting). Each starts from the
/// state that the level's own cords reach, after a lead-in with 16 substeps (see StartedRun). In so short a time the
/// motion often is not yet chaotic, so that motion after the first catch is compared too.
class Windows {
 public:
  static constexpr std::size_t ticks = 15;    ///< length of a window
  static constexpr std::size_t lead_in = 15;  ///< ticks before it

  /// Runs the references of up to `most` windows, evenly spaced along a run: `fine` and `finer` are accuracies of
  /// converged motions. Stores references to level and inputs.
  Windows(const game::Level& level, std::span<const engine::TickInput> inputs, const ribbon::Accuracy& fine,
          const ribbon::Accuracy& finer, std::size_t most);

  using CordAccuracies = std::map<ribbon::box2d::CordId, ribbon::Accuracy>;
  /// Returns the errors with a setting (none: the level's own), or another one for some cords, relative to the finer
  /// reference, in all compared ticks.
  WindowErrors errors(const std::optional<ribbon::Accuracy>& accuracy, const CordAccuracies& by_cord = {}) const;
  /// Returns the differences of the references in these ticks. Errors below ten times that are unknown.
  WindowErrors agreement() const { return agreement_; }
  /// Return the share of the windows' ticks in which cords and players are compared: while the references differ by at
  /// most 0.1 mm, RMS, and probes (see probe_kick of engine/study/conditions.h) by at most max_probe_difference.
  double compared_cords() const { return share(&Window::cords); }
  double compared_players() const { return share(&Window::player); }
  std::size_t count() const { return windows_.size(); }

 private:
  struct Window {
    std::size_t begin;                  // tick
    std::size_t size;                   // its number of ticks
    std::unique_ptr<StartedRun> start;  // at its begin; copies of it continue
    Trace reference{};                  // from there on
    std::size_t cords = 0;              // number of ticks in which cords are compared
    std::size_t player = 0;             // number of ticks in which players are compared
    std::size_t bodies = 0;             // number of ticks in which bodies are compared
    std::size_t longest() const { return std::max({cords, player, bodies}); }
    Trace run(std::size_t count, const PartSetting& setting, const StartedRun::Ends& ends = {}) const;
    /// Compares no more than the ticks in which two runs differ by at most `most` [m].
    void limit(const Trace& a, const Trace& b, double most);
  };
  /// Sets the reference and what is compared, and returns the other reference.
  static Trace set_reference(Window& window, const ribbon::Accuracy& fine, const ribbon::Accuracy& finer);
  double share(std::size_t Window::*compared) const;
  template <typename Run>
  WindowErrors pooled(Run&& run_in) const;

  std::vector<Window> windows_;
  WindowErrors agreement_;
};

/// Return the number of ticks in which two runs differ by at most `most` [m]: their cords, RMS over all stations of
/// those that exist in both, their players, and their bodies.
std::size_t agreeing_cord_ticks(const Trace& a, const Trace& b, double most);
std::size_t agreeing_player_ticks(const Trace& a, const Trace& b, double most);
std::size_t agreeing_body_ticks(const Trace& a, const Trace& b, double most);

}  // namespace study
