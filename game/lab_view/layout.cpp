#include "game/lab_view/layout.h"

namespace game::lab {
namespace {

// Units of text.
constexpr double list_width = 176.0;
constexpr double panel_width = 252.0;
constexpr double head_height = 112.0;         // with one line of figures for each bench
constexpr double narrow_head_height = 148.0;  // with two
constexpr double narrow = 760.0;
constexpr double plots_height = 112.0;

}  // namespace

Layout layout_of(const engine::Canvas& canvas, double text_scale) {
  const double width = canvas.width();
  const double height = canvas.height();
  const double left = list_width * text_scale;
  const double middle = width - left - panel_width * text_scale;
  const double head = (middle < narrow * text_scale ? narrow_head_height : head_height) * text_scale;
  const double plots = plots_height * text_scale;
  return {.unit = text_scale,
          .list = {{}, {left, height}},
          .panel = {{left + middle, 0.0}, {panel_width * text_scale, height}},
          .head = {{left, 0.0}, {middle, head}},
          .world = {{left, head}, {middle, height - head - plots}},
          .plots = {{left, height - plots}, {middle, plots}}};
}

}  // namespace game::lab
