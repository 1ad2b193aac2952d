#include "ribbon/system/split_ribbon.h"

#include <algorithm>
#include <cstddef>

#include "ribbon/linear/index.h"

namespace ribbon {
namespace {

// Limits of the change of a rest length, where the columns of a crushed ribbon lie in each other.
constexpr double min_ratio = 0.1;
constexpr double max_ratio = 10.0;

/// The rows of a piece in the uncut ribbon.
struct Rows {
  int first, last, all;

  int size() const { return last - first + 1; }
  /// Share of the width.
  double share() const { return static_cast<double>(last - first) / (all - 1); }
  /// Index in the uncut ribbon of a point of the piece.
  std::size_t whole(std::size_t point) const {
    const std::size_t column = point / at(size());
    return column * at(all) + at(first) + point % at(size());
  }
};

/// The piece's cells are those of the ribbon, with their energy, and nothing else pulls.
bool is_solid(const CordParts& ribbon) {
  return ribbon.def.elements == Elements::cells && ribbon.elasticity->terms() == 1;
}

bool has_spine(const CordParts& ribbon) { return ribbon.def.elements == Elements::cells && !is_solid(ribbon); }

CordDef definition_of(const CordParts& whole, const Rows& rows) {
  CordDef def = whole.def;
  const double share = rows.share();
  def.rows = rows.size();
  def.width *= share;
  def.mass_per_length *= share;
  def.stretch_stiffness *= share;
  def.bending_stiffness *= share * share * share;
  def.breaking_force *= share;
  if (def.rows == 2 && has_spine(whole)) def.cell_stiffness = 12.0 * def.bending_stiffness / (def.width * def.width);
  def.pins.clear();
  def.positions.clear();
  for (std::size_t p = 0; p < at(def.points * def.rows); ++p) {
    def.positions.push_back(whole.state.positions[rows.whole(p)]);
  }
  return def;
}

void take_points(const CordParts& whole, const Rows& rows, int row, bool keeps_row, CordParts& piece) {
  const Cord::State& from = whole.state;
  Cord::State& to = piece.state;
  if (!from.loads.empty()) to.loads.assign(piece.size(), {});
  for (std::size_t p = 0; p < piece.size(); ++p) {
    const std::size_t old = rows.whole(p);
    const bool is_cut = old % at(rows.all) == at(row);
    const bool keeps = keeps_row || !is_cut;
    to.velocities[p] = from.velocities[old];
    to.accelerations[p] = from.accelerations[old];
    to.targets[p] = from.targets[old];
    to.masses[p] = piece.own_masses[p] + (keeps ? from.masses[old] - whole.own_masses[old] : 0.0);
    to.kinds[p] = keeps || from.kinds[old] == PointKind::constrained ? from.kinds[old] : PointKind::free;
    if (keeps && !from.loads.empty()) to.loads[p] = from.loads[old];
  }
}

/// Copies what there is of each cell.
template <typename From, typename To>
void take_cells(const From& from, const Rows& rows, To&& to) {
  const std::size_t cells = at(rows.size()) - 1;
  for (std::size_t k = 0; k < to.size(); ++k) {
    to[k] = from[k / cells * (at(rows.all) - 1) + at(rows.first) + k % cells];
  }
}

/// Returns the vector from the middle of a column to that of the next one, m.
Vec2 along_middle(const CordParts& cord, std::size_t column) {
  const std::size_t rows = at(cord.def.rows);
  const auto middle = [&](std::size_t first) {
    return 0.5 * (cord.state.positions[first + (rows - 1) / 2] + cord.state.positions[first + rows / 2]);
  };
  return middle((column + 1) * rows) - middle(column * rows);
}

void strain_as(const CordParts& whole, CordParts& piece) {
  Cord::State& to = piece.state;
  for (std::size_t link = 0; link < to.rest.size(); ++link) {
    const double before = length(along_middle(whole, link));
    const double after = length(along_middle(piece, link));
    const double ratio = before > 0.0 ? std::clamp(after / before, min_ratio, max_ratio) : 1.0;
    to.rest[link] *= ratio;
    if (to.rest_targets.empty()) continue;
    to.rest_targets[link] *= ratio;
    to.rest_speeds[link] *= ratio;
  }
}

void take_elasticity(const CordParts& whole, const Rows& rows, CordParts& piece) {
  const Cord::State& from = whole.state;
  Cord::State& to = piece.state;
  to.rest = from.rest;
  to.rest_targets = from.rest_targets;
  to.rest_speeds = from.rest_speeds;
  if (has_spine(whole)) strain_as(whole, piece);
  piece.rest_start = to.rest_targets;
  piece.rest_end = to.rest_targets;
  piece.elasticity->set_rest_lengths(to.rest);
  take_cells(whole.elasticity->unlocked(), rows, piece.elasticity->unlocked());
  if (is_solid(whole)) {
    take_cells(from.tensions, rows, to.tensions);
    to.damping_excluded = from.damping_excluded;
  } else {
    piece.elasticity->find_tensions(to.positions, to.tensions);
    to.damping_excluded = whole.def.damping > 0.0;
  }
}

}  // namespace

std::unique_ptr<CordParts> split_piece(const CordParts& whole, int row, int side) {
  const int all = whole.def.rows;
  const Rows rows = side == 0 ? Rows{0, row, all} : Rows{row, all - 1, all};
  auto piece = std::make_unique<CordParts>(definition_of(whole, rows));
  const Cord::State& from = whole.state;
  Cord::State& to = piece->state;
  take_points(whole, rows, row, side == 0, *piece);
  take_elasticity(whole, rows, *piece);
  to.breaking_forces = from.breaking_forces;
  for (double& force : to.breaking_forces) force *= rows.share();
  to.regainable_energy = std::min(0.0, rows.share() * from.regainable_energy);  // what follows a cut is not smooth
  to.energy_drift = rows.share() * from.energy_drift;
  to.depenetration_share = from.depenetration_share;
  to.newton_pause = from.newton_pause;
  to.family = from.family;
  to.joined_first = from.joined_first;
  to.joined_last = from.joined_last;
  to.split = true;
  piece->disturb();
  return piece;
}

}  // namespace ribbon
