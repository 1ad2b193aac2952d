#include "game/lab/scene.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "game/lab/scene_list.h"

namespace game::lab {
namespace {

ribbon::Accuracy preset_of(const KnobValues& values) {
  switch (values.whole(Knob::preset)) {
    case 0: return ribbon::Accuracy::fast();
    case 2: return ribbon::Accuracy::accurate();
    default: return ribbon::Accuracy::balanced();
  }
}

}  // namespace

std::span<const Scene> scenes() {
  static const std::vector<Scene> all = {heavy_load(), capstan(),  pile(),     strips(),   buckling(), bridge(),
                                         lamps(),      thesis_a(), thesis_b(), thesis_c(), thesis_d()};
  return all;
}

const Scene& scene_named(std::string_view name) {
  const std::span<const Scene> all = scenes();
  const auto found = std::find_if(all.begin(), all.end(), [name](const Scene& scene) { return scene.name == name; });
  if (found != all.end()) return *found;
  std::string names;
  for (const Scene& scene : all) names.append(names.empty() ? "" : ", ").append(scene.name);
  throw std::runtime_error("the lab has no scene '" + std::string(name) + "'; accepted are " + names);
}

KnobValues initial_values(const Scene& scene) {
  KnobValues values;
  for (const KnobRange& range : scene.knobs) values[range.knob] = range.initial;
  return values;
}

const KnobRange* range_of(const Scene& scene, Knob knob) {
  const auto found =
      std::find_if(scene.knobs.begin(), scene.knobs.end(), [knob](const KnobRange& r) { return r.knob == knob; });
  return found == scene.knobs.end() ? nullptr : &*found;
}

ribbon::Accuracy accuracy_of(const KnobValues& values) {
  ribbon::Accuracy accuracy = preset_of(values);
  accuracy.substeps = values.whole(Knob::substeps);
  accuracy.tolerance = values[Knob::tolerance];
  return accuracy;
}

void follow_preset(KnobValues& values) {
  const ribbon::Accuracy preset = preset_of(values);
  values[Knob::substeps] = preset.substeps;
  values[Knob::tolerance] = preset.tolerance;
}

}  // namespace game::lab
