#include "game/tuning/last_seconds.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/window/sdl_window.h"
#include "game/words/panel_words.h"

namespace game {
namespace {

/// Runs a tick and measures it.
void timed_tick(Simulation& simulation, const engine::TickInput& input, Meter& meter) {
  const std::int64_t start = engine::now_ns();
  simulation.tick(input);
  meter.add(simulation, engine::now_ns() - start);
}

}  // namespace

std::span<const Preset> presets() {
  static const std::array all = {Preset{words::panel::fast, ribbon::Accuracy::fast()},
                                 Preset{words::panel::balanced, ribbon::Accuracy::balanced()},
                                 Preset{words::panel::accurate, ribbon::Accuracy::accurate()}};
  return all;
}

LastSeconds::LastSeconds(Level level, std::vector<engine::TickInput> inputs, const ribbon::Accuracy& accuracy)
    : level_(std::move(level)),
      inputs_(std::move(inputs)),
      accuracy_(accuracy),
      first_(inputs_.size() - std::min(inputs_.size(), static_cast<std::size_t>(max_ticks))) {
  make_runs();
}

void LastSeconds::make_runs() {
  played_.emplace(level_);
  other_.emplace(level_);
  next_ = 0;
}

bool LastSeconds::approach(int ticks) {
  for (; ticks > 0 && next_ < first_; --ticks, ++next_) {
    for (Simulation* const run : {&*played_, &*other_}) {
      if (next_ + 2 < first_) {
        run->skip(inputs_[next_]);
      } else {
        run->tick(inputs_[next_]);
      }
    }
  }
  return next_ >= first_;
}

double LastSeconds::progress() const {
  return first_ == 0 ? 1.0 : static_cast<double>(std::min(next_, first_)) / static_cast<double>(first_);
}

void LastSeconds::tick() {
  const engine::TickInput& input = inputs_[next_++];
  set_accuracy();
  timed_tick(*played_, input, played_meter_);
  timed_tick(*other_, input, other_meter_);
  find_gap();
}

/// Before each tick: a restart makes new cords, and a throw a new line.
void LastSeconds::set_accuracy() {
  ribbon::box2d::Coupling& coupling = other_->scene().coupling();
  for (const ribbon::box2d::CordId id : coupling.cords()) {
    const ribbon::box2d::CordRef cord = coupling.cord(id);
    if (cord.solver() != ribbon::box2d::Solver::direct || cord.direct().def().accuracy == accuracy_) continue;
    cord.direct().set_accuracy(accuracy_);
  }
}

void LastSeconds::find_gap() {
  gap_.reset();
  const auto add = [this](ribbon::Vec2 played, ribbon::Vec2 other) {
    const Gap gap{played, other, static_cast<int>(next_ - first_)};
    if (!gap_ || gap.size() > gap_->size()) gap_ = gap;
  };
  const auto& cords = played_->current().cords;
  const auto& others = other_->current().cords;
  for (std::size_t id = 0; id < std::min(cords.size(), others.size()); ++id) {
    if (cords[id].size() != others[id].size()) continue;  // one is gone, or another one
    for (std::size_t p = 0; p < cords[id].size(); ++p) add(cords[id][p], others[id][p]);
  }
  for (int k = 0; k < played_->players(); ++k) add(played_->player(k).position(), other_->player(k).position());
  if (!largest_gap_ || gap_->size() > largest_gap_->size()) largest_gap_ = gap_;
}

/// A state that is saved and restored would go on a little differently (see ribbon::box2d::WorldSnapshot), and in these
/// runs a little becomes metres.
void LastSeconds::rewind() {
  gap_.reset();
  make_runs();
}

}  // namespace game
