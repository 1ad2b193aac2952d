#include "game/simulation/simulation.h"

#include <utility>

#include "game/simulation/buttons.h"
#include "ribbon/box2d/convert.h"

namespace game {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_double;

constexpr double tick_dt = 1.0 / ticks_per_second;  // s
constexpr double longest_reach = 10.0;              // m, that a replay may declare
constexpr const char* reach_setting = "player_reach";
constexpr const char* no_fall_setting = "no_fall";
constexpr double no_fall_value = 1.0;  // where a replay declares it
constexpr int firm_ticks = 15;         // of standing, after which a place is one to come back to
constexpr double abyss = 3.0;          // m below the level, where the player is put back
constexpr double pointer_reach = 1.5;  // m, from the pointer to a hook that it is at
constexpr double look_ahead = 3.0;     // m, from the hand to where a hook is looked for without pointing
constexpr double look_up = 5.0;        // m

std::size_t at(int index) { return static_cast<std::size_t>(index); }

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
  drag_.apply(input, *scene_, player_->body(), tick_dt);
  move_(tick_dt);
  ++ticks_;
  ++run_ticks_;
  watch_the_player();
}

void Simulation::watch(ribbon::box2d::StepWatcher* watcher) {
  watcher_ = watcher;
  scene_->coupling().watch(watcher);
}

void Simulation::use(const ribbon::ParallelFor& parallel_for) {
  parallel_for_ = parallel_for;
  scene_->coupling().use(parallel_for);
}

void Simulation::restart() {
  move_ = {};
  player_.reset();
  scene_ = level_->make_scene();
  scene_->coupling().watch(watcher_);
  scene_->coupling().use(parallel_for_);
  PlayerTuning tuning;
  tuning.mass = level_->player_mass;
  tuning.reach = level_->assists.player_reach.value_or(tuning.reach);
  player_ = std::make_unique<Player>(scene_->world(), level_->player_start, tuning);
  move_ = make_mover_ ? make_mover_(*scene_, *player_) : [scene = scene_.get()](double dt) { scene->tick(dt); };
  drag_.forget();
  checkpoint_.reset();
  aimed_hook_.reset();
  stood_at_ = level_->player_start;
  standing_ticks_ = 0;
  run_ticks_ = 0;
  falls_ = 0;
  goal_ticks_.reset();
  take_snapshot(previous_);
  take_snapshot(current_);
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
  ribbon::box2d::Coupling& coupling = scene_->coupling();
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
  if (level_->assists.no_fall) remember_where_he_stands();
  if (at.y > -abyss) return;
  if (level_->assists.no_fall) return player_->put(stood_at_, scene_->coupling());
  ++falls_;
  put_player_back();
}

/// Not the last place itself, which is the edge that he fell from: he has stood on for some time since.
void Simulation::remember_where_he_stands() {
  if (!player_->is_on_firm_ground()) {
    standing_ticks_ = 0;
    return;
  }
  if (standing_ticks_ % firm_ticks == 0) {
    if (standing_ticks_ > 0) stood_at_ = stands_at_;
    stands_at_ = player_->position() - Vec2{0.0, 0.5 * player_->tuning().height};
  }
  ++standing_ticks_;
}

void Simulation::take_snapshot(Snapshot& snapshot) const {
  const ribbon::box2d::Coupling& coupling = scene_->coupling();
  snapshot.cords.resize(static_cast<std::size_t>(coupling.size()));
  for (int c = 0; c < coupling.size(); ++c) {
    const auto positions = coupling.cord(c).positions();
    snapshot.cords[static_cast<std::size_t>(c)].assign(positions.begin(), positions.end());
  }
  auto index = static_cast<std::size_t>(scene_->world().GetBodyCount());
  snapshot.bodies.resize(index);
  for (const b2Body* body = scene_->world().GetBodyList(); body != nullptr; body = body->GetNext()) {
    snapshot.bodies[--index] = {to_double(body->GetPosition()), static_cast<double>(body->GetAngle())};
  }
}

void Simulation::compute_hash() {
  ribbon::box2d::Hasher game;
  game.add(ticks_);
  game.add(run_ticks_);
  game.add(falls_);
  game.add(goal_ticks_.value_or(-1));
  game.add(checkpoint_ ? static_cast<int>(*checkpoint_) : -1);
  drag_.add_to(game);
  const auto held = scene_->coupling().held_by(player_->body());
  game.add(held ? held->cord : -1);
  game.add(held ? held->point : -1);
  game.add(held ? held->along : 0.0);
  game.add(scene_->coupling().velocity(player_->body()));
  player_->add_to(game);
  if (level_->assists.no_fall) {
    game.add(stood_at_);
    game.add(standing_ticks_);
  }

  hash_.clear();
  hash_.add(ribbon::box2d::Subsystem::game, 0, game);
  scene_->add_to(hash_);
}

engine::ReplayHeader Simulation::replay_header(const Level& level) {
  engine::ReplayHeader header;
  header.level = level.name;
  header.level_hash = level.map.content_hash;
  header.tick_rate = ticks_per_second;
  header.settings["velocity_iterations"] = static_cast<double>(engine::Scene::velocity_iterations);
  header.settings["position_iterations"] = static_cast<double>(engine::Scene::position_iterations);
  header.settings["cord_method"] = std::string(ribbon::box2d::solver_name(engine::Scene::default_solver));
  if (level.assists.player_reach) header.settings[reach_setting] = *level.assists.player_reach;
  if (level.assists.no_fall) header.settings[no_fall_setting] = no_fall_value;
  return header;
}

void Simulation::take_assists(Level& level, const engine::ReplayHeader& header) {
  const auto declared = [&header](const char* setting) {
    const auto found = header.settings.find(setting);
    const double* value = found == header.settings.end() ? nullptr : std::get_if<double>(&found->second);
    return value != nullptr ? std::optional(*value) : std::nullopt;
  };
  const auto reach = declared(reach_setting);
  level.assists.player_reach = reach && *reach > 0.0 && *reach <= longest_reach ? reach : std::nullopt;
  level.assists.no_fall = declared(no_fall_setting) == no_fall_value;
}

}  // namespace game
