#include "game/simulation/simulation.h"

#include <algorithm>
#include <span>
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
constexpr double no_fall_value = 1.0;      // of no_fall_setting
constexpr int foothold_ticks = 15;         // of standing, after which a position becomes the foothold
constexpr double fall_depth = 3.0;         // m below the level, at which the player is put back
constexpr double checkpoint_gap = 0.4;     // m, to either side, at which two players return
constexpr std::int16_t player_group = -1;  // of Box2D: two players do not touch each other

std::size_t at(int index) { return static_cast<std::size_t>(index); }

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
  const std::array<std::uint16_t, 2> buttons{input.buttons, players() == 2 ? input.second_buttons : std::uint16_t{0}};
  std::array<unsigned, 2> pressed{};
  for (std::size_t k = 0; k < seats_.size(); ++k) {
    pressed[k] = buttons[k] & ~static_cast<unsigned>(seats_[k].buttons_before);
    seats_[k].buttons_before = buttons[k];
  }
  if (((pressed[0] | pressed[1]) & button_restart) != 0) restart();
  if (((pressed[0] | pressed[1]) & button_retry) != 0) put_players_back();

  apply(0, buttons[0], pressed[0], engine::pointer(input));
  if (players() == 2) apply(1, buttons[1], pressed[1], std::nullopt);
  follow_lines();
  if (tether_) reel_tether(input);
  std::array<b2Body*, 2> bodies{&players_[0]->body(), players() == 2 ? &players_[1]->body() : nullptr};
  drag_.apply(input, scene_->coupling(), scene_->bodies(), std::span(bodies).first(at(players())), tick_dt);
  if (!make_mover_) {
    for (std::size_t k = 0; k < at(players()); ++k) {
      rules_.act(k, goal_ticks_ ? 0U : pressed[k], *players_[k], *scene_);
    }
    rules_.before(*scene_, tick_dt);
  }
  move_(tick_dt);
  if (!make_mover_) {
    rules_.after(*scene_);
    for (int k = 0; k < players(); ++k) players_[at(k)]->follow_cuts(scene_->coupling());
  }
  ++ticks_;
  ++run_ticks_;
  check_players();
}

