#include "tests/tradeoff/table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace tradeoff {
namespace {

std::string text(double value, int decimals) {
  if (std::isnan(value)) return {};
  std::array<char, 64> buffer{};
  if (decimals < 0) {
    std::snprintf(buffer.data(), buffer.size(), "%.4g", value);
  } else {
    std::snprintf(buffer.data(), buffer.size(), "%.*f", decimals, value);
  }
  return buffer.data();
}

using Cells = std::vector<std::string>;

Cells header(const Scene& scene) {
  Cells cells = {"scene", "method", "setting", "points"};
  for (const Column& column : scene.columns) cells.push_back(column.name);
  return cells;
}

Cells cells_of(const Scene& scene, const Row& row) {
  const Variant& c = row.variant;
  Cells cells = {scene.name, c.method, c.setting + (c.group.empty() ? "" : " " + c.group), std::to_string(c.points)};
  for (const Column& column : scene.columns) cells.push_back(text(column.value(row), column.decimals));
  return cells;
}

void print_cells(const Cells& cells) {
  for (std::size_t c = 0; c < cells.size(); ++c) std::printf("%s%s", c == 0 ? "" : ",", cells[c].c_str());
  std::putchar('\n');
}

double reference_us(const Scene& scene, const std::vector<Row>& rows) {
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&](const Row& row) { return row.variant.setting == scene.reference_setting; });
  return (found == rows.end() ? rows.front() : *found).timing.median_us;
}

/// Prints names left-aligned and numbers right-aligned.
void print_aligned(const std::vector<Cells>& lines) {
  constexpr std::size_t names = 3;
  std::vector<std::size_t> widths(lines.front().size());
  for (const Cells& cells : lines) {
    for (std::size_t c = 0; c < cells.size(); ++c) widths[c] = std::max(widths[c], cells[c].size());
  }
  for (const Cells& cells : lines) {
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const int width = static_cast<int>(widths[c]);
      std::printf("%s%*s", c == 0 ? "" : "  ", c < names ? -width : width, cells[c].c_str());
    }
    std::putchar('\n');
  }
}

}  // namespace

void print_csv(const Scene& scene, const std::vector<Row>& rows) {
  print_cells(header(scene));
  for (const Row& row : rows) print_cells(cells_of(scene, row));
}

void print_table(const Scene& scene, const std::vector<Row>& rows) {
  std::vector<Cells> lines = {header(scene)};
  lines.back().push_back("ns_per_point");
  lines.back().push_back("relative_to_" + (scene.reference_setting.empty() ? "first" : scene.reference_setting));
  for (const Row& row : rows) {
    lines.push_back(cells_of(scene, row));
    const double us = row.timing.median_us;
    lines.back().push_back(text(1e3 * us / row.variant.points, 1));
    lines.back().push_back(text(us / reference_us(scene, rows), 2));
  }
  print_aligned(lines);
}

}  // namespace tradeoff
