#include "ribbon/system/link_lengths.h"

#include <algorithm>

#include "ribbon/linear/index.h"
#include "ribbon/linear/reserve_more.h"
#include "ribbon/system/stretch.h"

namespace ribbon {
namespace {

constexpr int usual_iterations = 3;  // more give cords of heaps more energy
constexpr int max_iterations = 10;   // of what counts as stretched
constexpr double softening = 1e-6;   // of the diagonal: a taut cord between two fixed points has no solution

}  // namespace

void LinkLengths::resize(std::size_t slots) {
  mobility_.resize(slots);
  reserve_more(rows_, slots);
  reserve_more(before_, slots);
}

void LinkLengths::restore(IslandState& state, std::span<const double> inertia) {
  if (largest_strain(state, state.positions) <= restored_strain) return;
  for (std::size_t p = 0; p < state.points; ++p) mobility_[p] = state.constrained[p] != 0 ? 0.0 : 1.0 / inertia[p];
  for (const HeldBody& held : state.held) {
    mobility_[held.point] = 0.0;
    if (held.along > 0.0) mobility_[held.next] = 0.0;
  }
  for (const Wheel& wheel : state.wheels) mobility_[wheel.before] = mobility_[wheel.after] = 0.0;
  for (const TiedPoint& tied : state.ties.by_cord) {
    mobility_[state.members[at(tied.cord)].first_point + at(tied.point)] = 0.0;
  }
  for (const Member& member : state.members) restore(state, member);
}

/// A cord that is too short for what holds it has no solution: what increases the strain is undone.
void LinkLengths::restore(IslandState& state, const Member& member) {
  const double strain = largest_strain(member, state.positions);
  const auto positions = IslandState::points_of(member, state.positions);
  before_.assign(positions.begin(), positions.end());
  double restored = strain;
  const auto goes_on = [&restored](int done) {
    return done < usual_iterations ? restored > restored_strain : done < max_iterations && restored > max_strain;
  };
  for (int k = 0; goes_on(k); ++k) {
    load(state, member);
    if (!solve()) break;
    move(state, member);
    restored = largest_strain(member, state.positions);
  }
  if (!(restored <= strain)) std::copy(before_.begin(), before_.end(), positions.begin());
}

void LinkLengths::load(const IslandState& state, const Member& member) {
  rows_.assign(member.points - 1, {});
  for (std::size_t link = 0; link < rows_.size(); ++link) {
    const std::size_t p = member.first_point + link;
    const Vec2 along = state.positions[p + 1] - state.positions[p];
    const double size = length(along);
    const double rest = member.cord->state.rest[link];
    const double mobility = mobility_[p] + mobility_[p + 1];
    if (!(size > 0.0 && mobility > 0.0) || member.cord->is_on_wheel(link) ||
        (member.cord->def.tension_only && size < rest))
      continue;
    Row& row = rows_[link];
    row.normal = (1.0 / size) * along;
    row.diagonal = (1.0 + softening) * mobility;
    row.right = size - rest;
    if (link > 0) rows_[link - 1].upper = -mobility_[p] * dot(rows_[link - 1].normal, row.normal);
  }
}

/// Returns false if the matrix is not positive definite.
bool LinkLengths::solve() {
  for (std::size_t k = 1; k < rows_.size(); ++k) {
    const Row& before = rows_[k - 1];
    const double factor = before.upper / before.diagonal;
    rows_[k].diagonal -= factor * before.upper;
    rows_[k].right -= factor * before.right;
    if (!(rows_[k].diagonal > 0.0)) return false;
  }
  for (std::size_t k = rows_.size(); k-- > 0;) {
    if (k + 1 < rows_.size()) rows_[k].right -= rows_[k].upper * rows_[k + 1].right;
    rows_[k].right /= rows_[k].diagonal;
  }
  return true;
}

void LinkLengths::move(IslandState& state, const Member& member) const {
  for (std::size_t link = 0; link < rows_.size(); ++link) {
    const std::size_t p = member.first_point + link;
    const Vec2 pull = rows_[link].right * rows_[link].normal;
    state.positions[p] += mobility_[p] * pull;
    state.positions[p + 1] -= mobility_[p + 1] * pull;
  }
}

}  // namespace ribbon
