#pragma once

#include <array>
#include <optional>
#include <vector>

#include "engine/sound/instruments.h"
#include "engine/sound/score.h"

namespace engine {

/// Renders a score to a loop in small steps, so that a game can do it between frames. The same score gives the same
/// samples on every machine.
class ScoreRenderer {
 public:
  static constexpr int rate = 22050;    ///< samples per second
  static constexpr double peak = 0.75;  ///< of the loop

  explicit ScoreRenderer(Score score);

  /// Renders one more note, or a part of the echo. Returns false if the loop is complete. Costs about 0.2 ms.
  bool step();
  /// Completes the loop and returns it. The renderer must not be used afterwards.
  Sound finish();

 private:
  /// A delay line with feedback: a comb or an allpass filter of Schroeder's reverberator.
  struct Delay {
    std::vector<double> line;
    double feedback = 0.0;
    std::size_t at = 0;
    double damped = 0.0;

    double comb(double in);
    double allpass(double in);
  };

  double echo(double in);
  void step_echo();

  Score score_;
  Cycle dry_;
  std::vector<float> loop_;
  std::size_t next_note_ = 0;
  std::size_t echoed_ = 0;  // samples, of those before the start too
  std::array<Delay, 4> combs_;
  std::array<Delay, 2> allpasses_;
  float most_ = 0.0F;
};

/// Renders a score at once.
Sound render(Score score);

}  // namespace engine
