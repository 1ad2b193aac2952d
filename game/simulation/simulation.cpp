#include "game/simulation/simulation.h"

#include <algorithm>
#include <span>
#include <utility>

#include "game/simulation/aim.h"
#include "game/simulation/buttons.h"
#include "game/simulation/index.h"
#include "ribbon/box2d/convert.h"

namespace game {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_double;

constexpr double fall_depth = 3.0;      // m below the level, at which the player is put back
constexpr double checkpoint_gap = 0.4;  // m, to either side, at which two players return

struct Fallen {
  int player;
  bool is_death;  // a danger killed it
};

/// Releases the loads that hang from the cord that the player holds, unless that is its line. Returns false if there
/// are none.
bool drop_load(const Player& player, engine::Scene& scene) {
  ribbon::box2d::Coupling& coupling = scene.coupling();
  const auto held = player.held_place(coupling);
  if (!held || player.lines().held() != nullptr) return false;
  bool dropped = false;
  for (const engine::SceneBody& made : scene.bodies()) {
    if (made.kind != engine::BodyKind::load) continue;
    const auto hangs = coupling.body(*made.body).held_place();
    if (!hangs || hangs->cord != held->cord) continue;
    dropped = coupling.grip(*coupling.body(*made.body).first_grip()).release() || dropped;  // lines on it stay
  }
  return dropped;
}

/// At the goal a player stops, or goes on holding what it holds.
std::uint16_t buttons_after_goal(const Player& player, const engine::Scene& scene) {
  const bool holds = player.ledge() || player.held_place(scene.coupling());
  return holds ? static_cast<std::uint16_t>(button_grab) : std::uint16_t{0};
}

}  // namespace

Simulation::Simulation(const Level& level, MakeMover make_mover) : level_(&level), make_mover_(std::move(make_mover)) {
  restart();
  compute_hash();
}

void Simulation::tick(const engine::TickInput& input) {
  std::swap(previous_, current_);
  skip(input);
  if (make_mover_) return;

  take_snapshot(current_, *scene_);
  for (int k = 0; k < players(); ++k) {
    for (const Line& line : player(k).lines().all()) {
      if (!line.is_new()) continue;  // else it did not exist before or was elsewhere: do not interpolate it
      previous_.cords.resize(current_.cords.size());
      previous_.cords[at(*line.cord())] = current_.cords[at(*line.cord())];
    }
  }
  compute_hash();
}

void Simulation::skip(const engine::TickInput& input) {
  const ButtonsOfBoth buttons{input.buttons, players() == 2 ? input.second_buttons : std::uint16_t{0}};
  const std::array<unsigned, 2> pressed = players_.press(buttons);
  if (((pressed[0] | pressed[1]) & button_restart) != 0) restart();
  if (((pressed[0] | pressed[1]) & button_retry) != 0) put_players_back();

  apply(0, buttons[0], pressed[0], engine::pointer(input));
  if (players() == 2) apply(1, buttons[1], pressed[1], engine::second_pointer(input));
  follow_lines();
  players_.reel_tether(goal_ticks() ? ButtonsOfBoth{} : buttons, *scene_, tick_dt);
  std::array<b2Body*, 2> bodies{&players_[0].body(), players() == 2 ? &players_[1].body() : nullptr};
  drag_.apply(input, scene_->coupling(), scene_->bodies(), std::span(bodies).first(at(players())), tick_dt);
  if (!make_mover_) {
    for (int k = 0; k < players(); ++k) rules_.act(at(k), goal_ticks() ? 0U : pressed[at(k)], players_[k], *scene_);
    rules_.before(*scene_, tick_dt);
  }
  move_(tick_dt);
  if (!make_mover_) {
    rules_.after(*scene_);
    for (int k = 0; k < players(); ++k) players_[k].follow_cuts(scene_->coupling());
  }
  count_tick();
  check_players();
}

/// Applies the buttons of one player. Its line flies to what the pointer aims at, or to what is ahead.
void Simulation::apply(int number, std::uint16_t buttons, unsigned pressed, std::optional<Vec2> pointer) {
  Player& player = players_[number];
  Targets& targets = players_.seat(number).targets;
  targets.thrown = aimed_target(*level_, *scene_, player, pointer);
  targets.at_hand = (pressed & button_tie) != 0 ? target_at_hand(*level_, *scene_, player) : std::nullopt;
  targets.shared = players_.held_by_other(number, *scene_);
  if (goal_ticks()) buttons = buttons_after_goal(player, *scene_);
  if ((buttons & pressed & button_throw) != 0 && drop_load(player, *scene_))
    buttons &= static_cast<std::uint16_t>(~button_throw);
  player.apply(buttons, targets, scene_->coupling(), tick_dt);
}

/// A line that arrives is new where it is: no blade has cut it on its way.
void Simulation::follow_lines() {
  for (int k = 0; k < players(); ++k) {
    for (const Line& line : player(k).lines().all()) {
      if (line.is_new()) rules_.cord_was_put(*line.cord());
    }
  }
}

