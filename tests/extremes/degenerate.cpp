#include <algorithm>
#include <cmath>
#include <string>

#include "tests/extremes/table.h"
#include "tests/support/constants.h"

// Coincident points and invalid lengths.

namespace extremes {
namespace {

using constants::dt;
using constants::infinity;
using ribbon::Vec2;

ribbon::CordDef cord_of(int rows) {
  ribbon::CordDef def;
  def.points = 11;
  def.rows = rows;
  def.length = 1.0;
  def.width = 0.1 * (rows - 1);
  def.mass_per_length = 0.5;
  def.stretch_stiffness = 1e4;
  def.damping = 0.05;
  if (rows > 1) {
    ribbon::solid(2e5, 0.0, 0.1, def.width).apply_to(def);
    def.area_stiffness = 1.0;
  }
  const ribbon::Cord rest(def);
  def.positions.assign(rest.positions().begin(), rest.positions().end());
  return def;
}

/// Places two neighbours, along or across, at the same point.
void coincide(Method method, int rows, bool across, const std::string& setting, WorstCase& strain) {
  ribbon::CordDef def = cord_of(rows);
  const std::size_t a = 5 * static_cast<std::size_t>(rows);
  def.positions[a + static_cast<std::size_t>(across ? 1 : rows)] = def.positions[a];
  TestedCord cord(method, def, dt);
  for (int k = 0; k < 240; ++k) {
    for (int p = 0; p < cord.columns() * cord.rows(); ++p) {
      cord.set_velocity(p, 0.9 * cord.velocities()[static_cast<std::size_t>(p)]);
    }
    cord.step(dt, {});
  }
  strain.take(cord.is_finite() ? cord.worst_strain() : infinity, setting, cord.shape());
  strain.add(cord.counts());
}

/// Returns 0 if the error names the field and the accepted range, 1 otherwise.
double refusal(const auto& make, const std::string& field) {
  try {
    make();
  } catch (const ribbon::DefinitionError& error) {
    const std::string text = error.what();
    return text.find(field) != std::string::npos && text.find("accepted") != std::string::npos ? 0.0 : 1.0;
  }
  return 1.0;
}

}  // namespace

std::vector<Row> run_degenerate(const Scope& scope) {
  std::vector<Row> rows;
  for (const Method method : all_methods) {
    WorstCase strain("two points in one place", "strain at the end", method, 1e-3);
    for (const int across : {1, 2, 3}) {
      if (method == Method::thesis && across == 1) continue;
      for (const bool is_across : {false, true}) {
        if (is_across && across == 1) continue;
        const std::string setting = std::to_string(across) + " rows, neighbours " + (is_across ? "across" : "along");
        if (scope.wants(setting)) coincide(method, across, is_across, setting, strain);
      }
    }
    WorstCase refused("a link without length", "cases not refused by name", method, 0.0);
    const auto take = [&](const auto& make, const std::string& field) {
      if (scope.wants(field)) refused.take(refusal(make, field), field, "accepted");
    };
    if (method == Method::thesis) {
      take(
          [] {
            ribbon::ThesisDef def;
            def.spacing = 0.0;
            const ribbon::ThesisCord cord(def);
          },
          "spacing");
    } else {
      take(
          [] {
            ribbon::CordDef def;
            def.length = 0.0;
            const ribbon::Cord cord(def);
          },
          "length");
      take(
          [] {
            ribbon::CordDef def = cord_of(2);
            def.width = 0.0;
            const ribbon::Cord cord(def);
          },
          "width");
      take([] { ribbon::Cord(cord_of(1)).reel(0, 10, 0.0, 1.0); }, "length");
    }
    rows.insert(rows.end(), {strain.row(), refused.row()});
  }
  scope.progress(1.0);
  return rows;
}

}  // namespace extremes
