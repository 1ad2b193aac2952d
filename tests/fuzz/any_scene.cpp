// Random scenes by seed, family and difficulty, with a few numbers changed. Each scene plays or is refused; cords and
// bodies stay finite.

#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/extremes/any_scene/generate.h"
#include "tests/extremes/any_scene/play.h"
#include "tests/fuzz/bytes.h"
#include "tests/fuzz/require.h"

namespace {

using any_scene::Scene;
using fuzz::Bytes;

constexpr int max_ticks = 16;
constexpr double max_seconds = 2.0;
constexpr int max_changes = 4;

any_scene::SceneId arbitrary_id(Bytes& bytes) {
  any_scene::SceneId which;
  which.family = any_scene::all_families[static_cast<std::size_t>(bytes.below(any_scene::all_families.size()))];
  which.difficulty = bytes.boolean() ? any_scene::Difficulty::wild : any_scene::Difficulty::gentle;
  which.seed = bytes.byte();
  which.seed = 256U * which.seed + bytes.byte();
  return which;
}

template <typename Part>
Part* some(std::vector<Part>& parts, Bytes& bytes) {
  const std::size_t choice = bytes.byte();
  return parts.empty() ? nullptr : &parts[choice % parts.size()];
}

void change_cord(Bytes& bytes, any_scene::SceneCord& cord) {
  ribbon::CordDef& def = cord.def;
  switch (bytes.below(8)) {
    case 0: cord.velocity = bytes.vector(-100.0, 100.0); break;
    case 1: def.mass_per_length = bytes.number(0.01, 100.0); break;
    case 2: def.stretch_stiffness = bytes.number(1e2, 1e7); break;
    case 3: def.bending_stiffness = bytes.number(1e-3, 1e2); break;
    case 4: def.radius = bytes.number(0.001, 0.1); break;
    case 5: def.damping = bytes.number(1e-3, 1.0); break;
    case 6: def.self_contact = def.cord_contact = bytes.boolean(); break;
    default: def.pins = {bytes.below(def.points * def.rows)};
  }
}

void change_wheel(Bytes& bytes, ribbon::PulleyDef& def) {
  switch (bytes.below(3)) {
    case 0: def.inertia = bytes.number(1e-6, 10.0); break;
    case 1: def.friction = bytes.number(1e-3, 10.0); break;
    default: def.motor_speed = bytes.number(-100.0, 100.0); def.motor_torque = bytes.number(0.1, 1e3);
  }
}

void change(Bytes& bytes, Scene& scene) {
  switch (bytes.below(5)) {
    case 0:
      if (any_scene::Solid* solid = some(scene.solids, bytes)) solid->density = bytes.below(200) + 0.5;
      break;
    case 1:
      if (any_scene::Hold* hold = some(scene.holds, bytes)) hold->strength = bytes.number(0.1, 1e3);
      break;
    case 2:
      if (any_scene::Wheel* wheel = some(scene.wheels, bytes)) change_wheel(bytes, wheel->def);
      break;
    default:
      if (any_scene::SceneCord* cord = some(scene.cords, bytes)) change_cord(bytes, *cord);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  Scene scene = generate(arbitrary_id(bytes));
  scene.ticks = 1 + bytes.below(max_ticks);
  for (int k = bytes.below(max_changes + 1); k > 0 && !bytes.empty(); --k) change(bytes, scene);
  const any_scene::Outcome outcome = play(scene, max_seconds);
  fuzz::require(outcome.end != any_scene::End::broken, "positions of cords and bodies are finite");
  fuzz::require(outcome.end != any_scene::End::refused || outcome.message.find("accepted") != std::string::npos,
                "the message says what is accepted", outcome.message);
  return 0;
}
