#include "tests/tradeoff/scenes_contact.h"

#include "tests/tradeoff/scene_lists.h"

namespace tradeoff {

std::vector<Scene> contact_scenes() {
  return {mass_ratio_scene(), drape_scene(),          bridge_scene(), capstan_scene(),    cords_and_circles_scene(),
          coil_scene(),       tightened_coil_scene(), strips_scene(), short_coil_scene(), short_strips_scene()};
}

}  // namespace tradeoff
