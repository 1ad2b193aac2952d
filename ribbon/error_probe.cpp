#include "ribbon/error_probe.h"

#include <algorithm>

namespace ribbon {
namespace {

constexpr int max_substeps = 4096;
constexpr double min_tolerance = 1e-12;  // m

}  // namespace

CordDef ErrorProbe::finer_def(const Cord& cord) {
  CordDef def = cord.def();
  def.accuracy.substeps = std::min(finer * def.accuracy.substeps, max_substeps);
  // The tolerance shrinks like the error of a second-order method, so the error of the solves stays below it.
  def.accuracy.tolerance = std::max(def.accuracy.tolerance / (finer * finer), min_tolerance);
  return def;
}

void ErrorProbe::foresee(std::span<const IslandCord> cords, std::span<const RigidBody> bodies, double dt, Vec2 gravity,
                         std::span<const Tie> ties) {
  while (copies_.size() > cords.size()) copies_.pop_back();
  for (std::size_t k = 0; k < cords.size(); ++k) {
    const Cord& cord = *cords[k].cord;
    if (k == copies_.size()) copies_.emplace_back(finer_def(cord));
    if (copies_[k].def() != finer_def(cord)) copies_[k] = Cord(finer_def(cord));
    copies_[k].restore(cord.save());
  }
  members_.assign(cords.begin(), cords.end());
  for (std::size_t k = 0; k < cords.size(); ++k) members_[k].cord = &copies_[k];
  bodies_.assign(bodies.begin(), bodies.end());
  reports_.resize(cords.size());
  solver_.step(members_, bodies_, dt, gravity, reports_, ties);
}

double ErrorProbe::error(std::size_t cord, const Cord& stepped) const {
  double largest = 0.0;
  const auto expected = copies_[cord].positions();
  for (std::size_t p = 0; p < expected.size(); ++p)
    largest = std::max(largest, length(expected[p] - stepped.positions()[p]));
  return largest;
}

}  // namespace ribbon
