#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/canvas.h"
#include "game/meter.h"
#include "game/simulation.h"

namespace game {

/// What is shown besides the world itself.
struct ViewOptions {
  bool debug = false;  ///< the cords' points and connections, coloured as in Goto 2017, Fig. 4.1, and the step's counts
  bool hud = true;     ///< time, keys, messages
  bool reduced_motion = false;
  bool colour_safe = false;
  bool strain_tint = false;
  std::optional<ribbon::Vec2> ghost{};             ///< m, the player of the best run
  const std::vector<std::string>* keys = nullptr;  ///< what keys do, if it is to be shown
  std::string headline{}, below{};                 ///< a message in the middle; empty: none
  const char* notice = nullptr;                    ///< what has gone wrong, until the end
  double text_scale = 1.0;                         ///< pixels a desktop unit
  const Meter* meter = nullptr;                    ///< of what the debug view tells of cost and stretch, if it is to
};

/// Draws a run of a level. The camera follows the player within the level.
class View {
 public:
  explicit View(const Simulation& simulation) : simulation_(&simulation) {}

  /// Draws the moment `alpha` (0 … 1) of the way from the tick before the last to the last.
  void draw(engine::Canvas& canvas, double alpha, const ViewOptions& options);

 private:
  engine::View camera(const engine::Canvas& canvas, ribbon::Vec2 player) const;

  const Simulation* simulation_;
};

}  // namespace game