/// Applies the buttons of one player. Its line flies to what the pointer aims at, or to what is ahead.
void Simulation::apply(int number, std::uint16_t buttons, unsigned pressed, std::optional<Vec2> pointer) {
  Player& player = *players_[at(number)];
  Targets& targets = seats_[at(number)].targets;
  targets.thrown = aimed_target(*level_, *scene_, player, pointer);
  targets.at_hand = (pressed & button_tie) != 0 ? target_at_hand(*level_, *scene_, player) : std::nullopt;
  targets.shared.reset();
  if (players() == 2) {
    if (const auto held = players_[at(1 - number)]->held_place(scene_->coupling())) targets.shared = held->cord;
  }
  if (goal_ticks_) buttons = buttons_after_goal(player);
  if ((buttons & pressed & button_throw) != 0 && drop_load(player))
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

/// A player that holds no line reels the rope between the two. One that stands still on the ground braces itself.
void Simulation::reel_tether(const engine::TickInput& input) {
  int direction = 0;
  for (int k = 0; k < players(); ++k) {
    const unsigned buttons = goal_ticks_ ? 0U : k == 0 ? input.buttons : input.second_buttons;
    const bool stands_still = ((buttons & button_left) == 0) == ((buttons & button_right) == 0);
    brace(*players_[at(k)], stands_still && player(k).is_on_ground());
    if (player(k).lines().held() != nullptr) continue;
    if ((buttons & button_reel_in) != 0) --direction;
    if ((buttons & button_reel_out) != 0) ++direction;
  }
  tether_->reel(std::clamp(direction, -1, 1), scene_->coupling(), tick_dt);
}

void Simulation::save(SavedTick& saved) const {
  scene_->coupling().save(scene_->world(), saved.cords);
  saved.world.save(scene_->world());
  saved.player = *players_[0];
  if (players_[1]) saved.second = *players_[1];
  saved.tether = tether_;
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
  *players_[0] = *saved.player;
  if (players_[1]) *players_[1] = *saved.second;
  tether_ = saved.tether;
  progress_of(*this) = saved.progress;
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
  tether_.reset();
  players_ = {};
  scene_ = level_->make_scene();
  scene_->coupling().watch(watcher_);
  scene_->coupling().use(parallel_for_);
  make_players();
  move_ = make_mover_ ? make_mover_(*scene_, *players_[0]) : [scene = scene_.get()](double dt) { scene->tick(dt); };
  drag_.forget();
  rules_.start(level_->rules, *scene_);
  checkpoint_.reset();
  for (Seat& seat : seats_) seat = {.buttons_before = seat.buttons_before};
  seats_[0].foothold = level_->player_start;
  if (level_->second) seats_[1].foothold = level_->second->start;
  run_ticks_ = 0;
  falls_ = 0;
  goal_ticks_.reset();
  ++restarts_;
  keeps_changes_ = false;
  save(start_);
  hold_buttons();
  take_snapshot(previous_, *scene_);
  take_snapshot(current_, *scene_);
}

/// Makes the players of a new scene, which do not touch each other, and ties them together if the level says so.
void Simulation::make_players() {
  PlayerTuning tuning;
  tuning.mass = level_->player_mass;
  tuning.grab_range = level_->assists.grab_range.value_or(tuning.grab_range);
  LineTuning line;
  line.accuracy = level_->line_accuracy.value_or(line.accuracy);
  players_[0] = std::make_unique<Player>(scene_->world(), level_->player_start, tuning, at(level_->lines), line);
  if (!level_->second) return;
  tuning.mass = level_->second->mass;
  players_[1] = std::make_unique<Player>(scene_->world(), level_->second->start, tuning, at(level_->lines), line);
  for (const std::unique_ptr<Player>& player : players_) {
    for (b2Fixture* fixture = player->body().GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
      b2Filter filter = fixture->GetFilterData();
      filter.groupIndex = player_group;
      fixture->SetFilterData(filter);
    }
  }
  if (make_mover_) return;
  if (const auto cord = tether_of(*level_, *scene_)) {
    tether_.emplace(*cord, *players_[0], *players_[1], scene_->coupling());
  }
}

/// Releases the loads that hang from the cord that the player holds, unless that is its line. Returns false if there
/// are none.
bool Simulation::drop_load(const Player& player) {
  ribbon::box2d::Coupling& coupling = scene_->coupling();
  const auto held = player.held_place(coupling);
  if (!held || player.lines().held() != nullptr) return false;
  bool dropped = false;
  for (const engine::SceneBody& made : scene_->bodies()) {
    if (made.kind != engine::BodyKind::load) continue;
    const auto hangs = coupling.body(*made.body).held_place();
    if (!hangs || hangs->cord != held->cord) continue;
    dropped = coupling.grip(*coupling.body(*made.body).first_grip()).release() || dropped;  // lines on it stay
  }
  return dropped;
}

/// At the goal the player stops, or goes on holding what it holds.
std::uint16_t Simulation::buttons_after_goal(const Player& player) const {
  const bool holds = player.ledge() || player.held_place(scene_->coupling());
  return holds ? static_cast<std::uint16_t>(button_grab) : std::uint16_t{0};
}

/// Puts the players at the last checkpoint, or at the start. Cords and bodies are as at the start of the level, so that
/// each try meets the same.
void Simulation::put_players_back() {
  if (!make_mover_ && !keeps_changes_) {
    drag_.forget();  // what it holds is free again
    start_.world.restore(scene_->world(), nullptr);
    scene_->coupling().restore(start_.cords, scene_->world());
    *players_[0] = *start_.player;
    if (players_[1]) *players_[1] = *start_.second;
    hold_buttons();
    tether_ = start_.tether;
    rules_.return_to(start_.rules);
    scene_->rides().set_time(start_.ride_time);
    if (tether_ && !checkpoint_)
      return rules_.send_chasers_back();  // all is as it was laid, also the rope between the players
  }
  rules_.send_chasers_back();
  const Vec2 start = level_->player_start;
  if (!checkpoint_) return put_at(start, level_->second ? level_->second->start : start);
  const Area& area = level_->checkpoints[*checkpoint_];
  const Vec2 feet = area.center - Vec2{0.0, 0.5 * area.size.y};
  const Vec2 aside{players() == 2 ? checkpoint_gap : 0.0, 0.0};
  put_at(feet - aside, feet + aside);
}

/// A key that is down since before the players were put back or made anew is no new press.
void Simulation::hold_buttons() {
  for (int k = 0; k < players(); ++k) players_[at(k)]->hold_buttons(seats_[at(k)].buttons_before);
}

void Simulation::put_at(Vec2 first, Vec2 second) {
  players_[0]->put(first, scene_->coupling());
  if (!players_[1]) return;
  players_[1]->put(second, scene_->coupling());
  if (!tether_) return;
  tether_->lay(*players_[0], *players_[1], scene_->coupling());
  rules_.cords_were_put(*scene_);
}

bool Simulation::is_at_flag(int number) const {
  if (!level_->goal) return false;
  const Flag flag = flag_of(*level_->goal);
  return player(number).touches(flag.pole) || player(number).touches(flag.cloth);
}

/// Updates goal, checkpoint and falls after the players have moved. If one falls, both are put back.
void Simulation::check_players() {
  if (!goal_ticks_ && is_at_flag(0) && (players() == 1 || is_at_flag(1))) goal_ticks_ = run_ticks_;
  std::optional<LastFall> fallen;
  for (int k = 0; k < players(); ++k) {
    const Vec2 at = player(k).position();
    std::optional<std::size_t> inside;
    for (std::size_t c = 0; c < level_->checkpoints.size(); ++c) {
      if (level_->checkpoints[c].contains(at)) inside = c;
    }
    // A player that waits in an earlier one does not take it back.
    std::optional<std::size_t>& was_inside = seats_[static_cast<std::size_t>(k)].inside;
    if (inside && inside != was_inside) checkpoint_ = inside;
    was_inside = inside;
    if (level_->assists.no_fall) update_foothold(k);
    const bool dies = !goal_ticks_ && rules_.meet(player(k));
    if (dies || at.y <= -fall_depth) fallen = LastFall{k, dies};
  }
  if (!fallen) return;
  const Vec2 foothold = seats_[at(fallen->player)].foothold;
  if (level_->assists.no_fall) {
    rules_.send_chasers_back();
    return put_at(foothold, foothold);
  }
  ++falls_;
  last_fall_ = *fallen;
  put_players_back();
}

/// Sets the foothold to a position at which the player stood at least foothold_ticks earlier, since the last position
/// is often the edge of a fall.
void Simulation::update_foothold(int number) {
  Seat& seat = seats_[at(number)];
  if (!player(number).is_on_firm_ground()) {
    seat.standing_ticks = 0;
    return;
  }
  if (seat.standing_ticks % foothold_ticks == 0) {
    if (seat.standing_ticks > 0) seat.foothold = seat.next_foothold;
    seat.next_foothold = player(number).position() - Vec2{0.0, 0.5 * player(number).tuning().height};
  }
  ++seat.standing_ticks;
}

void Simulation::compute_hash() {
  ribbon::box2d::Hasher game;
  game.add(ticks_);
  game.add(run_ticks_);
  game.add(falls_);
  game.add(goal_ticks_.value_or(-1));
  game.add(checkpoint_ ? static_cast<int>(*checkpoint_) : -1);
  drag_.add_to(game);
  for (int k = 0; k < players(); ++k) add_to(game, k);
  if (tether_) tether_->add_to(game);
  rules_.add_to(game, *scene_);

  hash_.clear();
  hash_.add(ribbon::box2d::Subsystem::game, 0, game);
  scene_->add_to(hash_);
}

void Simulation::add_to(ribbon::box2d::Hasher& game, int number) const {
  const Player& one = player(number);
  const auto held = one.held_place(scene_->coupling());
  game.add(held ? held->cord : -1);
  game.add(held ? held->point : -1);
  game.add(held ? held->along : 0.0);
  game.add(scene_->coupling().body(one.body()).velocity());
  one.add_to(game);
  if (players() == 2) game.add(static_cast<int>(seats_[at(number)].inside.value_or(level_->checkpoints.size())));
  if (!level_->assists.no_fall) return;
  game.add(seats_[at(number)].foothold);
  game.add(seats_[at(number)].next_foothold);
  game.add(seats_[at(number)].standing_ticks);
}

engine::ReplayHeader Simulation::replay_header(const Level& level) {
  engine::ReplayHeader header;
  header.level = level.name;
  header.level_hash = level.map.content_hash;
  header.tick_rate = ticks_per_second;
  header.players = level.players();
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
