#include "game/view/view.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "game/view/backdrop.h"
#include "game/view/bodies.h"
#include "game/view/cords.h"
#include "game/view/debug_view.h"
#include "game/view/figure.h"
#include "game/view/figure_state.h"
#include "game/view/hud.h"
#include "game/view/marks.h"
#include "game/view/palette.h"
#include "game/view/pen.h"
#include "game/view/view_in.h"
#include "game/view/water.h"
#include "game/view/wheels.h"

namespace game {
namespace {

using engine::Color;
using ribbon::Vec2;

std::vector<DrawnBody> bodies_of(const Simulation& simulation, const Snapshot& now) {
  std::vector<DrawnBody> bodies;
  const std::span<const engine::SceneBody> made = simulation.scene().bodies();
  std::size_t index = now.bodies.size();
  for (const b2Body* body = simulation.scene().world().GetBodyList(); body != nullptr; body = body->GetNext()) {
    --index;  // the newest body is first in the list
    if (body == &simulation.player().body()) continue;
    const bool is_load = std::any_of(made.begin(), made.end(), [body](const engine::SceneBody& b) {
      return b.body == body && b.kind == engine::BodyKind::load;
    });
    bodies.push_back({*body, now.bodies[index], static_cast<int>(index), is_load,
                      is_load ? held_position(simulation.scene().coupling(), now, *body) : std::nullopt});
  }
  return bodies;
}

std::vector<DrawnCord> cords_of(const Simulation& simulation, const Snapshot& now) {
  const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
  std::vector<DrawnCord> cords;
  for (const ribbon::box2d::CordId id : coupling.cords()) {
    const std::vector<Vec2>& points = now.cords[static_cast<std::size_t>(id)];
    cords.push_back({coupling, id, coupling.cord(id).shape(), points, simulation.player().line().cord() == id});
  }
  return cords;
}

void draw_cords(Pen& pen, const std::vector<DrawnCord>& cords, bool strain_tint) {
  std::vector<Color> colors;
  for (const DrawnCord& cord : cords) {
    colors.clear();
    for (int i = 0; strain_tint && i < cord.shape.columns; ++i) colors.push_back(strain_color(strain(cord, i)));
    draw_cord(pen, cord, colors);
  }
}

void draw_marks(Pen& pen, const Simulation& simulation, const std::vector<std::string>& signs) {
  const Level& level = simulation.level();
  for (std::size_t k = 0; k < level.signs.size(); ++k) {
    draw_sign(pen, level.signs[k].at, signs.empty() ? level.signs[k].text : signs[k], level.player_start);
  }
  for (std::size_t k = 0; k < level.checkpoints.size(); ++k)
    draw_checkpoint(pen, level.checkpoints[k].center, level.checkpoints[k].size, simulation.checkpoint() == k);
  if (level.goal) draw_goal(pen, *level.goal, simulation.goal_ticks().has_value());
  for (std::size_t k = 0; k < level.hooks.size(); ++k) draw_hook(pen, level.hooks[k], simulation.aimed_hook() == k);
}

/// Returns the box of the player on the canvas, px.
Rectangle box_of_player(const engine::Canvas& canvas, const Player& player, Vec2 at) {
  const Vec2 half{player.tuning().radius, 0.5 * player.tuning().height};
  const double scale = canvas.view().pixels_per_metre;
  return {canvas.to_pixels(at) - scale * half, 2.0 * scale * half};
}

/// Draws the player's line during a throw. A held or released line is drawn as a cord.
void draw_flight(Pen& pen, const Line& line, Vec2 hand) {
  if (line.state() == Line::State::flying) draw_thrown_line(pen, hand, line.tip(hand), 0.3);
}

}  // namespace

void View::draw(engine::Canvas& canvas, double alpha, const ViewOptions& options) {
  const Snapshot now = interpolate(simulation_->previous(), simulation_->current(), alpha);
  const double time = (simulation_->run_ticks() + alpha) / ticks_per_second;
  const Palette& colors = palette(options.colour_safe);
  Pen pen{canvas, colors, textures(colors), time, options.reduced_motion};
  effects_.follow(pen.colors, pen.reduced_motion);
  const FigureState figure = figure_of(*simulation_, now, time);
  const bool in_part = options.free.size.x >= 1.0 && options.free.size.y >= 1.0;
  const Vec2 size = in_part ? options.free.size : Vec2{1.0 * canvas.width(), 1.0 * canvas.height()};
  engine::View camera = effects_.view(alpha, static_cast<int>(size.x), static_cast<int>(size.y), pen.reduced_motion);
  if (in_part) camera = view_in(options.free, canvas, camera, figure.at, simulation_->level().map.size);
  canvas.set_view(camera);

  draw_backdrop(pen);
  draw_marks(pen, *simulation_, options.signs);
  draw_bodies(pen, bodies_of(*simulation_, now));
  draw_wheels(pen, now.wheels);
  const std::vector<DrawnCord> cords = cords_of(*simulation_, now);
  draw_cords(pen, cords, options.strain_tint);
  if (options.ghost) draw_ghost(pen, pose_of(figure_of(*options.ghost, time)));
  const Pose pose = pose_of(figure);
  draw_flight(pen, simulation_->player().line(), pose.throwing_hand());
  draw_figure(pen, pose);
  if (const auto& weather = simulation_->scene().weather()) draw_water(pen, weather->def().water_level);
  effects_.draw(pen, alpha);
  if (options.debug) {
    for (const DrawnCord& cord : cords) draw_debug(pen, cord);
  }
  if (!options.hud) return;
  draw_hud(canvas, *simulation_, options, {pen.labels, box_of_player(canvas, simulation_->player(), figure.at)},
           places_);
}

}  // namespace game
