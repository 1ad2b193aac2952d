#include "tests/study/level_grid.h"

#include <algorithm>
#include <map>

namespace study {

LevelGrid grid_of(const StudyOptions& options, const LevelFile& file, bool chains) {
  LevelGrid grid;
  std::map<std::string, std::string> left_out;  // settings by reason
  for (const Setting& setting : options.grid.empty() ? study::grid(options.quick) : options.grid) {
    if (is_box2d(setting) && !chains) continue;
    const std::string reason = file.left_out_reason(setting);
    if (reason.empty()) {
      grid.settings.push_back(setting);
      continue;
    }
    std::string& names = left_out[reason];
    if (!names.empty()) names += ", ";
    names.append(setting.solver).append(" ").append(name_of(setting));
  }
  for (const auto& [reason, names] : left_out) grid.left_out.push_back(std::string(names).append(": ").append(reason));
  return grid;
}

std::vector<Mesh> meshes_of(const std::vector<Setting>& grid) {
  std::vector<Mesh> meshes;
  for (const Setting& setting : grid) {
    if (std::find(meshes.begin(), meshes.end(), mesh_of(setting)) == meshes.end()) meshes.push_back(mesh_of(setting));
  }
  return meshes;
}

double work_of(const Setting& setting) {
  if (is_box2d(setting)) return 1.0 + 0.1 * setting.substeps * setting.iterations;
  return setting.points * (1.0 + 0.7 * setting.substeps) * (setting.rows > 1 ? 3.0 * setting.rows : 1.0);
}

}  // namespace study
