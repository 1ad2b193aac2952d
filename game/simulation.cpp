#include "game/simulation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/convert.h"
#include "game/buttons.h"

namespace game {
namespace {

using engine::to_double;
using engine::to_float;
using ribbon::Vec2;

constexpr double tick_dt = 1.0 / ticks_per_second;  // s
constexpr double drag_reach = 1.0;                  // m, from the pointer to a cord point it can take
constexpr double drag_speed = 15.0;                 // m/s, at which it takes the point along at the most
constexpr double longest_reach = 10.0;              // m, that a replay may declare
constexpr const char* reach_setting = "player_reach";
constexpr double abyss = 3.0;          // m below the level, where the player is put back
constexpr double pointer_reach = 1.5;  // m, from the pointer to a hook that it is at
constexpr double look_ahead = 3.0;     // m, from the hand to where a hook is looked for without pointing
constexpr double look_up = 5.0;        // m

/// m, along the cord from one point to another.
double way_between(const engine::Coupling& coupling, engine::CordIndex cord, int from, int to) {
  const int rows = coupling.shape(cord).rows;
  const auto x = coupling.positions(cord);
  const auto row = static_cast<std::size_t>(from % rows);
  const auto step = static_cast<std::size_t>(rows);
  double way = 0.0;
  for (std::size_t p = static_cast<std::size_t>(std::min(from, to) / rows) * step + row;
       p < static_cast<std::size_t>(std::max(from, to) / rows) * step + row; p += step) {
    way += length(x[p + step] - x[p]);
  }
  return way;
}

std::size_t at(int index) { return static_cast<std::size_t>(index); }

Vec2 no_further(Vec2 from, Vec2 to, double most) {
  const double way = length(to - from);
  return way > most ? from + (most / way) * (to - from) : to;
}

/// Where a point can be dragged to in this tick: towards `pointer` as fast as may be, and no further from what the cord
/// is fixed to than it is long. One that does not stretch would be torn about otherwise.
Vec2 within_reach(const engine::Coupling& coupling, const engine::CordPoint& dragged, Vec2 pointer) {
  const auto x = coupling.positions(dragged.cord);
  Vec2 target = no_further(x[static_cast<std::size_t>(dragged.point)], pointer, drag_speed * tick_dt);
  for (int p = 0; p < static_cast<int>(x.size()); ++p) {
    if (coupling.kind(dragged.cord, p) != ribbon::PointKind::constrained) continue;
    const double way = way_between(coupling, dragged.cord, dragged.point, p);
    target = no_further(x[static_cast<std::size_t>(p)], target, way);
  }
  return target;
}

}  // namespace

Snapshot interpolate(const Snapshot& from, const Snapshot& to, double alpha) {
  Snapshot between = to;
  for (std::size_t c = 0; c < to.cords.size(); ++c) {
    for (std::size_t p = 0; p < to.cords[c].size(); ++p) {
      between.cords[c][p] = from.cords[c][p] + alpha * (to.cords[c][p] - from.cords[c][p]);
    }
  }
  for (std::size_t b = 0; b < to.bodies.size(); ++b) {
    between.bodies[b].position = from.bodies[b].position + alpha * (to.bodies[b].position - from.bodies[b].position);
    between.bodies[b].angle = from.bodies[b].angle + alpha * (to.bodies[b].angle - from.bodies[b].angle);
  }
  return between;
}

Simulation::Simulation(const Level& level, MakeMover make_mover) : level_(&level), make_mover_(std::move(make_mover)) {
  restart();
  compute_hash();
}

void Simulation::tick(const engine::TickInput& input) {
  std::swap(previous_, current_);
  skip(input);
  if (make_mover_) return;

  take_snapshot(current_);
  if (player_->line().is_new()) {  // was nowhere before, or elsewhere
    previous_.cords.resize(current_.cords.size());
    previous_.cords[at(*player_->line().cord())] = current_.cords[at(*player_->line().cord())];
  }
  compute_hash();
}

void Simulation::skip(const engine::TickInput& input) {
  const unsigned pressed = input.buttons & ~static_cast<unsigned>(buttons_before_);
  buttons_before_ = input.buttons;
  if ((pressed & button_restart) != 0) restart();
  if ((pressed & button_retry) != 0) put_player_back();

  aim(engine::pointer(input));
  std::uint16_t buttons = input.buttons;
  if ((pressed & button_throw) != 0 && drop_load()) buttons &= static_cast<std::uint16_t>(~button_throw);
  const auto hook = aimed_hook_ ? std::optional(level_->hooks[*aimed_hook_]) : std::nullopt;
  player_->apply(buttons, hook, scene_->coupling(), tick_dt);
  drag(input);
  move_(tick_dt);
  ++ticks_;
  ++run_ticks_;
  watch_the_player();
}

void Simulation::restart() {
  move_ = {};
  player_.reset();
  scene_ = level_->make_scene();
  PlayerTuning tuning;
  tuning.mass = level_->player_mass;
  tuning.reach = level_->player_reach.value_or(tuning.reach);
  player_ = std::make_unique<Player>(scene_->world(), level_->player_start, tuning);
  move_ = make_mover_ ? make_mover_(*scene_, *player_) : [scene = scene_.get()](double dt) { scene->tick(dt); };
  dragged_.reset();
  checkpoint_.reset();
  aimed_hook_.reset();
  run_ticks_ = 0;
  falls_ = 0;
  goal_ticks_.reset();
  take_snapshot(previous_);
  take_snapshot(current_);
}

/// The pointer takes the cord point nearest to it and keeps it, as far as the cord reaches, until it lets go.
/// Constrained points stay.
void Simulation::drag(const engine::TickInput& input) {
  engine::Coupling& coupling = scene_->coupling();
  if ((input.buttons & button_drag) == 0) {
    if (dragged_) coupling.release(dragged_->cord, dragged_->point);
    dragged_.reset();
    return;
  }
  const Vec2 pointer = engine::pointer(input);
  if (!dragged_) {
    const auto nearest = coupling.nearest_point(pointer, drag_reach);
    if (!nearest || coupling.kind(nearest->cord, nearest->point) != ribbon::PointKind::free) return;
    dragged_ = nearest;
  }
  coupling.operate(dragged_->cord, dragged_->point, within_reach(coupling, *dragged_, pointer));
}

/// The hook that the pointer is at; if it is at none within reach, the one that is best ahead and above.
void Simulation::aim(Vec2 pointer) {
  aimed_hook_.reset();
  const Vec2 hand = player_->hand();
  const Vec2 ahead = hand + Vec2{player_->faces_left() ? -look_ahead : look_ahead, look_up};
  double best = 0.0;
  for (std::size_t k = 0; k < level_->hooks.size(); ++k) {
    const Vec2 hook = level_->hooks[k];
    if (length(hook - hand) > player_->line().tuning().reach) continue;
    const double from_pointer = length(hook - pointer);
    const double cost = from_pointer <= pointer_reach ? from_pointer - pointer_reach : length(hook - ahead);
    if (aimed_hook_ && cost >= best) continue;
    aimed_hook_ = k;
    best = cost;
  }
}

/// What hangs from the cord that the player holds; false if nothing does.
bool Simulation::drop_load() {
  engine::Coupling& coupling = scene_->coupling();
  const auto held = coupling.held_by(player_->body());
  if (!held) return false;
  bool dropped = false;
  for (const engine::SceneBody& made : scene_->bodies()) {
    if (made.kind != engine::BodyKind::load) continue;
    const auto hangs = coupling.held_by(*made.body);
    if (hangs && hangs->cord == held->cord) dropped = coupling.release(*made.body) || dropped;
  }
  return dropped;
}

void Simulation::put_player_back() {
  Vec2 feet = level_->player_start;
  if (checkpoint_) {
    const Area& area = level_->checkpoints[*checkpoint_];
    feet = area.center - Vec2{0.0, 0.5 * area.size.y};
  }
  player_->put(feet, scene_->coupling());
}

void Simulation::watch_the_player() {
  const Vec2 at = player_->position();
  if (level_->goal.holds(at) && !goal_ticks_) goal_ticks_ = run_ticks_;
  for (std::size_t k = 0; k < level_->checkpoints.size(); ++k) {
    if (level_->checkpoints[k].holds(at)) checkpoint_ = k;
  }
  if (at.y > -abyss) return;
  ++falls_;
  put_player_back();
}

void Simulation::take_snapshot(Snapshot& snapshot) const {
  const engine::Coupling& coupling = scene_->coupling();
  snapshot.cords.resize(static_cast<std::size_t>(coupling.size()));
  for (int c = 0; c < coupling.size(); ++c) {
    const auto positions = coupling.positions(c);
    snapshot.cords[static_cast<std::size_t>(c)].assign(positions.begin(), positions.end());
  }
  auto index = static_cast<std::size_t>(scene_->world().GetBodyCount());
  snapshot.bodies.resize(index);
  for (const b2Body* body = scene_->world().GetBodyList(); body != nullptr; body = body->GetNext()) {
    snapshot.bodies[--index] = {to_double(body->GetPosition()), static_cast<double>(body->GetAngle())};
  }
}

void Simulation::compute_hash() {
  engine::Hasher game;
  game.add(ticks_);
  game.add(run_ticks_);
  game.add(falls_);
  game.add(goal_ticks_.value_or(-1));
  game.add(checkpoint_ ? static_cast<int>(*checkpoint_) : -1);
  game.add(dragged_ ? dragged_->cord : -1);
  game.add(dragged_ ? dragged_->point : -1);
  const auto held = scene_->coupling().held_by(player_->body());
  game.add(held ? held->cord : -1);
  game.add(held ? held->point : -1);
  game.add(held ? held->along : 0.0);
  game.add(scene_->coupling().velocity(player_->body()));
  player_->add_to(game);

  hash_.clear();
  hash_.add(engine::Subsystem::game, 0, game);
  scene_->add_to(hash_);
}

engine::ReplayHeader Simulation::replay_header(const Level& level) {
  engine::ReplayHeader header;
  header.level = level.name;
  header.level_hash = level.map.content_hash;
  header.tick_rate = ticks_per_second;
  header.settings["velocity_iterations"] = static_cast<double>(engine::Scene::velocity_iterations);
  header.settings["position_iterations"] = static_cast<double>(engine::Scene::position_iterations);
  header.settings["cord_method"] = std::string(engine::solver_name(engine::Scene::default_solver));
  if (level.player_reach) header.settings[reach_setting] = *level.player_reach;
  return header;
}

void Simulation::take_assists(Level& level, const engine::ReplayHeader& header) {
  const auto found = header.settings.find(reach_setting);
  const double* reach = found == header.settings.end() ? nullptr : std::get_if<double>(&found->second);
  level.player_reach =
      reach != nullptr && *reach > 0.0 && *reach <= longest_reach ? std::optional(*reach) : std::nullopt;
}

}  // namespace game
