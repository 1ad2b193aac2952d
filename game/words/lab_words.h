#pragma once

/// The texts of the lab. A name in braces is replaced by `filled`.
namespace game::words::lab {

inline constexpr const char* title = "The lab";
inline constexpr const char* keys = "↑ ↓ choose  ← → change";
inline constexpr const char* buttons = "D-pad: choose, change";

/// The title of a scene, and what it shows.
struct SceneWords {
  const char* name;  ///< of the scene, as in links
  const char* title;
  const char* about;
};
inline constexpr SceneWords scenes[] = {
    {"heavy_load", "Heavy load",
     "A cord of 1 kg carries up to a thousand tonnes and keeps its length. Beside it hangs Box2D's chain of the same "
     "links."},
    {"capstan", "Capstan",
     "Friction around a post holds a heavy weight by a light one, up to a ratio of e^(μ·angle). Beyond it the cord "
     "slips."},
    {"pile", "Pile", "Ropes and ribbons fall on each other and come to rest."},
    {"strips", "Strips", "Ribbons of rubber fall through a lattice of pegs."},
    {"buckling", "Buckling",
     "Clamped columns, each under a load. Those above the exact critical load bend away, those below stay straight."},
    {"bridge", "Bridge", "A ball drops on a cord between two pins, and on Box2D's chain of the same links."},
    {"lamps", "A thousand lamps",
     "Each hangs on a rope of its own. What has come to rest falls asleep and costs little until you touch it."},
    {"thesis_a", "Thesis, A", "Goto 2017, condition A: 25 × 2 points, 8 iterations, with self-collision."},
    {"thesis_b", "Thesis, B", "Goto 2017, condition B: 10 × 5 points, 8 iterations, with self-collision."},
    {"thesis_c", "Thesis, C", "Goto 2017, condition C: 35 × 2 points, 8 iterations, with self-collision."},
    {"thesis_d", "Thesis, D", "Goto 2017, condition D: 35 × 2 points, 4 iterations, with self-collision."},
};

// The names of the sliders
inline constexpr const char* load_ratio = "load : cord";
inline constexpr const char* weight_ratio = "heavy : light weight";
inline constexpr const char* start_angle = "angle at the start";
inline constexpr const char* turns = "more turns";
inline constexpr const char* count = "number";
inline constexpr const char* load_share = "load / critical load";
inline constexpr const char* may_sleep = "sleep at rest";
inline constexpr const char* chain_substeps = "substeps of Box2D";
inline constexpr const char* preset = "preset";
inline constexpr const char* substeps = "substeps";
inline constexpr const char* tolerance = "tolerance";
inline constexpr const char* stretch = "EA";
inline constexpr const char* bending = "EI";
inline constexpr const char* friction = "friction";
inline constexpr const char* spring_share = "spring coefficient k";
inline constexpr const char* iterations = "iterations N";
inline constexpr const char* bar_damping = "damping of bars β";
inline constexpr const char* area = "area correction";
inline constexpr const char* self_collision = "self-collision";
inline constexpr const char* air_drag = "drag of the air";

// Their values
inline constexpr const char* substeps_value = "{number}; 1 for {cords} in a heap";
inline constexpr const char* ratio_value = "{number} : 1";
inline constexpr const char* times_value = "{number} ×";
inline constexpr const char* degrees_value = "{number}°";
inline constexpr const char* millimetres_value = "{number} mm";
inline constexpr const char* metres_value = "{number} m";
inline constexpr const char* newtons_value = "{number} N";
inline constexpr const char* stiffness_value = "{number} N·m²";
inline constexpr const char* rate_value = "{number} /s";
inline constexpr const char* joules_value = "{number} J";
inline constexpr const char* kilojoules_value = "{number} kJ";
inline constexpr const char* megajoules_value = "{number} MJ";
inline constexpr const char* inextensible = "does not stretch";

// The buttons
inline constexpr const char* pause = "Pause";
inline constexpr const char* go_on = "Go on";
inline constexpr const char* step = "Step";
inline constexpr const char* slow = "Slow 1/{factor}";
inline constexpr const char* full_speed = "Slow";
inline constexpr const char* restart = "Restart";
inline constexpr const char* back = "Back";

// The figures
inline constexpr const char* of_cords = "This library";
inline constexpr const char* of_chains = "Box2D's chain";
inline constexpr const char* of_thesis = "The thesis's method";
inline constexpr const char* bench_figures = "{bench}: {median} µs a tick, at most {worst}; stretched by {stretch} %";
inline constexpr const char* excess = "{length} too long";
inline constexpr const char* power = "{number}·10{exponent}";
inline constexpr const char* pull_ratio = "pulls {number} : 1";
inline constexpr const char* holding_limit = "holds up to {number} : 1";
inline constexpr const char* critical_load = "critical load {number} N";
inline constexpr const char* awake = "{number} awake";
inline constexpr const char* contacts = "{number} contacts";
inline constexpr const char* unconverged = "{number} substeps did not converge";
inline constexpr const char* self_contacts = "{number} contacts with itself";
inline constexpr const char* turned_over = "{number} triangles inside out";
inline constexpr const char* between_figures = ", ";

// The plots
inline constexpr const char* energy_plot = "energy since the start";
inline constexpr const char* stretch_plot = "stretch, %";
inline constexpr const char* plot_time = "last 8 s";

}  // namespace game::words::lab
