#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/extremes/tested_cord.h"

namespace extremes {

/// A row of the table: the worst value of a figure over some cases, and the sum of what their steps report.
struct Row {
  std::string what;    ///< the action
  std::string figure;  ///< the bounded figure and its unit
  Method method = Method::balanced;
  int cases = 0;  ///< number of values taken
  double worst = 0.0;
  std::string setting;  ///< of the worst case
  std::string how;      ///< how the figure fails there, if it does
  double limit = 0.0;   ///< the upper bound of the figure
  Counts counts;

  /// Returns false if the figure is not a number, or a substep stayed unconverged.
  bool passed() const { return worst <= limit && counts.direct.unconverged == 0; }
  /// Returns whether a failure of this row is an error.
  bool is_required() const { return method != Method::thesis; }
  /// Returns whether a step has reported that its result is not valid.
  bool is_reported() const;
};

/// Finds the greatest value of a figure.
class WorstCase {
 public:
  WorstCase(std::string what, std::string figure, Method method, double limit);
  /// `how` names the failure of a value above the limit; the default for an infinite value is "diverged".
  void take(double value, std::string_view setting, std::string_view how = {});
  void add(const Counts& counts) { row_.counts += counts; }
  const Row& row() const { return row_; }

 private:
  Row row_;
};

/// The extent of a run: a part of each grid, for a few seconds, or all of it. `progress` receives the share done.
struct Scope {
  bool full = false;
  std::string part;  ///< run only cases whose setting contains this text
  std::function<void(double)> progress = [](double) {};

  bool wants(std::string_view setting) const { return setting.find(part) != std::string_view::npos; }
};

struct Group {
  std::string_view name;
  std::string_view description;
  std::vector<Row> (*run)(const Scope& scope);
};
const std::vector<Group>& groups();

std::vector<Row> run_sweep(const Scope& scope);
std::vector<Row> run_starts(const Scope& scope);
std::vector<Row> run_drives(const Scope& scope);
std::vector<Row> run_crush(const Scope& scope);
std::vector<Row> run_degenerate(const Scope& scope);
std::vector<Row> run_places(const Scope& scope);
std::vector<Row> run_soak(const Scope& scope);
std::vector<Row> run_any_scene(const Scope& scope);

/// Returns "ok", "FAIL: …" for a required row, or "allowed: …" for the thesis's method.
std::string verdict(const Row& row);

/// Prints rows in aligned columns; omits rows without a case.
void print_rows(const std::vector<Row>& rows);

}  // namespace extremes
