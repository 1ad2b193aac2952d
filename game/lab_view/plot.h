#pragma once

#include <functional>
#include <span>
#include <string>

#include "engine/draw/canvas.h"
#include "game/lab/history.h"
#include "game/lab_view/layout.h"

namespace game::lab {

/// Draws the energies and the stretches of the last seconds, side by side, with one line for each bench.
void draw_plots(engine::Canvas& canvas, const History& history, std::size_t benches, const Layout& layout);

/// The range of a plot.
struct PlotRange {
  double low, high;
};
/// Returns a range around all numbers that is not narrower than `least`.
PlotRange range_around(std::span<const double> numbers, double least);

}  // namespace game::lab
