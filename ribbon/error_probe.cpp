#include "ribbon/error_probe.h"

#include <algorithm>

namespace ribbon {
namespace {

constexpr int most_substeps = 4096;
constexpr double least_tolerance = 1e-12;  // m

}  // namespace

CordDef ErrorProbe::finer_def(const Cord& cord) {
  CordDef def = cord.def();
  def.accuracy.substeps = std::min(finer * def.accuracy.substeps, most_substeps);
  // As the error of the second order, so that what the solves leave is not taken for it.
  def.accuracy.tolerance = std::max(def.accuracy.tolerance / (finer * finer), least_tolerance);
  return def;
}

void ErrorProbe::foresee(std::span<const IslandCord> cords, std::span<const RigidBody> bodies, double dt,
                         Vec2 gravity) {
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
  solver_.step(members_, bodies_, dt, gravity, reports_);
}

double ErrorProbe::error(std::size_t cord, const Cord& stepped) const {
  double most = 0.0;
  const auto foreseen = copies_[cord].positions();
  for (std::size_t p = 0; p < foreseen.size(); ++p) most = std::max(most, length(foreseen[p] - stepped.positions()[p]));
  return most;
}

}  // namespace ribbon
