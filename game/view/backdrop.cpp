#include "game/view/backdrop.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "game/view/backdrop_places.h"

namespace game {
namespace {

constexpr std::array<Range, 4> usual_ranges = {{{0.93, 0.44, 0.20, 0.60, 0.030, 401},
                                                {0.86, 0.34, 0.14, 0.50, 0.008, 402},
                                                {0.76, 0.24, 0.11, 0.42, 0.006, 403},
                                                {0.62, 0.12, 0.08, 0.34, 0.004, 404}}};

}  // namespace

void draw_gradient(Pen& pen, double end, engine::Color top, engine::Color middle, engine::Color bottom) {
  const double width = pen.canvas.width();
  const double high = pen.canvas.height();
  const double half = std::round(0.5 * end * high);
  pen.fade({0.0, 0.0}, {width, half}, top, middle);
  pen.fade({0.0, half}, {width, end * high - half}, middle, bottom);
}

void draw_hills(Pen& pen) {
  const Palette& colors = pen.colors;
  std::array<Outline, usual_ranges.size()> outlines;
  for (std::size_t k = 0; k < usual_ranges.size(); ++k) outlines[k] = outline_of(pen, usual_ranges[k]);
  draw_fixed(pen, outlines[0].lowest, [&] {
    draw_gradient(pen, 1.0, colors.sky_top, colors.sky_middle, colors.horizon);
    draw_sun(pen, {0.74, 0.26}, 1.1, 0.052);
  });
  draw_clouds(pen, {});
  for (std::size_t k = 0; k < usual_ranges.size(); ++k) {
    if (k == 2) draw_props(pen, usual_ranges[k], pen.images.props[0], {0.021, 0.055, 0.5, 0.48});
    if (k == 3) draw_props(pen, usual_ranges[k], pen.images.props[1], {0.034, 0.11, 0.5, 0.48});
    const double cut = k + 1 < usual_ranges.size() ? outlines[k + 1].lowest + 1.0 : pen.canvas.height();
    draw_range(pen, outlines[k], colors.hills[k], mix(colors.hills[k], colors.mist, 0.7), cut);
  }
}

void draw_backdrop(Pen& pen) {
  switch (pen.place) {
    case Place::hills: return draw_hills(pen);
    case Place::cave: return draw_cave(pen);
    case Place::harbour: return draw_harbour(pen);
    case Place::storm: return draw_storm(pen);
  }
}

void draw_foreground(Pen& pen, ribbon::Vec2 player) {
  if (pen.colors.lamp.a > 0) draw_lamp(pen, player);
  if (pen.place == Place::storm) draw_rain(pen);
}

}  // namespace game
