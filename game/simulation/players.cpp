#include "game/simulation/players.h"

#include <algorithm>

#include "game/simulation/buttons.h"
#include "game/simulation/index.h"

namespace game {
namespace {

using ribbon::Vec2;

constexpr int foothold_ticks = 15;         // of standing, after which a position becomes the foothold
constexpr std::int16_t player_group = -1;  // of Box2D: two players do not touch each other

}  // namespace

void Players::make(const Level& level, engine::Scene& scene, bool tied) {
  PlayerTuning tuning;
  tuning.mass = level.player_mass;
  tuning.grab_range = level.assists.grab_range.value_or(tuning.grab_range);
  LineTuning line;
  line.accuracy = level.line_accuracy.value_or(line.accuracy);
  for (Seat& seat : seats_) seat = {.buttons_before = seat.buttons_before};
  seats_[0].foothold = level.player_start;
  all_[0] = std::make_unique<Player>(scene.world(), level.player_start, tuning, at(level.lines), line);
  if (!level.second) return;
  tuning.mass = level.second->mass;
  seats_[1].foothold = level.second->start;
  all_[1] = std::make_unique<Player>(scene.world(), level.second->start, tuning, at(level.lines), line);
  for (const std::unique_ptr<Player>& player : all_) {
    for (b2Fixture* fixture = player->body().GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
      b2Filter filter = fixture->GetFilterData();
      filter.groupIndex = player_group;
      fixture->SetFilterData(filter);
    }
  }
  if (!tied) return;
  if (const auto cord = tether_of(level, scene)) tether_.emplace(*cord, *all_[0], *all_[1], scene.coupling());
}

void Players::clear() {
  tether_.reset();
  all_ = {};
}

std::optional<ribbon::box2d::CordId> Players::held_by_other(int number, const engine::Scene& scene) const {
  if (count() == 1) return std::nullopt;
  const auto held = (*this)[1 - number].held_place(scene.coupling());
  return held ? std::optional(held->cord) : std::nullopt;
}

std::array<unsigned, 2> Players::press(const ButtonsOfBoth& buttons) {
  std::array<unsigned, 2> pressed{};
  for (std::size_t k = 0; k < seats_.size(); ++k) {
    pressed[k] = buttons[k] & ~static_cast<unsigned>(seats_[k].buttons_before);
    seats_[k].buttons_before = buttons[k];
  }
  return pressed;
}

void Players::hold_buttons() {
  for (int k = 0; k < count(); ++k) (*this)[k].hold_buttons(seats_[at(k)].buttons_before);
}

void Players::reel_tether(const ButtonsOfBoth& buttons, engine::Scene& scene, double dt) {
  if (!tether_) return;
  int direction = 0;
  for (int k = 0; k < count(); ++k) {
    const unsigned own = buttons[at(k)];
    Player& player = (*this)[k];
    const bool stands_still = ((own & button_left) == 0) == ((own & button_right) == 0);
    brace(player, stands_still && player.is_on_ground());
    if (player.lines().held() != nullptr) continue;
    if ((own & button_reel_in) != 0) --direction;
    if ((own & button_reel_out) != 0) ++direction;
  }
  tether_->reel(std::clamp(direction, -1, 1), scene.coupling(), dt);
}

bool Players::put_at(Vec2 first, Vec2 second, engine::Scene& scene) {
  all_[0]->put(first, scene.coupling());
  if (!all_[1]) return false;
  all_[1]->put(second, scene.coupling());
  if (!tether_) return false;
  tether_->lay(*all_[0], *all_[1], scene.coupling());
  return true;
}

void Players::update_foothold(int number) {
  Seat& seat = seats_[at(number)];
  const Player& player = (*this)[number];
  if (!player.is_on_firm_ground()) {
    seat.standing_ticks = 0;
    return;
  }
  if (seat.standing_ticks % foothold_ticks == 0) {
    if (seat.standing_ticks > 0) seat.foothold = seat.next_foothold;
    seat.next_foothold = player.position() - Vec2{0.0, 0.5 * player.tuning().height};
  }
  ++seat.standing_ticks;
}

void Players::save(State& state) const {
  state.first = *all_[0];
  if (all_[1]) state.second = *all_[1];
  state.tether = tether_;
  state.seats = seats_;
}

void Players::restore(const State& state) {
  put_back(state);
  seats_ = state.seats;
}

void Players::put_back(const State& state) {
  *all_[0] = *state.first;
  if (all_[1]) *all_[1] = *state.second;
  tether_ = state.tether;
}

void Players::add_to(ribbon::box2d::Hasher& hasher, int number, const Level& level, const engine::Scene& scene) const {
  const Player& one = (*this)[number];
  const Seat& seat = seats_[at(number)];
  const auto held = one.held_place(scene.coupling());
  hasher.add(held ? held->cord : -1);
  hasher.add(held ? held->point : -1);
  hasher.add(held ? held->along : 0.0);
  hasher.add(scene.coupling().body(one.body()).velocity());
  one.add_to(hasher);
  if (count() == 2) hasher.add(static_cast<int>(seat.inside.value_or(level.checkpoints.size())));
  if (!level.assists.no_fall) return;
  hasher.add(seat.foothold);
  hasher.add(seat.next_foothold);
  hasher.add(seat.standing_ticks);
}

}  // namespace game
