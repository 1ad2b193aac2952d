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
#include "game/view/fraying.h"
#include "game/view/hazards.h"
#include "game/view/hud.h"
#include "game/view/marks.h"
#include "game/view/palette.h"
#include "game/view/pen.h"
#include "game/view/sticky_rim.h"
#include "game/view/view_in.h"
#include "game/view/water.h"
#include "game/view/wheels.h"

namespace game {
namespace {

using engine::Color;
using ribbon::Vec2;

bool is_player(const Simulation& simulation, const b2Body& body) {
  for (int k = 0; k < simulation.players(); ++k) {
    if (&body == &simulation.player(k).body()) return true;
  }
  return false;
}

std::vector<DrawnBody> bodies_of(const Simulation& simulation, const Snapshot& now) {
  std::vector<DrawnBody> bodies;
  const std::span<const engine::SceneBody> made = simulation.scene().bodies();
  std::size_t index = now.bodies.size();
  for (const b2Body* body = simulation.scene().world().GetBodyList(); body != nullptr; body = body->GetNext()) {
    --index;  // the newest body is first in the list
    if (is_player(simulation, *body)) continue;
    const auto found =
        std::find_if(made.begin(), made.end(), [body](const engine::SceneBody& b) { return b.body == body; });
    const bool is_load = found != made.end() && found->kind == engine::BodyKind::load;
    bodies.push_back({*body, now.bodies[index], static_cast<int>(index), is_load,
                      found != made.end() && found->is_sticky,
                      is_load ? held_position(simulation.scene().coupling(), now, *body) : std::nullopt});
  }
  return bodies;
}

/// Returns whether a cord is a line of a player, tied or cut too: it is not from the map.
bool is_line(const ribbon::box2d::CordView& cord) { return cord.user_data() == 0; }

std::vector<DrawnCord> cords_of(const Simulation& simulation, const Snapshot& now) {
  const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
  std::vector<DrawnCord> cords;
  const auto held = simulation.player().held_place(coupling);
  const double weight = 9.81 * simulation.level().player_mass;
  for (const ribbon::box2d::CordId id : coupling.cords()) {
    const std::vector<Vec2>& points = now.cords[static_cast<std::size_t>(id)];
    cords.push_back({coupling, id, coupling.cord(id).shape(), points, is_line(coupling.cord(id))});
    if (held && held->cord == id) cords.back().load = largest_tension(coupling, id) / weight;
  }
  return cords;
}

void draw_cords(Pen& pen, const std::vector<DrawnCord>& cords, const Burning& burning, bool strain_tint) {
  std::vector<Color> colors;
  for (const DrawnCord& cord : cords) {
    colors.clear();
    for (int i = 0; strain_tint && i < cord.shape.columns; ++i) colors.push_back(strain_color(strain(cord, i)));
    if (!strain_tint) add_char(pen, cord, burning, colors);
    draw_cord(pen, cord, colors);
    draw_frays(pen, cord);
    draw_flames_on(pen, cord, burning);
  }
}

bool is_aimed_at(const Simulation& simulation, std::size_t hook) {
  for (int k = 0; k < simulation.players(); ++k) {
    if (simulation.target(k) && simulation.target(k)->hook == hook) return true;
  }
  return false;
}

void draw_marks(Pen& pen, const Simulation& simulation, const std::vector<std::string>& signs) {
  const Level& level = simulation.level();
  for (std::size_t k = 0; k < level.signs.size(); ++k) {
    draw_sign(pen, level.signs[k].at, signs.empty() ? level.signs[k].text : signs[k], level.player_start);
  }
  for (std::size_t k = 0; k < level.checkpoints.size(); ++k)
    draw_checkpoint(pen, level.checkpoints[k].center, level.checkpoints[k].size, simulation.checkpoint() == k);
  if (level.goal) draw_goal(pen, *level.goal, simulation.goal_ticks().has_value());
  for (std::size_t k = 0; k < level.hooks.size(); ++k) draw_hook(pen, level.hooks[k], is_aimed_at(simulation, k));
  for (int k = 0; k < simulation.players(); ++k) {
    const std::optional<Target>& target = simulation.target(k);
    if (target && !target->hook) draw_aim(pen, target->place());
  }
}

/// Returns the box of the player on the canvas, px.
Rectangle box_of_player(const engine::Canvas& canvas, const Player& player, Vec2 at) {
  const Vec2 half{player.tuning().radius, 0.5 * player.tuning().height};
  const double scale = canvas.view().pixels_per_metre;
  return {canvas.to_pixels(at) - scale * half, 2.0 * scale * half};
}

/// Draws the player's lines during a throw. A held or released line is drawn as a cord.
void draw_flight(Pen& pen, const Lines& lines, Vec2 hand) {
  for (const Line& line : lines.all()) {
    if (line.state() == Line::State::flying) draw_thrown_line(pen, hand, line.tip(hand), 0.3);
  }
}

/// Draws the players with their lines and the trail, or, just after a fall, a figure that falls on.
void draw_players(Pen& pen, const Simulation& simulation, const Effects& effects, const Snapshot& now, double alpha) {
  if (const Fall& fall = effects.fall(); fall.is_closing()) {
    FigureState falling;
    falling.at = fall.at(alpha);
    falling.velocity = fall.velocity();
    falling.on_ground = false;
    falling.time = pen.time;
    return draw_figure(pen, pose_of(falling), clothes_of(simulation.last_fallen()));
  }
  effects.draw_trail(pen, figure_of(simulation, now, pen.time).at);
  for (int k = simulation.players() - 1; k >= 0; --k) {  // the first one in front
    const Pose pose = pose_of(figure_of(simulation, now, pen.time, k));
    draw_flight(pen, simulation.player(k).lines(), pose.throwing_hand());
    draw_figure(pen, pose, clothes_of(k));
  }
}

}  // namespace

bool View::prepare(int height, bool colour_safe, Place place) {
  if (prepared_height_ == height && prepared_safe_ == colour_safe && prepared_place_ == place) return false;
  prepared_height_ = height;
  prepared_safe_ = colour_safe;
  prepared_place_ = place;
  stamps_.clear();
  return true;
}

void View::draw(engine::Canvas& canvas, double alpha, const ViewOptions& options) {
  const Snapshot now = interpolate(simulation_->previous(), simulation_->current(), alpha);
  const double time = (simulation_->run_ticks() + alpha) / ticks_per_second;
  const Place place = simulation_->level().place;
  const Palette& colors = palette(options.colour_safe, place);
  Pen pen{canvas, colors, textures(options.colour_safe, place), time, options.reduced_motion, place, &stamps_};
  pen.prepares = prepare(canvas.height(), options.colour_safe, place);
  effects_.follow(pen.colors, pen.reduced_motion);
  const FigureState figure = figure_of(*simulation_, now, time);
  const bool in_part = options.free.size.x >= 1.0 && options.free.size.y >= 1.0;
  const Vec2 size = in_part ? options.free.size : Vec2{1.0 * canvas.width(), 1.0 * canvas.height()};
  engine::View camera = effects_.view(alpha, static_cast<int>(size.x), static_cast<int>(size.y), pen.reduced_motion);
  if (in_part) camera = view_in(options.free, canvas, camera, figure.at, simulation_->level().map.size);
  canvas.set_view(camera);

  draw_backdrop(pen);
  draw_marks(pen, *simulation_, options.signs);
  draw_rails(pen, simulation_->level());
  const std::vector<DrawnBody> drawn_bodies = bodies_of(*simulation_, now);
  draw_bodies(pen, drawn_bodies);
  draw_sticky_rims(pen, drawn_bodies);
  draw_wheels(pen, now.wheels);
  const std::vector<DrawnCord> cords = cords_of(*simulation_, now);
  draw_cords(pen, cords, simulation_->rules().burning(), options.strain_tint);
  for (const std::optional<GhostPose>& ghost : {options.ghost, options.second_ghost}) {
    if (ghost) draw_ghost(pen, pose_of(figure_of(*ghost, time)));
  }
  draw_hazards(pen, *simulation_, alpha);
  draw_players(pen, *simulation_, effects_, now, alpha);
  if (const auto& weather = simulation_->scene().weather()) draw_water(pen, weather->def().water_level);
  effects_.draw(pen, alpha);
  draw_foreground(pen, figure.at);
  effects_.fall().draw(pen, figure.at, alpha);
  if (options.debug) {
    for (const DrawnCord& cord : cords) draw_debug(pen, cord);
  }
  if (!options.hud) return;
  draw_hud(canvas, *simulation_, options, {pen.labels, box_of_player(canvas, simulation_->player(), figure.at)},
           places_);
}

}  // namespace game
