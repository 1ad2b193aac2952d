#include "engine/replay/flight_recorder.h"

#include <exception>
#include <utility>

#include "engine/files/ranges.h"
#include "engine/replay/cord_extremes.h"

namespace engine {
namespace {

constexpr const char* no_memory = "no memory";  // short enough for std::string to store it without an allocation

std::string more_than(const char* what, double found, double accepted) {
  return what + number_in_words(found) + ", above " + number_in_words(accepted);
}

}  // namespace

FlightRecorder::FlightRecorder(const FlightConditions& conditions, std::string prefix, int max_files)
    : conditions_(conditions), prefix_(std::move(prefix)), max_files_(max_files) {}

void FlightRecorder::before(const ribbon::box2d::SolverInput& input) noexcept {
  has_step_ = false;
  if (!is_armed() || input.cords.empty()) return;
  try {
    capture(input, step_);
    has_step_ = true;
  } catch (const std::exception&) {
    fail(no_memory);
  }
}

void FlightRecorder::after(const ribbon::box2d::SolverInput& input, std::span<const ribbon::IslandReport> /*reports*/,
                           const ribbon::IslandReport& total) noexcept {
  if (!has_step_) return;
  has_step_ = false;
  try {
    std::string why = reason(input, total);
    if (why.empty()) return;
    step_.outcome = {std::move(why), total.work, total.unconverged, hash_of_positions(input.cords)};
    write();
  } catch (const std::bad_alloc&) {
    fail(no_memory);
  } catch (const std::exception& error) {
    fail(error.what());
  }
}

/// Returns the first condition that holds, in words; empty if none does.
std::string FlightRecorder::reason(const ribbon::box2d::SolverInput& input, const ribbon::IslandReport& total) const {
  if (conditions_.unconverged && total.unconverged > 0) {
    return "unconverged substeps: " + std::to_string(total.unconverged);
  }
  if (conditions_.max_work && total.work > *conditions_.max_work) {
    return "work " + std::to_string(total.work) + ", above " + std::to_string(*conditions_.max_work);
  }
  for (const ribbon::IslandCord& cord : input.cords) {
    if (conditions_.not_finite && !is_finite(*cord.cord)) return "a position or velocity is no number";
    if (conditions_.max_speed && largest_speed(*cord.cord) > *conditions_.max_speed) {
      return more_than("speed ", largest_speed(*cord.cord), *conditions_.max_speed);
    }
    if (conditions_.max_stretch && largest_stretch(*cord.cord) > *conditions_.max_stretch) {
      return more_than("stretch ", largest_stretch(*cord.cord), *conditions_.max_stretch);
    }
  }
  return {};
}

void FlightRecorder::write() {
  check(step_);
  std::string path;
  do {
    path = prefix_ + std::to_string(++number_) + ".json";
  } while (!save_solver_step(step_, path, true));
  ++written_;
  last_file_ = path;
}

void FlightRecorder::fail(const char* sentence) noexcept {
  try {
    failure_ = sentence;
  } catch (const std::exception&) {
    failure_ = no_memory;
  }
}

}  // namespace engine
