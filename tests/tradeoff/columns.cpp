#include <array>
#include <cstdio>

#include "tests/tradeoff/scenes.h"

namespace tradeoff {

Column us_per_tick() {
  return {"us_per_tick", 3, [](const Row& row) { return row.timing.median_us; }};
}

Column p99_us() {
  return {"p99_us", 3, [](const Row& row) { return row.timing.p99_us; }};
}

Column frames_per_second() {
  return {"frames_per_second", 1, [](const Row& row) { return 1e6 / row.timing.median_us; }};
}

Column cords_us() {
  return {"cords_us", 1, [](const Row& row) { return row.timing.share_us; }};
}

Column cords_max_us() {
  return {"cords_max_us", 1, [](const Row& row) { return row.timing.worst_us; }};
}

Column world_step_us() {
  return {"world_step_us", 1, [](const Row& row) { return row.timing.rest_us; }};
}

Column figure(std::string name, std::size_t index) {
  return {std::move(name), -1, [index](const Row& row) { return row.figures[index]; }};
}

std::string number(double value) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%g", value);
  return buffer.data();
}

}  // namespace tradeoff
