#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/extremes/subject.h"

namespace extremes {

/// A line of the table: the worst of a figure over some cases, and what the steps counted in all of them.
struct Row {
  std::string what;    ///< was done
  std::string figure;  ///< is bounded, and its unit
  Method method = Method::balanced;
  int cases = 0;  ///< that the figure was looked at
  double worst = 0.0;
  std::string setting;  ///< of the worst case
  std::string how;      ///< it is lost there, if it is
  double bar = 0.0;     ///< the figure may not be above
  Counts counts;

  /// Not if the figure is no number, or a substep stayed unconverged.
  bool passed() const { return worst <= bar && counts.direct.unconverged == 0; }
  /// Whether it may not fail.
  bool held() const { return method != Method::thesis; }
  /// Whether a step has reported that it is not to be trusted.
  bool is_reported() const;
};

/// Finds the worst of a figure.
class Worst {
 public:
  Worst(std::string what, std::string figure, Method method, double bar);
  /// `how` says what has happened if the value is above the bar; of an infinite one it is taken to be "diverged".
  void take(double value, std::string_view setting, std::string_view how = {});
  void add(const Counts& counts) { row_.counts += counts; }
  const Row& row() const { return row_; }

 private:
  Row row_;
};

/// The extent of a run: a part of each grid, for a few seconds, or all of it. `progress` is called with the share done.
struct Scope {
  bool full = false;
  std::string part;  ///< only cases whose setting contains this text
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

/// "ok", or what is lost: "FAIL: …" if it has to hold, "lost: …" of the thesis's method.
std::string verdict(const Row& row);

/// In columns of equal width; no row without a case.
void print_rows(const std::vector<Row>& rows);

}  // namespace extremes
