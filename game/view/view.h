#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/draw/canvas.h"
#include "game/simulation/ghost.h"
#include "game/simulation/meter.h"
#include "game/simulation/simulation.h"
#include "game/view/effects.h"

namespace game {

/// What is shown besides the world itself.
struct ViewOptions {
  bool debug = false;           ///< the cords as in view/debug_view.h, and the step's counts
  bool hud = true;              ///< time, keys, messages
  bool strain_tint = false;     ///< cords coloured by how much they are stretched, and what the colours mean
  bool colour_safe = false;     ///< colours that stay apart for who sees red and green alike
  bool reduced_motion = false;  ///< no shaking, zooming, drifting clouds or bursts
  std::optional<GhostPose> ghost{};
  const std::vector<std::string>* keys = nullptr;  ///< what keys do, if it is to be shown
  std::string headline{}, below{};                 ///< a message in the middle; empty: none
  const char* notice = nullptr;                    ///< what has gone wrong, until the end
  double text_scale = 1.0;                         ///< pixels a desktop unit
  const Meter* meter = nullptr;                    ///< of what the debug view tells of cost and stretch, if it is to
};

/// Draws a run of a level. The camera follows the player within the level.
class View {
 public:
  explicit View(const Simulation& simulation) : simulation_(&simulation), effects_(simulation) {}

  /// Draws the moment `alpha` (0 … 1) of the way from the tick before the last to the last.
  void draw(engine::Canvas& canvas, double alpha, const ViewOptions& options);

 private:
  const Simulation* simulation_;
  Effects effects_;
};

}  // namespace game
