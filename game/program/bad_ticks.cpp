#include "game/program/bad_ticks.h"

#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace game {
namespace {

constexpr int max_files = 20;  // per run: a diverged cord is bad in every tick

}  // namespace

std::unique_ptr<engine::FlightRecorder> bad_tick_recorder(const RunOptions& options) {
  if (options.record_bad_ticks.empty()) return nullptr;
  std::error_code error;
  std::filesystem::create_directories(options.record_bad_ticks, error);
  if (error) {
    throw std::runtime_error("--record-bad-ticks " + options.record_bad_ticks + ": " + error.message() +
                             "; accepted is a folder, or a place to make one");
  }
  engine::FlightConditions conditions;
  conditions.max_work = options.bad_work;
  conditions.unconverged = true;
  conditions.not_finite = true;
  return std::make_unique<engine::FlightRecorder>(conditions, options.record_bad_ticks + "/", max_files);
}

std::string bad_ticks_line(const engine::FlightRecorder& recorder, const RunOptions& options) {
  std::string line = std::to_string(recorder.written()) + " bad ticks written to " + options.record_bad_ticks;
  if (!recorder.failure().empty()) line += "; no more, for " + recorder.failure();
  return line;
}

}  // namespace game
