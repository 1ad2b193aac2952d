#include "ribbon/box2d/cord_cutting.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace ribbon::box2d {
namespace {

/// A cord that is being cut.
struct CutCord {
  CordId id;
  int columns;
  CutPlace where;
  std::optional<CordId> pieces[2];
};

std::optional<CordId> add_piece(CouplingParts& parts, const CoupledCord& whole, std::optional<Cord> piece) {
  if (!piece) return std::nullopt;
  CoupledCord added(std::move(*piece), whole.filter);
  added.user_data = whole.user_data;
  return parts.add(std::move(added));
}

/// A grip beyond the end of its piece, because the cut is at the nearest point, moves to the end without a jerk.
void move_grip(BodyGrip& grip, const CutCord& cut, const CoupledCord& whole) {
  const int rows = whole.shape().rows;
  const double at = column_of(grip, whole);
  const int side = cut.where.side_of(at);
  const int columns = side == 0 ? cut.where.column + 1 : cut.columns - cut.where.column;
  const double place = place_on_piece(cut.where, at, cut.columns);
  const double before = side == 0 ? 0.0 : cut.where.column;
  grip.blocked = grip.blocked || place + before != at;
  grip.cord = *cut.pieces[side];
  grip.point = grip.point % rows;
  if (grip.climb_to >= 0.0) grip.climb_to = std::clamp(grip.climb_to - before, 0.0, columns - 1.0);
  set_column(grip, place, columns, rows);
}

/// Grips go to their piece, or are released with the dust.
void move_grips(CouplingParts& parts, const CutCord& cut, const CoupledCord& whole) {
  for (std::size_t k = 0; k < parts.grips.all().size();) {
    const BodyGrip& grip = parts.grips.all()[k];
    if (grip.cord != cut.id) {
      ++k;
    } else if (!cut.pieces[cut.where.side_of(column_of(grip, whole))]) {
      parts.release(grip.id);
    } else {
      if (parts.finder.exists(grip.seen)) grip.body->SetAwake(true);
      move_grip(parts.grips.at(grip.id), cut, whole);
      ++k;
    }
  }
}

/// Ties go to their piece, or end with the dust.
void move_ties(CouplingParts& parts, const CutCord& cut, const CoupledCord& whole) {
  const int rows = whole.shape().rows;
  const auto side_of = [&](const TiePlace& place) {
    const int column = place.point / rows;
    return cut.where.side_of(column);
  };
  const auto is_dust = [&](const TiePlace& place) { return place.cord == cut.id && !cut.pieces[side_of(place)]; };
  for (std::size_t k = 0; k < parts.ties.all().size();) {
    TieMemory& tie = parts.ties.all()[k];
    if (is_dust(tie.place) || is_dust(tie.other)) {
      parts.untie(tie.id);
      continue;
    }
    for (TiePlace* const place : {&tie.place, &tie.other}) {
      if (place->cord != cut.id) continue;
      const int side = side_of(*place);
      place->cord = *cut.pieces[side];
      if (side == 1) place->point -= cut.where.column * rows;
    }
    ++k;
  }
}

/// Pulleys go to the piece that has all points at their wheel.
void move_pulleys(CouplingParts& parts, const CutCord& cut, CoupledCord& whole) {
  if (whole.direct().pulleys().empty()) return;
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

/// Adds the places [columns] where the middle line of a cord crosses a segment, ascending. A crossing at a point counts
/// once.
void find_crossings(const CoupledCord& cord, Vec2 a, Vec2 b, std::vector<double>& places) {
  const CordShape shape = cord.shape();
  for (int i = 0; i + 1 < shape.columns; ++i) {
    const Vec2 p = middle(cord, shape, i);
    const Vec2 q = middle(cord, shape, i + 1);
    const double side_p = cross(b - a, p - a);
    const double side_q = cross(b - a, q - a);
    if ((side_p < 0.0) == (side_q < 0.0)) continue;
    const double share = side_p / (side_p - side_q);
    const Vec2 at = p + share * (q - p);
    const double along = dot(at - a, b - a);
    if (along < 0.0 || along > dot(b - a, b - a)) continue;
    places.push_back(i + share);
  }
}

/// Cuts from the last place to the first one, so that what is left has the places before.
void cut_at_places(CouplingParts& parts, CordId id, const std::vector<double>& places) {
  int last = -1;
  for (auto place = places.rbegin(); place != places.rend(); ++place) {
    const CutPlace where{static_cast<int>(std::floor(*place + 0.5)), *place};
    if (where.column == last) continue;  // the piece between the two is dust
    last = where.column;
    const CutEvent event = cut_cord(parts, id, where);
    if (!event.first) return;  // nothing is left before it
    id = *event.first;
  }
}

}  // namespace

CutEvent cut_cord(CouplingParts& parts, CordId id, const CutPlace& where) {
  CoupledCord& whole = parts.cords.enabled(id);
  const CordShape shape = whole.shape();
  CutPieces pieces = ribbon::cut(whole.direct(), where);
  CutCord cut{id, shape.columns, where, {}};
  parts.cords.activate(whole);
  const std::uint64_t next = solver_id(parts.cords.next());
  CutNeighbour neighbour{solver_id(id), where, shape.columns, shape.rows, {}};
  if (pieces.first || pieces.second) neighbour.pieces[0] = neighbour.pieces[1] = next;
  if (pieces.first && pieces.second) neighbour.pieces[1] = next + 1;
  join_pieces(pieces, neighbour);
  cut.pieces[0] = add_piece(parts, whole, std::move(pieces.first));
  cut.pieces[1] = add_piece(parts, whole, std::move(pieces.second));
  move_grips(parts, cut, whole);
  move_ties(parts, cut, whole);
  move_pulleys(parts, cut, whole);
  for (CoupledCord& other : parts.cords) {
    if (other.is_direct() && other.id != id) follow_cut(other.direct(), neighbour);
  }
  const CutEvent event{id, whole.arc_at(where.place), cut.pieces[0], cut.pieces[1]};
  parts.cuts.add(event);
  parts.remove(id);
  return event;
}

void cut_along(CouplingParts& parts, Vec2 a, Vec2 b) {
  const Box box{{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
  std::vector<std::pair<CordId, std::vector<double>>> cuts;
  for (const CoupledCord& cord : std::as_const(parts.cords)) {
    if (!cord.enabled || !cord.is_direct() || !overlap(cord.direct().sweep().box, box)) continue;
    std::vector<double> places;
    find_crossings(cord, a, b, places);
    if (!places.empty()) cuts.emplace_back(cord.id, std::move(places));
  }
  for (const auto& [id, places] : cuts) cut_at_places(parts, id, places);
}

void break_overloaded(CouplingParts& parts) {
  std::vector<std::pair<CordId, int>>& broken = parts.overloaded;
  broken.clear();
  for (const CoupledCord& cord : std::as_const(parts.cords).active()) {
    if (!cord.enabled || !cord.is_direct() || cord.direct().is_asleep()) continue;
    if (const auto link = cord.direct().overloaded_link()) broken.emplace_back(cord.id, *link);
  }
  for (const auto& [id, link] : broken) {
    const Cord& cord = parts.cords.at(id).direct();
    const double tension = cord.tensions()[static_cast<std::size_t>(link)];
    cut_cord(parts, id, cut_through(cord, link));
    parts.cuts.last_broke(tension);
  }
}

}  // namespace ribbon::box2d
