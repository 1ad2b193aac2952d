#include "tests/baseline/count.h"

#include <algorithm>
#include <stdexcept>

#include "game/simulation/level.h"
#include "game/simulation/recorded_run.h"

namespace baseline {
namespace {

void add_tick(Row& row, std::int64_t work) {
  ++row.ticks;
  row.work += work;
  row.worst_tick = std::max(row.worst_tick, work);
}

/// Prepares a variant. One that continues from its figures computes them first.
void begin(const tradeoff::Variant& variant) {
  if (variant.reset) {
    variant.reset();
  } else {
    variant.figures();
  }
}

std::vector<std::filesystem::path> recorded_runs() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(game::assets_folder() + "/replays")) {
    if (entry.path().extension() == ".replay") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

int points(const ribbon::box2d::Coupling& coupling) {
  int sum = 0;
  for (int c = 0; c < coupling.size(); ++c) sum += static_cast<int>(coupling.cord(c).positions().size());
  return sum;
}

}  // namespace

std::vector<Row> count(const tradeoff::Scene& scene) {
  const int ticks = scene.counted_ticks > 0 ? scene.counted_ticks : scene.ticks;
  std::vector<Row> rows;
  for (const tradeoff::Variant& variant : scene.variants()) {
    if (!variant.work) continue;
    const std::string behind = variant.group.empty() ? "" : (variant.setting.empty() ? "" : " ") + variant.group;
    Row row{scene.name, variant.method, variant.setting + behind, variant.points};
    const auto has_its_name = [&](const Row& other) { return name(other) == name(row); };
    if (std::any_of(rows.begin(), rows.end(), has_its_name)) continue;
    begin(variant);
    while (row.ticks < ticks) {
      variant.tick();
      add_tick(row, variant.work());
      if (variant.rest) variant.rest();
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

Row count_run(const std::filesystem::path& replay) {
  game::RunOptions options;
  options.replay = replay.string();
  options.verify = true;
  game::RecordedRun run(options);
  Row row{replay.stem().string(), "recorded run", "", points(run.simulation().scene().coupling())};
  while (!run.is_over()) {
    run.tick({});
    add_tick(row, run.simulation().scene().coupling().last_step().report().work);
  }
  if (run.exit_status() != 0) throw std::runtime_error(replay.string() + ": " + run.closing_line());
  return row;
}

std::vector<Row> count_all(const std::vector<tradeoff::Scene>& scenes, const std::function<void(double)>& progress) {
  const std::vector<std::filesystem::path> replays = recorded_runs();
  const auto all = static_cast<double>(scenes.size() + replays.size());
  double done = 0.0;
  std::vector<Row> rows;
  for (const tradeoff::Scene& scene : scenes) {
    const std::vector<Row> more = count(scene);
    rows.insert(rows.end(), more.begin(), more.end());
    progress(++done / all);
  }
  for (const std::filesystem::path& replay : replays) {
    rows.push_back(count_run(replay));
    progress(++done / all);
  }
  return rows;
}

}  // namespace baseline
