#pragma once

#include <memory>
#include <string>

#include "engine/replay/flight_recorder.h"
#include "game/simulation/run.h"

namespace game {

/// The recorder that the options ask for, of ticks whose cords did not converge, are no numbers, or took more than the
/// work that is given; null if they ask for none. Makes its folder. Throws std::runtime_error if that cannot be.
std::unique_ptr<engine::FlightRecorder> bad_tick_recorder(const RunOptions& options);

/// What to say of it at the end: how many it has written, and what it could not.
std::string bad_ticks_line(const engine::FlightRecorder& recorder, const RunOptions& options);

}  // namespace game
