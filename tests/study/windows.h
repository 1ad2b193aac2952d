#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ribbon/cord_def.h"
#include "tests/study/trace.h"

namespace study {

/// m, RMS. What is not compared is no number.
struct WindowErrors {
  double position_m = lacking;  ///< over all stations
  double player_m = lacking;

  /// 0 if nothing is compared.
  double greatest() const;
};

/// What a setting gets wrong in a quarter of a second, begun again and again from where the level's own cords are, all
/// along a run (multiple shooting). So short a time often ends before chance has its say, and so what comes after the
/// first catch is looked at too.
class Windows {
 public:
  static constexpr std::size_t ticks = 15;  ///< of a window

  /// Runs the references of up to `most` windows, evenly spaced along a run: `fine` and `finer` are accuracies of
  /// converged motions. Keeps references to level and inputs.
  Windows(const game::Level& level, std::span<const engine::TickInput> inputs, const ribbon::Accuracy& fine,
          const ribbon::Accuracy& finer, std::size_t most);

  /// Of cords solved so, against the finer reference, in all ticks that are compared.
  WindowErrors errors(const ribbon::Accuracy& accuracy) const;
  /// How far the references are apart in them; below ten times that an error is not known.
  WindowErrors agreement() const { return agreement_; }
  /// Of all windows' ticks, the share in which cords are compared, and players: as long as the references are a tenth
  /// of a millimetre apart at most, RMS.
  double compared_cords() const { return share(&Window::cords); }
  double compared_players() const { return share(&Window::player); }
  std::size_t count() const { return windows_.size(); }

 private:
  struct Window {
    std::size_t begin;       // tick
    Trace reference;         // from there on
    std::size_t cords = 0;   // number of ticks in which cords are compared
    std::size_t player = 0;  // number of ticks in which players are compared
  };
  double share(std::size_t Window::*compared) const;
  template <typename Run>
  WindowErrors pooled(Run&& run) const;

  const game::Level* level_;
  std::span<const engine::TickInput> inputs_;
  std::vector<Window> windows_;
  WindowErrors agreement_;
};

/// In how many ticks, from the first on, two runs are no further apart than `most` [m]: their cords, RMS over all
/// stations; and their players.
std::size_t cords_together(const Trace& a, const Trace& b, double most);
std::size_t players_together(const Trace& a, const Trace& b, double most);

}  // namespace study
