#include "game/simulation/simulation.h"

#include <utility>

#include "game/simulation/aim.h"
#include "game/simulation/buttons.h"
#include "ribbon/box2d/convert.h"

namespace game {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_double;

constexpr double tick_dt = 1.0 / ticks_per_second;  // s
constexpr double max_grab_range = 10.0;             // m, accepted in a replay
constexpr const char* grab_range_setting = "player_reach";
constexpr const char* no_fall_setting = "no_fall";
constexpr double no_fall_value = 1.0;  // of no_fall_setting
constexpr int foothold_ticks = 15;     // of standing, after which a position becomes the foothold
constexpr double fall_depth = 3.0;     // m below the level, at which the player is put back

std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace

Snapshot interpolate(const Snapshot& from, const Snapshot& to, double alpha) {
  Snapshot between = to;
  for (std::size_t c = 0; c < to.cords.size(); ++c) {
    if (c >= from.cords.size() || from.cords[c].size() != to.cords[c].size())
      continue;  // a piece that has just been cut
    for (std::size_t p = 0; p < to.cords[c].size(); ++p) {
      between.cords[c][p] = from.cords[c][p] + alpha * (to.cords[c][p] - from.cords[c][p]);
    }
  }
  for (std::size_t b = 0; b < to.bodies.size(); ++b) {
    between.bodies[b].position = from.bodies[b].position + alpha * (to.bodies[b].position - from.bodies[b].position);
    between.bodies[b].angle = from.bodies[b].angle + alpha * (to.bodies[b].angle - from.bodies[b].angle);
  }
  for (std::size_t w = 0; w < to.wheels.size(); ++w) {
    between.wheels[w].center = from.wheels[w].center + alpha * (to.wheels[w].center - from.wheels[w].center);
    between.wheels[w].angle = from.wheels[w].angle + alpha * (to.wheels[w].angle - from.wheels[w].angle);
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
  for (const Line& line : player_->lines().all()) {
    if (!line.is_new()) continue;  // it did not exist before or was elsewhere: do not interpolate it
    previous_.cords.resize(current_.cords.size());
    previous_.cords[at(*line.cord())] = current_.cords[at(*line.cord())];
  }
  compute_hash();
}

void Simulation::skip(const engine::TickInput& input) {
  const unsigned pressed = input.buttons & ~static_cast<unsigned>(buttons_before_);
  buttons_before_ = input.buttons;
  if ((pressed & button_restart) != 0) restart();
  if ((pressed & button_retry) != 0) put_player_back();

  targets_.thrown = aimed_target(*level_, *scene_, *player_, engine::pointer(input));
  targets_.at_hand = (pressed & button_tie) != 0 ? target_at_hand(*level_, *scene_, *player_) : std::nullopt;
  std::uint16_t buttons = input.buttons;
  if (goal_ticks_) buttons = buttons_after_goal();
  if ((buttons & pressed & button_throw) != 0 && drop_load()) buttons &= static_cast<std::uint16_t>(~button_throw);
  player_->apply(buttons, targets_, scene_->coupling(), tick_dt);
  drag_.apply(input, *scene_, player_->body(), tick_dt);
  if (!make_mover_) {
    rules_.act(0, goal_ticks_ ? 0U : pressed, *player_, *scene_);
    rules_.before(*scene_, tick_dt);
  }
  move_(tick_dt);
  if (!make_mover_) rules_.after(*scene_);
  ++ticks_;
  ++run_ticks_;
  check_player();
}

void Simulation::save(SavedTick& saved) const {
  scene_->coupling().save(scene_->world(), saved.cords);
  saved.world.save(scene_->world());
  saved.player = *player_;
  saved.progress = progress_of(*this);
  saved.rules = rules_;
  saved.ride_time = scene_->rides().time();
  saved.restarts = restarts_;
}

bool Simulation::restore(SavedTick& saved, const SavedTick* before) {
  if (saved.restarts != restarts_) return false;
  const bool has_before = before != nullptr && before->restarts == restarts_;
  saved.world.restore(scene_->world(), has_before ? &before->world : nullptr);
  scene_->coupling().restore(saved.cords, scene_->world());
  *player_ = *saved.player;
  progress_of(*this) = saved.progress;
  rules_ = saved.rules;
  scene_->rides().set_time(saved.ride_time);
  take_snapshot(current_);
  previous_ = current_;
  compute_hash();
  return true;
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
  tuning.grab_range = level_->assists.grab_range.value_or(tuning.grab_range);
  player_ = std::make_unique<Player>(scene_->world(), level_->player_start, tuning, at(level_->lines));
  move_ = make_mover_ ? make_mover_(*scene_, *player_) : [scene = scene_.get()](double dt) { scene->tick(dt); };
  drag_.forget();
  rules_.start(level_->rules, *scene_);
  checkpoint_.reset();
  targets_ = {};
  foothold_ = level_->player_start;
  standing_ticks_ = 0;
  run_ticks_ = 0;
  falls_ = 0;
  goal_ticks_.reset();
  ++restarts_;
  keeps_changes_ = false;
  save(start_);
  take_snapshot(previous_);
  take_snapshot(current_);
}

/// Releases the loads that hang from the cord that the player holds, unless that is its line. Returns false if there
/// are none.
bool Simulation::drop_load() {
  ribbon::box2d::Coupling& coupling = scene_->coupling();
  const auto held = coupling.body(player_->body()).held_place();
  if (!held || player_->lines().held() != nullptr) return false;
  bool dropped = false;
  for (const engine::SceneBody& made : scene_->bodies()) {
    if (made.kind != engine::BodyKind::load) continue;
    const auto hangs = coupling.body(*made.body).held_place();
    if (hangs && hangs->cord == held->cord) dropped = coupling.body(*made.body).release() || dropped;
  }
  return dropped;
}

/// At the goal the player stops, or goes on holding what it holds.
std::uint16_t Simulation::buttons_after_goal() const {
  const bool holds = scene_->coupling().body(player_->body()).held_place().has_value();
  return holds ? static_cast<std::uint16_t>(button_grab) : std::uint16_t{0};
}

/// Puts the player at the last checkpoint, or at the start. Cords and bodies are as at the start of the level, so that
/// each try meets the same.
void Simulation::put_player_back() {
  if (!make_mover_ && !keeps_changes_) {
    drag_.forget();  // what it holds is free again
    start_.world.restore(scene_->world(), nullptr);
    scene_->coupling().restore(start_.cords, scene_->world());
    *player_ = *start_.player;
    rules_.return_to(start_.rules);
    scene_->rides().set_time(start_.ride_time);
  }
  rules_.send_chasers_back();
  Vec2 feet = level_->player_start;
  if (checkpoint_) {
    const Area& area = level_->checkpoints[*checkpoint_];
    feet = area.center - Vec2{0.0, 0.5 * area.size.y};
  }
  player_->put(feet, scene_->coupling());
}

/// Updates goal, checkpoint and falls after the player has moved.
void Simulation::check_player() {
  const Vec2 at = player_->position();
  if (level_->goal && !goal_ticks_) {
    const Flag flag = flag_of(*level_->goal);
    if (player_->touches(flag.pole) || player_->touches(flag.cloth)) goal_ticks_ = run_ticks_;
  }
  for (std::size_t k = 0; k < level_->checkpoints.size(); ++k) {
    if (level_->checkpoints[k].contains(at)) checkpoint_ = k;
  }
  if (level_->assists.no_fall) update_foothold();
  const bool dies = !goal_ticks_ && rules_.meet(*player_);
  if (at.y > -fall_depth && !dies) return;
  if (level_->assists.no_fall) {
    rules_.send_chasers_back();
    return player_->put(foothold_, scene_->coupling());
  }
  ++falls_;
  put_player_back();
}

/// Sets the foothold to a position at which the player stood at least foothold_ticks earlier, since the last position
/// is often the edge of a fall.
void Simulation::update_foothold() {
  if (!player_->is_on_firm_ground()) {
    standing_ticks_ = 0;
    return;
  }
  if (standing_ticks_ % foothold_ticks == 0) {
    if (standing_ticks_ > 0) foothold_ = next_foothold_;
    next_foothold_ = player_->position() - Vec2{0.0, 0.5 * player_->tuning().height};
  }
  ++standing_ticks_;
}

void Simulation::take_snapshot(Snapshot& snapshot) const {
  const ribbon::box2d::Coupling& coupling = scene_->coupling();
  const auto ids = coupling.cords();
  snapshot.cords.resize(ids.empty() ? 0 : at(ids.back()) + 1);
  for (std::vector<ribbon::Vec2>& cord : snapshot.cords) cord.clear();
  for (const ribbon::box2d::CordId id : ids) {
    const auto positions = coupling.cord(id).positions();
    snapshot.cords[at(id)].assign(positions.begin(), positions.end());
  }
  auto index = static_cast<std::size_t>(scene_->world().GetBodyCount());
  snapshot.bodies.resize(index);
  for (const b2Body* body = scene_->world().GetBodyList(); body != nullptr; body = body->GetNext()) {
    snapshot.bodies[--index] = {to_double(body->GetPosition()), static_cast<double>(body->GetAngle())};
  }
  snapshot.wheels.clear();
  for (const engine::SceneWheel& wheel : scene_->wheels()) {
    const ribbon::box2d::PulleyView pulley = coupling.pulley(wheel.pulley);
    snapshot.wheels.emplace_back();
    if (!pulley.is_valid()) continue;
    const ribbon::box2d::PulleyState state = pulley.state();
    snapshot.wheels.back() = {state.center, state.def.radius, state.angle};
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
  const auto held = scene_->coupling().body(player_->body()).held_place();
  game.add(held ? held->cord : -1);
  game.add(held ? held->point : -1);
  game.add(held ? held->along : 0.0);
  game.add(scene_->coupling().body(player_->body()).velocity());
  player_->add_to(game);
  rules_.add_to(game, *scene_);
  if (level_->assists.no_fall) {
    game.add(foothold_);
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
  if (level.assists.grab_range) header.settings[grab_range_setting] = *level.assists.grab_range;
  if (level.assists.no_fall) header.settings[no_fall_setting] = no_fall_value;
  return header;
}

void Simulation::take_assists(Level& level, const engine::ReplayHeader& header) {
  const auto declared = [&header](const char* setting) {
    const auto found = header.settings.find(setting);
    const double* value = found == header.settings.end() ? nullptr : std::get_if<double>(&found->second);
    return value != nullptr ? std::optional(*value) : std::nullopt;
  };
  const auto range = declared(grab_range_setting);
  level.assists.grab_range = range && *range > 0.0 && *range <= max_grab_range ? range : std::nullopt;
  level.assists.no_fall = declared(no_fall_setting) == no_fall_value;
}

}  // namespace game
