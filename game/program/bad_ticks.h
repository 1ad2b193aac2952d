#pragma once

#include <memory>
#include <string>

#include "engine/replay/flight_recorder.h"
#include "game/simulation/run.h"

namespace game {

/// Returns a recorder of ticks whose cords did not converge, are not finite, or took more work than the options allow;
/// null unless requested. Makes its folder. Throws std::runtime_error if that fails.
std::unique_ptr<engine::FlightRecorder> bad_tick_recorder(const RunOptions& options);

/// Returns the last line of output about it: the number of files and any failure.
std::string bad_ticks_line(const engine::FlightRecorder& recorder, const RunOptions& options);

}  // namespace game
