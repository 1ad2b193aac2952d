#include "tests/flight/replay.h"

#include <algorithm>

namespace flight {

Replay::Replay(const engine::SolverStep& step) : step_(step), bodies_(step.bodies), reports_(step.cords.size()) {
  cords_.reserve(step.cords.size());
  media_.reserve(step.media.size());
  for (const ribbon::WeatherDef& medium : step.media) media_.emplace_back(medium);
  for (const engine::SolverStep::Cord& cord : step.cords) {
    cords_.emplace_back(cord.def);
    cords_.back().restore(cord.state);
    const ribbon::Medium* const medium = cord.medium < 0 ? nullptr : &media_[static_cast<std::size_t>(cord.medium)];
    island_cords_.push_back(
        {&cords_.back(),
         {bodies_, cord.circles, cord.grips, cord.segments, cord.axles, medium, cord.time, cord.supports},
         cord.id});
  }
}

void Replay::reset() {
  std::copy(step_.bodies.begin(), step_.bodies.end(), bodies_.begin());
  for (std::size_t k = 0; k < cords_.size(); ++k) cords_[k].restore(step_.cords[k].state);
}

void Replay::run() { solver_.step(island_cords_, bodies_, step_.dt, step_.gravity, reports_, step_.ties); }

bool Replay::is_as_recorded() const {
  const engine::SolverStep::Outcome& outcome = step_.outcome;
  return total().work == outcome.work && total().unconverged == outcome.unconverged && hash() == outcome.positions;
}

}  // namespace flight
