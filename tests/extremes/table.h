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
  std::string setting;         ///< of the worst case
  double bar = 0.0;            ///< the figure may not be above
  int unconverged_bar = 0;     ///< substeps that may stay unconverged
  bool known_to_fail = false;  ///< and not held: of the thesis's, and what README says that the direct solver cannot do
  Counts counts;

  /// Not if the figure is no number.
  bool passed() const { return worst <= bar && counts.direct.unconverged <= unconverged_bar; }
  /// Whether it may not fail.
  bool held() const { return !known_to_fail && method != Method::thesis; }
};

/// Finds the worst of a figure.
class Worst {
 public:
  Worst(std::string what, std::string figure, Method method, double bar);
  void take(double value, std::string_view setting);
  void add(const Counts& counts) { row_.counts += counts; }
  void allow_unconverged(int substeps) { row_.unconverged_bar = substeps; }
  void let_fail() { row_.known_to_fail = true; }
  const Row& row() const { return row_; }

 private:
  Row row_;
};

/// How much is run: a part of each grid in a few seconds, or all of it; `progress` is told the share that is done.
struct Scope {
  bool full = false;
  std::function<void(double)> progress = [](double) {};
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

/// In columns of equal width.
void print_rows(const std::vector<Row>& rows);

}  // namespace extremes