void Simulation::save(SavedTick& saved) const {
  scene_->coupling().save(scene_->world(), saved.cords);
  saved.world.save(scene_->world());
  players_.save(saved.players);
  saved.progress = *this;
  saved.drag = drag_;
  saved.rules = rules_;
  saved.ride_time = scene_->rides().time();
  saved.restarts = restarts_;
}

bool Simulation::restore(SavedTick& saved, const SavedTick* before) {
  if (saved.restarts != restarts_) return false;
  const bool has_before = before != nullptr && before->restarts == restarts_;
  saved.world.restore(scene_->world(), has_before ? &before->world : nullptr);
  scene_->coupling().restore(saved.cords, scene_->world());
  players_.restore(saved.players);
  RunProgress::operator=(saved.progress);
  drag_ = saved.drag;
  rules_ = saved.rules;
  scene_->rides().set_time(saved.ride_time);
  take_snapshot(current_, *scene_);
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
  players_.clear();
  scene_ = level_->make_scene();
  scene_->world().Step(0.0F, 0, 0);  // finds the contacts of what stands: they support it from the first tick on
  scene_->coupling().watch(watcher_);
  scene_->coupling().use(parallel_for_);
  players_.make(*level_, *scene_, !make_mover_);
  move_ = make_mover_ ? make_mover_(*scene_, players_[0]) : [scene = scene_.get()](double dt) { scene->tick(dt); };
  drag_.forget();
  rules_.start(level_->rules, *scene_);
  begin_run();
  ++restarts_;
  keeps_changes_ = false;
  save(start_);
  players_.hold_buttons();
  take_snapshot(previous_, *scene_);
  take_snapshot(current_, *scene_);
}

/// Puts the players at the last checkpoint, or at the start. Cords and bodies are as at the start of the level, so that
/// each try meets the same.
void Simulation::put_players_back() {
  if (!make_mover_ && !keeps_changes_) {
    drag_.forget();  // what it holds is free again
    start_.world.restore(scene_->world(), nullptr);
    scene_->coupling().restore(start_.cords, scene_->world());
    players_.put_back(start_.players);
    players_.hold_buttons();
    rules_.return_to(start_.rules);
    scene_->rides().set_time(start_.ride_time);
    if (tether() && !checkpoint())
      return rules_.send_chasers_back();  // all is as it was laid, also the rope between the players
  }
  rules_.send_chasers_back();
  const Vec2 start = level_->player_start;
  if (!checkpoint()) return put_at(start, level_->second ? level_->second->start : start);
  const Area& area = level_->checkpoints[*checkpoint()];
  const Vec2 feet = area.center - Vec2{0.0, 0.5 * area.size.y};
  const Vec2 aside{players() == 2 ? checkpoint_gap : 0.0, 0.0};
  put_at(feet - aside, feet + aside);
}

void Simulation::put_at(Vec2 first, Vec2 second) {
  if (players_.put_at(first, second, *scene_)) rules_.cords_were_put(*scene_);
}

bool Simulation::is_at_flag(int number) const {
  if (!level_->goal) return false;
  const Flag flag = flag_of(*level_->goal);
  return player(number).touches(flag.pole) || player(number).touches(flag.cloth);
}

/// Updates goal, checkpoint and falls after the players have moved. If one falls, both are put back.
void Simulation::check_players() {
  if (!goal_ticks() && is_at_flag(0) && (players() == 1 || is_at_flag(1))) reach_goal();
  std::optional<Fallen> fallen;
  for (int k = 0; k < players(); ++k) {
    const Vec2 at = player(k).position();
    std::optional<std::size_t> inside;
    for (std::size_t c = 0; c < level_->checkpoints.size(); ++c) {
      if (level_->checkpoints[c].contains(at)) inside = c;
    }
    // A player that waits in an earlier one does not take it back.
    std::optional<std::size_t>& was_inside = players_.seat(k).inside;
    if (inside && inside != was_inside) enter(*inside);
    was_inside = inside;
    if (level_->assists.no_fall) players_.update_foothold(k);
    const bool dies = !goal_ticks() && rules_.meet(player(k));
    if (dies || at.y <= -fall_depth) fallen = Fallen{k, dies};
  }
  if (!fallen) return;
  if (level_->assists.no_fall) {
    const Vec2 foothold = players_.seat(fallen->player).foothold;
    rules_.send_chasers_back();
    return put_at(foothold, foothold);
  }
  fall(fallen->player, fallen->is_death);
  put_players_back();
}

void Simulation::compute_hash() {
  ribbon::box2d::Hasher game;
  game.add(ticks());
  game.add(run_ticks());
  game.add(falls());
  game.add(goal_ticks().value_or(-1));
  game.add(checkpoint() ? static_cast<int>(*checkpoint()) : -1);
  drag_.add_to(game);
  for (int k = 0; k < players(); ++k) players_.add_to(game, k, *level_, *scene_);
  if (tether()) tether()->add_to(game);
  rules_.add_to(game, *scene_);

  hash_.clear();
  hash_.add(ribbon::box2d::Subsystem::game, 0, game);
  scene_->add_to(hash_);
}

}  // namespace game
