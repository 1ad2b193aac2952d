#pragma once

/// The texts of the tuning panel. Formats are those of std::printf, as Dear ImGui takes them.
namespace game::words::panel {

inline constexpr const char* title = "Ropes and parameters (F2)";
inline constexpr const char* replay = "This is a replay: parameters cannot be changed.";
inline constexpr const char* last_seconds = "The last ten seconds with";
inline constexpr const char* fast = "fast";
inline constexpr const char* balanced = "balanced";
inline constexpr const char* accurate = "accurate";
inline constexpr const char* not_repeated =
    "This run cannot be repeated: parameters or the level were changed in it. Restart the level.";
inline constexpr const char* changed = "Parameters changed: no medal, no best time, no recording.";
inline constexpr const char* restart = "Restart with these values";
inline constexpr const char* reset = "Reset to the file";
inline constexpr const char* write = "Write to the level";
inline constexpr const char* ask_overwrite = "Overwrite?";
inline constexpr const char* will_overwrite =
    "The changed values are written to %s.\nEverything else in the file stays.";
inline constexpr const char* overwrite = "Overwrite";
inline constexpr const char* cancel = "Cancel";
inline constexpr const char* written = "written";
inline constexpr const char* world = "World";
inline constexpr const char* gravity = "gravity_y [m/s²]";
inline constexpr const char* player = "Player";
inline constexpr const char* run_speed = "run speed [m/s]";
inline constexpr const char* ground_gain = "gain on the ground [m/s²]";
inline constexpr const char* air_gain = "gain in the air [m/s²]";
inline constexpr const char* jump_speed = "jump speed [m/s]";
inline constexpr const char* pump = "pump [m/s²]";
inline constexpr const char* reach = "reach [m]";
inline constexpr const char* climb_speed = "climb speed [m/s]";
inline constexpr const char* hop_speed = "hop speed [m/s]";
inline constexpr const char* own_line = "The player's own line is not part of a level.";
inline constexpr const char* placed = "A placed thing has no parameters in the file of the level.";
inline constexpr const char* integrator = "integrator";
inline constexpr const char* is_off = "%s: off";
inline constexpr const char* cord = "cord {number}{name} ({solver})";
inline constexpr const char* tick_cost = "a tick: %.0f µs, at most %.0f µs in the last second (of 16667)";
inline constexpr const char* frame_figures = "ms a frame, last second: mean, worst";
inline constexpr const char* physics = "physics %.2f, %.2f";
inline constexpr const char* drawing = "drawing %.2f, %.2f";
inline constexpr const char* whole = "whole frame %.2f, %.2f (of 16.67)";
inline constexpr const char* points = "points (F3):";
inline constexpr const char* free = "free";
inline constexpr const char* dragged = "dragged";
inline constexpr const char* constrained = "constrained";
inline constexpr const char* cords = "cords: %d in %d islands, %d circles and edges near them";
inline constexpr const char* bodies = "Box2D: %d bodies, %d contacts, %d proxies in a tree %d high";
inline constexpr const char* columns[] = {"cord",          "points",  "contacts",  "tension N",   "inverted",
                                          "Newton/solves", "impacts", "fallbacks", "unconverged", "peak stretch"};

}  // namespace game::words::panel
