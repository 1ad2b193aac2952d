#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/draw/canvas.h"
#include "game/simulation/ghost.h"
#include "game/simulation/meter.h"
#include "game/simulation/simulation.h"
#include "game/view/effects.h"
#include "game/view/free_space.h"
#include "game/view/stamps.h"

namespace game {

/// The time at a checkpoint that the run has just entered.
struct SplitMessage {
  std::string time;
  std::string difference;  ///< to the compared run, with its sign; empty: not known
  bool is_ahead = false;   ///< of the compared run, or level with it
};

/// The options of a view.
struct ViewOptions {
  bool debug = false;           ///< the debug view of cords (view/debug_view.h) and figures of the last step
  bool hud = true;              ///< time, keys, messages
  bool strain_tint = false;     ///< cords coloured by strain, with a legend
  bool colour_safe = false;     ///< colours for red-green colour blindness
  bool reduced_motion = false;  ///< no shaking, zooming, drifting clouds or particles
  std::optional<GhostPose> ghost{}, second_ghost{};
  const std::vector<std::string>* keys = nullptr;  ///< lines that explain the keys, or null
  std::vector<std::string> signs{};                ///< texts of the level's signs; empty: as in the level
  std::string headline{}, below{};                 ///< a message in the middle; empty: none
  const char* notice = nullptr;                    ///< an error message, or null
  double text_scale = 1.0;                         ///< pixels per desktop unit
  const SplitMessage* split = nullptr;             ///< or null
  const Meter* meter = nullptr;                    ///< statistics for the debug view, or null
  Rectangle free{};                                ///< px, where the player is shown; no size: the whole canvas
  Rectangle panel{};                               ///< px, of a panel that is drawn later; no size: none
};

/// Where the boxes of the HUD were in the last frame, as indices of their possible places.
struct HudPlaces {
  int time = 0, split = 0, keys = 0, message = 0, notice = 0, goal = 0, legend = 0, figures = 0;
};

/// Draws a run of a level. The camera follows the player, or both players, within the level.
class View {
 public:
  explicit View(const Simulation& simulation) : simulation_(&simulation), effects_(simulation) {}

  /// Draws the run, interpolated between the last two ticks with `alpha`, 0 … 1.
  void draw(engine::Canvas& canvas, double alpha, const ViewOptions& options);

 private:
  /// Drops the stamps if they were made for another look. Returns whether they are to be made.
  bool prepare(int height, bool colour_safe, Place place);

  const Simulation* simulation_;
  Effects effects_;
  Stamps stamps_;
  int prepared_height_ = 0;  // px, of the canvas for which the stamps were made
  bool prepared_safe_ = false;
  Place prepared_place_ = Place::hills;
  HudPlaces places_;
};

}  // namespace game
