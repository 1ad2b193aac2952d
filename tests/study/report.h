#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/study/frontier.h"

namespace study {

/// The content of a report.
struct Report {
  std::string title;                              ///< heavy_swing
  std::vector<std::string> notes;                 ///< sentences above the table
  std::vector<Point> points;                      ///< settings and baselines
  std::vector<std::string> columns;               ///< names of further columns, by point in `cells`
  std::vector<std::vector<std::string>> cells{};  ///< their texts
  std::string axis = "error [m]";                 ///< the label of the points' own error
  std::string headline{};                         ///< the recommendation in a sentence; empty: none
  std::optional<std::size_t> recommended{};       ///< its point
  std::string recommended_with{};                 ///< what is recommended beyond that point: max_work=20000; or empty
  std::optional<std::size_t> present{};           ///< the point of the present setting
  std::vector<std::string> findings{};            ///< a line each, behind the picture: terms that are needed and not
  std::string films{};  ///< JSON for page_script.js: the stage, and films by point; empty: none
};

/// Thrown if a plot could not be drawn; all other files are written.
class PlotError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Makes a folder that a report can be written into. Throws std::runtime_error if it cannot be: before minutes of work.
void require_folder(const std::string& folder);

/// Writes points.csv, points.json, index.html and a plot of the points' error, drawn by gnuplot (front.gp, front.svg),
/// into a folder, which it creates. Throws std::runtime_error if the folder cannot be written, and PlotError, with
/// everything else written, if gnuplot fails.
void write_report(const Report& report, const std::string& folder);

/// A page and the function that writes it, which returns the program's exit status.
struct Page {
  std::string name;
  std::function<int()> write;
};

/// Writes one page after the other, and calls `add` with the names of those written so far after each. A failure of
/// gnuplot is reported once, at the end, and prevents no page. Returns the program's exit status: 1 if a plot is
/// missing, or that of a page if it is not 0, which is then the last page.
int write_pages(const std::vector<Page>& pages, const std::function<void(const std::vector<std::string>& done)>& add);

/// Writes a page with the plots of the reports in folders of these names beside it. Creates the folder.
void write_contents(const std::string& title, const std::vector<std::string>& notes,
                    const std::vector<std::string>& folders, const std::string& folder);

}  // namespace study
