#include "ribbon/reports.h"

#include <algorithm>

namespace ribbon {

IslandReport& IslandReport::operator+=(const IslandReport& other) {
  stages += other.stages;
  iterations += other.iterations;
  searches += other.searches;
  fallbacks += other.fallbacks;
  energy_gains += other.energy_gains;
  halvings += other.halvings;
  impacts += other.impacts;
  posed += other.posed;
  cuts += other.cuts;
  unlocked += other.unlocked;
  unconverged += other.unconverged;
  work += other.work;
  position_error = std::max(position_error, other.position_error);
  force_error = std::max(force_error, other.force_error);
  return *this;
}

}  // namespace ribbon
