#include "game/tuning/tables.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>
#include <string>
#include <utility>

#include "game/words/panel_words.h"

namespace game {
namespace {

using ribbon::Vec2;
using ribbon::box2d::Coupling;

void show_cost(const Meter& meter) {
  const std::vector<float> recent = meter.recent_us();
  ImGui::Text(words::panel::tick_cost, meter.median_us(), meter.worst_us());
  if (recent.empty()) return;
  ImGui::PlotLines("##us", recent.data(), static_cast<int>(recent.size()), 0, nullptr, 0.0F,
                   1.1F * static_cast<float>(meter.worst_us()), {ImGui::GetContentRegionAvail().x, 0.0F});
}

void show_frame(const FrameTimes& times) {
  const FrameTimes::Figures physics = times.of(FrameTimes::Part::physics);
  const FrameTimes::Figures drawing = times.of(FrameTimes::Part::drawing);
  const FrameTimes::Figures whole = times.of(FrameTimes::Part::whole);
  ImGui::TextUnformatted(words::panel::frame_figures);
  ImGui::Text(words::panel::physics, physics.mean_ms, physics.worst_ms);
  ImGui::Text(words::panel::drawing, drawing.mean_ms, drawing.worst_ms);
  ImGui::Text(words::panel::whole, whole.mean_ms, whole.worst_ms);
}

/// As in Goto 2017, Fig. 4.1.
void show_legend() {
  const std::array<std::pair<const char*, ImVec4>, 3> points = {
      {{words::panel::free, {0.35F, 0.55F, 1.0F, 1.0F}},
       {words::panel::dragged, {1.0F, 0.85F, 0.25F, 1.0F}},
       {words::panel::constrained, {1.0F, 0.35F, 0.3F, 1.0F}}}};
  ImGui::TextUnformatted(words::panel::points);
  for (const auto& [name, color] : points) {
    ImGui::SameLine();
    ImGui::TextColored(color, "%s", name);
  }
}

void show_solving(const Simulation& simulation) {
  const Coupling& coupling = simulation.scene().coupling();
  const b2World& world = simulation.scene().world();
  int near = 0;
  for (const ribbon::box2d::CordId c : coupling.cords()) near += coupling.cord(c).near_count();
  ImGui::Text(words::panel::cords, coupling.size(), coupling.last_step().islands(), near);
  ImGui::Text(words::panel::bodies, world.GetBodyCount(), world.GetContactCount(), world.GetProxyCount(),
              world.GetTreeHeight());
}

void cell(const std::string& text) {
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(text.c_str());
}
void cell(int count) { cell(std::to_string(count)); }
/// Writes three significant digits.
void cell(double value, const char* unit) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%.3g%s", value, unit);
  cell(std::string(text.data()));
}

void show_direct_row(const Coupling& coupling, ribbon::box2d::CordId c, const Meter& meter) {
  const ribbon::IslandReport& last = coupling.cord(c).island_report();
  const ribbon::IslandReport& total = coupling.cord(c).island_total();
  cell(static_cast<int>(coupling.cord(c).direct().touches().size()));
  cell(greatest_tension(coupling, c), "");
  cell(inverted_cells(coupling, c));
  cell(std::to_string(last.iterations) + "/" + std::to_string(last.stages));
  cell(total.impacts);
  cell(total.fallbacks);
  cell(total.unconverged);
  cell(100.0 * meter.peak_stretch(c), " %");
}

void show_thesis_row(const Coupling& coupling, ribbon::box2d::CordId c, const Meter& meter) {
  const ribbon::StepReport& last = coupling.cord(c).thesis_report();
  cell(last.self_contacts + last.circle_contacts);
  cell("");
  cell(inverted_cells(coupling, c));
  for (int empty = 0; empty < 4; ++empty) cell("");  // it has no Newton steps
  cell(100.0 * meter.peak_stretch(c), " %");
}

}  // namespace

int inverted_cells(const Coupling& coupling, ribbon::box2d::CordId cord) {
  const ribbon::box2d::CordShape shape = coupling.cord(cord).shape();
  const auto x = coupling.cord(cord).positions();
  const auto rows = static_cast<std::size_t>(shape.rows);
  int count = 0;
  for (std::size_t column = 0; column + rows < x.size(); column += rows) {
    for (std::size_t point = column; point + 1 < column + rows; ++point) {
      const std::size_t next = point + rows;
      count += cross(x[next + 1] - x[point], x[point + 1] - x[next]) < 0.0;  // the diagonals
    }
  }
  return count;
}

double greatest_tension(const Coupling& coupling, ribbon::box2d::CordId cord) {
  if (coupling.cord(cord).solver() != ribbon::box2d::Solver::direct || coupling.cord(cord).shape().rows != 1)
    return 0.0;
  const auto tensions = coupling.cord(cord).direct().tensions();
  return tensions.empty() ? 0.0 : *std::max_element(tensions.begin(), tensions.end());
}

void show_tables(const Simulation& simulation, const Meter& meter, const FrameTimes& times) {
  show_frame(times);
  show_cost(meter);
  show_legend();
  show_solving(simulation);
  const auto& titles = words::panel::columns;
  if (!ImGui::BeginTable("##cords", static_cast<int>(std::size(titles)),
                         ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollX | ImGuiTableFlags_SizingFixedFit |
                             ImGuiTableFlags_BordersInnerV,
                         {0.0F, ImGui::GetTextLineHeightWithSpacing() *
                                    static_cast<float>(std::min(simulation.scene().coupling().size(), 12) + 2)})) {
    return;
  }
  for (const char* title : titles) ImGui::TableSetupColumn(title);
  ImGui::TableHeadersRow();
  const Coupling& coupling = simulation.scene().coupling();
  for (const ribbon::box2d::CordId c : coupling.cords()) {
    ImGui::TableNextRow();
    cell(c);
    cell(static_cast<int>(coupling.cord(c).positions().size()));
    if (coupling.cord(c).solver() == ribbon::box2d::Solver::direct) {
      show_direct_row(coupling, c, meter);
    } else {
      show_thesis_row(coupling, c, meter);
    }
  }
  ImGui::EndTable();
}

}  // namespace game
