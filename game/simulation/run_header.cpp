#include "game/simulation/run_header.h"

#include <string>
#include <utility>
#include <variant>

#include "engine/scene/scene.h"
#include "game/simulation/simulation.h"

namespace game {
namespace {

constexpr double max_grab_range = 10.0;  // m, accepted in a replay
constexpr const char* grab_range_setting = "player_reach";
constexpr const char* no_fall_setting = "no_fall";
constexpr const char* yard_setting = "yard";
constexpr double no_fall_value = 1.0;  // of no_fall_setting

}  // namespace

engine::ReplayHeader replay_header(const Level& level) {
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
  if (std::string yard = yard_text(level.yard); !yard.empty()) header.settings[yard_setting] = std::move(yard);
  return header;
}

void take_settings(Level& level, const engine::ReplayHeader& header) {
  const auto declared = [&header](const char* setting) {
    const auto found = header.settings.find(setting);
    const double* value = found == header.settings.end() ? nullptr : std::get_if<double>(&found->second);
    return value != nullptr ? std::optional(*value) : std::nullopt;
  };
  const auto range = declared(grab_range_setting);
  level.assists.grab_range = range && *range > 0.0 && *range <= max_grab_range ? range : std::nullopt;
  level.assists.no_fall = declared(no_fall_setting) == no_fall_value;
  const auto placed = header.settings.find(yard_setting);
  const std::string* text = placed == header.settings.end() ? nullptr : std::get_if<std::string>(&placed->second);
  set_yard(level, text != nullptr ? yard_of(*text, level).value_or(Yard{}) : Yard{});
}

}  // namespace game
