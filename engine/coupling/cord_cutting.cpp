#include "ribbon/box2d/cord_cutting.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "ribbon/box2d/crossing.h"
#include "ribbon/cord_forces.h"
#include "ribbon/cord_sweep.h"
#include "ribbon/pulley.h"

namespace ribbon::box2d {
namespace {

/// A cord that is being cut.
struct CutCord {
  CordId id;
  CordShape shape;
  CutPlace where;
  std::optional<CordId> pieces[2];

  /// Returns the side of a point.
  int side_of(int point) const {
    const int column = point / shape.rows;
    return where.side_of(column, point % shape.rows);
  }
  /// Returns the index on its piece of the point of a column and a row of the uncut cord.
  int point_on_piece(int side, int column, int row) const {
    if (!where.is_along()) return (column - first_column(side)) * shape.rows + row;
    const int rows = side == 0 ? where.row + 1 : shape.rows - where.row;
    return column * rows + row - (side == 0 ? 0 : where.row);
  }
  int first_column(int side) const { return side == 0 || where.is_along() ? 0 : where.column; }
};

std::optional<CordId> add_piece(CouplingParts& parts, const CoupledCord& whole, std::optional<Cord> piece) {
  if (!piece) return std::nullopt;
  return parts.add(parts.spares.complete(std::move(*piece), whole));
}

/// A grip beyond the end of its piece, because the cut is at the nearest point, moves to the end without a jerk.
void move_along(BodyGrip& grip, const CutCord& cut, double at, int side) {
  const int rows = cut.shape.rows;
  const int columns = side == 0 ? cut.where.column + 1 : cut.shape.columns - cut.where.column;
  const double place = place_on_piece(cut.where, at, cut.shape.columns);
  const double before = cut.first_column(side);
  grip.blocked = grip.blocked || place + before != at;
  grip.point = grip.point % rows;
  if (grip.climb_to >= 0.0) grip.climb_to = std::clamp(grip.climb_to - before, 0.0, columns - 1.0);
  set_column(grip, place, columns, rows);
}

/// Grips go to their piece, or are released with the dust.
void move_grips(CouplingParts& parts, const CutCord& cut, const CoupledCord& whole) {
  const int rows = cut.shape.rows;
  for (std::size_t k = 0; k < parts.grips.all().size();) {
    const BodyGrip& old = parts.grips.all()[k];
    if (old.cord != cut.id) {
      ++k;
      continue;
    }
    const double at = column_of(old, whole);
    const int side = cut.where.side_of(at, old.point % rows);
    if (!cut.pieces[side]) {
      parts.release(old.id);
      continue;
    }
    if (parts.finder.exists(old.seen)) old.body->SetAwake(true);
    BodyGrip& grip = parts.grips.at(old.id);
    grip.cord = *cut.pieces[side];
    if (cut.where.is_along()) {
      grip.point = cut.point_on_piece(side, grip.point / rows, grip.point % rows);
    } else {
      move_along(grip, cut, at, side);
    }
    ++k;
  }
}

/// Ties go to their piece, or end with the dust.
void move_ties(CouplingParts& parts, const CutCord& cut) {
  const int rows = cut.shape.rows;
  const auto is_dust = [&](const TiePlace& place) {
    return place.cord == cut.id && !cut.pieces[cut.side_of(place.point)];
  };
  for (std::size_t k = 0; k < parts.ties.all().size();) {
    TieMemory& tie = parts.ties.all()[k];
    if (is_dust(tie.place) || is_dust(tie.other)) {
      parts.untie(tie.id);
      continue;
    }
    for (TiePlace* const place : {&tie.place, &tie.other}) {
      if (place->cord != cut.id) continue;
      const int side = cut.side_of(place->point);
      place->cord = *cut.pieces[side];
      place->point = cut.point_on_piece(side, place->point / rows, place->point % rows);
    }
    ++k;
  }
}

/// Pulleys go to the piece that has all points at their wheel.
void move_pulleys(CouplingParts& parts, const CutCord& cut, CoupledCord& whole) {
  if (pulleys_of(whole.direct()).empty()) return;
  parts.pulleys.follow_cut(whole, [&](const Pulley& pulley) -> CoupledCord* {
    const int side = pulley.def.before >= cut.where.column ? 1 : 0;
    const bool is_cut = side == 0 && pulley.def.after > cut.where.column;
    return is_cut || !cut.pieces[side] ? nullptr : &parts.cords.at(*cut.pieces[side]);
  });
}

Vec2 middle(const CoupledCord& cord, const CordShape& shape, int column) {
  const auto x = cord.positions();
  const auto rows = static_cast<std::size_t>(shape.rows);
  const std::size_t first = static_cast<std::size_t>(column) * rows;
  return 0.5 * (x[first] + x[first + rows - 1]);
}

/// Returns the inner row of a ribbon that is nearest to a segment on average, if the segment crosses all columns.
std::optional<int> row_along(const CoupledCord& cord, const CordShape& shape, Vec2 a, Vec2 b) {
  if (shape.rows < 3) return std::nullopt;
  const auto x = cord.positions();
  const auto rows = static_cast<std::size_t>(shape.rows);
  double sum = 0.0;
  for (std::size_t first = 0; first < x.size(); first += rows) {
    std::optional<double> at;
    for (std::size_t j = 0; j + 1 < rows && !at; ++j) {
      at = crossing(x[first + j], x[first + j + 1], a, b);
      if (at) sum += static_cast<double>(j) + *at;
    }
    if (!at) return std::nullopt;
  }
  return std::clamp(static_cast<int>(std::floor(sum / shape.columns + 0.5)), 1, shape.rows - 2);
}

/// Adds the cuts of a cord by a blade: along a row, or where the middle line crosses the segment, from the last place
/// to the first one. A crossing at a point counts once.
void find_cuts(const CoupledCord& cord, Vec2 a, Vec2 b, std::vector<BladeCut>& cuts) {
  const CordShape shape = cord.shape();
  if (const auto row = row_along(cord, shape, a, b)) {
    cuts.push_back({cord.id, ribbon::cut_along(cord.direct(), *row)});
    return;
  }
  for (int i = shape.columns - 2; i >= 0; --i) {
    const auto share = crossing(middle(cord, shape, i), middle(cord, shape, i + 1), a, b);
    if (!share) continue;
    const double place = i + *share;
    cuts.push_back({cord.id, {static_cast<int>(std::floor(place + 0.5)), place}});
  }
}

}  // namespace

CutEvent cut_cord(CouplingParts& parts, CordId id, const CutPlace& where) {
  CoupledCord& whole = parts.cords.enabled(id);
  const CordShape shape = whole.shape();
  CutPieces pieces = parts.spares.cut(whole.direct(), where);
  CutCord cut{id, shape, where, {}};
  parts.cords.activate(whole);
  const std::uint64_t next = solver_id(parts.cords.next());
  CutNeighbour neighbour{solver_id(id), where, shape.columns, shape.rows, {}};
  if (pieces.first || pieces.second) neighbour.pieces[0] = neighbour.pieces[1] = next;
  if (pieces.first && pieces.second) neighbour.pieces[1] = next + 1;
  join_pieces(pieces, neighbour);
  cut.pieces[0] = add_piece(parts, whole, std::move(pieces.first));
  cut.pieces[1] = add_piece(parts, whole, std::move(pieces.second));
  move_grips(parts, cut, whole);
  move_ties(parts, cut);
  move_pulleys(parts, cut, whole);
  for (CoupledCord& other : parts.cords) {
    if (other.is_direct() && other.id != id) follow_cut(other.direct(), neighbour);
  }
  const CutEvent event{id, whole.arc_at(where.place), cut.pieces[0], cut.pieces[1], false, 0.0, where.row};
  parts.cuts.add(event);
  parts.remove(id);
  return event;
}

/// A cord is cut from its last place to its first one, so that what is left has the places before.
void cut_along(CouplingParts& parts, Vec2 a, Vec2 b) {
  const Box box{{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
  std::vector<BladeCut>& cuts = parts.blade_cuts;
  cuts.clear();
  for (const CoupledCord& cord : std::as_const(parts.cords)) {
    if (!cord.enabled || !cord.is_direct() || !overlap(sweep_of(cord.direct()).box, box)) continue;
    find_cuts(cord, a, b, cuts);
  }
  for (std::size_t k = 0; k < cuts.size();) {
    const CordId whole = cuts[k].cord;
    std::optional<CordId> left = whole;
    int last = -1;
    for (; k < cuts.size() && cuts[k].cord == whole; ++k) {
      const CutPlace where = cuts[k].where;
      if (!left || where.column == last) continue;  // nothing is left before it, or the piece between is dust
      last = where.column;
      left = cut_cord(parts, *left, where).first;
    }
  }
}

void break_overloaded(CouplingParts& parts) {
  std::vector<std::pair<CordId, int>>& broken = parts.overloaded;
  broken.clear();
  visit_fetched(std::as_const(parts.cords).active(), CordMemory::surroundings, [&broken](const CoupledCord& cord) {
    if (!cord.enabled || !cord.is_direct() || cord.direct().is_asleep()) return;
    if (const auto link = overloaded_link(cord.direct())) broken.emplace_back(cord.id, *link);
  });
  for (const auto& [id, link] : broken) {
    const Cord& cord = parts.cords.at(id).direct();
    const double tension = tension_of(cord, link);
    cut_cord(parts, id, cut_through(cord, link));
    parts.cuts.last_broke(tension);
  }
}

}  // namespace ribbon::box2d
