#pragma once

#include <string>
#include <vector>

#include "tests/study/frontier.h"

namespace study {

/// What a report shows.
struct Report {
  std::string title;                              ///< heavy_swing
  std::vector<std::string> notes;                 ///< sentences, to stand above the table
  std::vector<Point> points;                      ///< settings and baselines
  std::vector<std::string> columns;               ///< names of further columns, by point in `cells`
  std::vector<std::vector<std::string>> cells{};  ///< their texts
};

/// Writes points.csv, points.json, front.gp, front.svg (drawn by gnuplot) and index.html into a folder, which it makes.
/// Throws std::runtime_error if the folder cannot be written, or, with everything else written, if gnuplot fails.
void write_report(const Report& report, const std::string& folder);

/// What gnuplot draws front.svg from.
std::string plot_of(const Report& report);

}  // namespace study
