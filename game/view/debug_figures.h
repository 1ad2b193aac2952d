#pragma once

#include <string>
#include <vector>

#include "engine/draw/canvas.h"
#include "game/simulation/meter.h"
#include "game/simulation/simulation.h"

namespace game {

/// The figures of the last step of all cords, in one table per solver, with a legend. It fits into the width and height
/// that it is given: the letters become smaller, and the last cords are left out.
class DebugFigures {
 public:
  /// `meter`: may be null. `text_scale`: as in ViewOptions. `max_size`: px.
  DebugFigures(const engine::Canvas& canvas, const Simulation& simulation, const Meter* meter, double text_scale,
               ribbon::Vec2 max_size);

  ribbon::Vec2 size() const { return size_; }  ///< px
  void draw(engine::Canvas& canvas, ribbon::Vec2 corner) const;

 private:
  /// Columns are right-aligned; the first row has the titles.
  using Table = std::vector<std::vector<std::string>>;

  void measure(const engine::Canvas& canvas);
  void shorten(double max_height, double line_height);
  std::vector<double> column_edges(const engine::Canvas& canvas, const Table& table) const;

  std::vector<Table> tables_;
  std::vector<std::string> legend_;
  double text_size_;  // px
  double margin_;     // px
  ribbon::Vec2 size_{};
};

}  // namespace game
