#include "tests/tradeoff/scenes.h"

#include <algorithm>

#include "tests/tradeoff/scene_lists.h"

namespace tradeoff {

const std::vector<Scene>& scenes() {
  static const std::vector<Scene> all = [] {
    std::vector<Scene> together;
    for (const auto& list :
         {thesis_scenes(), swing_scenes(), reference_scenes(), cost_scenes(), lamp_scenes(), scale_scenes(),
          tie_scenes(), pulley_scenes(), wind_scenes(), guide_scenes(), back_scenes(), contact_scenes()}) {
      together.insert(together.end(), list.begin(), list.end());
    }
    return together;
  }();
  return all;
}

const Scene* find_scene(const std::string& name) {
  const auto found = std::find_if(scenes().begin(), scenes().end(), [&](const Scene& s) { return s.name == name; });
  return found == scenes().end() ? nullptr : &*found;
}

}  // namespace tradeoff
