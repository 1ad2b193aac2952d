#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "ribbon/cord_forces.h"
#include "ribbon/direct_solver.h"
#include "ribbon/linear/index.h"
#include "ribbon/tie.h"
#include "tests/support/constants.h"
#include "tests/support/points.h"

// What tests of ties share.

namespace ribbon {

/// Cords and their ties.
struct TiedCords {
  std::vector<Cord> cords;
  std::vector<Tie> ties;
  DirectSolver solver;
  std::vector<CordReport> reports;
  int unconverged = 0;

  void step(int times = 1, std::span<RigidBody> bodies = {}, std::span<const Grip> grips_of_first = {}) {
    std::vector<IslandCord> list;
    for (std::size_t k = 0; k < cords.size(); ++k) list.push_back({&cords[k], {}, k + 1});
    if (!grips_of_first.empty()) list.at(0).surroundings.grips = grips_of_first;
    reports.resize(cords.size());
    for (int k = 0; k < times; ++k) {
      solver.step(list, bodies, constants::dt, constants::gravity, reports, ties);
      unconverged += solver.total().unconverged;
    }
  }
  Vec2 position(int cord, int point) const { return cords[at(cord)].positions()[at(point)]; }
  /// Returns the largest distance between tied points, m.
  double gap() const {
    double widest = 0.0;
    for (const Tie& tie : ties) {
      widest = std::max(widest, length(position(tie.cord, tie.point) - position(tie.other_cord, tie.other_point)));
    }
    return widest;
  }
  /// Returns the largest strain of a link, also when it is compressed.
  double strain() const {
    double largest = 0.0;
    for (const Cord& cord : cords) {
      for (int i = 0; i + 1 < cord.size(); ++i) {
        const double size = length(cord.positions()[at(i + 1)] - cord.positions()[at(i)]);
        largest = std::max(largest, std::abs(size / cord.rest_length(i) - 1.0));
      }
    }
    return largest;
  }
  Vec2 momentum() const {
    Vec2 sum;
    for (const Cord& cord : cords) {
      for (int p = 0; p < cord.size(); ++p) sum += cord.mass(p) * cord.velocities()[at(p)];
    }
    return sum;
  }
  double energy() const {
    double sum = 0.0;
    for (const Cord& cord : cords) sum += energy_of(cord, constants::gravity).total();
    return sum;
  }
};

inline CordDef level_rope(Vec2 start, int points = 11, double link = 0.1) {
  CordDef def;
  def.points = points;
  def.length = link * (points - 1);
  def.positions = test_support::equally_spaced(points, start, {link, 0.0});
  return def;
}

}  // namespace ribbon
