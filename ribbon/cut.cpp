#include "ribbon/cut.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ribbon/linear/index.h"
#include "ribbon/system/cord_parts.h"
#include "ribbon/system/split_ribbon.h"

namespace ribbon {
namespace {

/// The columns of a piece in the uncut cord.
struct Columns {
  int first, last, all, rows;

  int size() const { return last - first + 1; }
  int links() const { return last - first; }
  bool is_whole() const { return size() == all; }
};

Columns columns_of(const CordDef& def, const CutPlace& where, int side) {
  return side == 0 ? Columns{0, where.column, def.points, def.rows}
                   : Columns{where.column, def.points - 1, def.points, def.rows};
}

/// Copies `count` values from `first` on. What is optional may be empty.
template <typename T>
void take(const std::vector<T>& from, int first, int count, std::vector<T>& to) {
  if (from.empty()) return to.clear();
  to.assign(std::next(from.begin(), first), std::next(from.begin(), first + count));
}

/// A feature of a piece (Touch::feature).
struct PieceFeature {
  int side;
  int feature;
};

/// Returns where a feature of a rope is after a cut. If one piece is dust, the other one has all features.
PieceFeature feature_after(const CutPlace& where, int feature, int columns) {
  const int k = feature / 2;
  const bool is_point = feature % 2 != 0;
  int side = k < where.column ? 0 : 1;
  if (is_point && k == where.column) side = where.side_of(k);
  if (where.column == 0) side = 1;
  if (where.column == columns - 1) side = 0;
  return {side, side == 0 ? feature : feature - 2 * where.column};
}

void define(const Cord& cord, const Columns& columns, CordDef& def) {
  def = cord.def();
  def.points = columns.size();
  if (!columns.is_whole()) def.length *= static_cast<double>(columns.links()) / (columns.all - 1);
  if (def.points == 2 && def.rows == 1) def.bending_stiffness = 0.0;
  const auto positions = cord.positions().subspan(at(columns.first * columns.rows), at(def.points * def.rows));
  def.positions.assign(positions.begin(), positions.end());
  def.pins.clear();
}

/// Returns a new cord with these columns, in the memory of another one if there is one.
std::optional<Cord> made_of(const Cord& cord, const Columns& columns, std::optional<Cord> memory) {
  if (memory) {
    define(cord, columns, memory->parts().def);
    memory->parts().renew();
    return memory;
  }
  CordDef def;
  define(cord, columns, def);
  return std::optional<Cord>(std::in_place, std::make_unique<CordParts>(def));
}

void take_points_and_links(const CordParts& whole, const Columns& columns, CordParts& piece) {
  const Cord::State& from = whole.state;
  Cord::State& to = piece.state;
  const int first = columns.first * columns.rows;
  const int count = columns.size() * columns.rows;
  take(from.positions, first, count, to.positions);
  take(from.velocities, first, count, to.velocities);
  take(from.accelerations, first, count, to.accelerations);
  take(from.loads, first, count, to.loads);
  take(from.medium_forces, first, count, to.medium_forces);
  take(from.rest, columns.first, columns.links(), to.rest);
  take(from.rest_targets, columns.first, columns.links(), to.rest_targets);
  take(from.rest_speeds, columns.first, columns.links(), to.rest_speeds);
  take(from.breaking_forces, columns.first, columns.links(), to.breaking_forces);
  piece.rest_start = to.rest_targets;
  piece.rest_end = to.rest_targets;
  const std::span<const char> unlocked = whole.elasticity->unlocked();
  const std::span<char> piece_unlocked = piece.elasticity->unlocked();
  std::copy_n(unlocked.begin() + (unlocked.empty() ? 0 : columns.first * (columns.rows - 1)), piece_unlocked.size(),
              piece_unlocked.begin());
}

void take_tensions(const CordParts& whole, const Columns& columns, CordParts& piece) {
  std::size_t from = 0;
  std::size_t to = 0;
  for (std::size_t term = 0; term < piece.elasticity->terms(); ++term) {
    const std::size_t all = whole.elasticity->tension_count(term);
    const std::size_t count = piece.elasticity->tension_count(term);
    const std::size_t per_column = columns.is_whole() ? 0 : (all - count) / at(columns.all - columns.size());
    for (std::size_t k = 0; k < count; ++k) {
      piece.state.tensions[to + k] = whole.state.tensions[from + at(columns.first) * per_column + k];
    }
    from += all;
    to += count;
  }
}

/// The pulleys of which all points are in the piece. A cut at a wheel takes the cord off it.
void take_pulleys(const CordParts& whole, const Columns& columns, CordParts& piece) {
  for (Pulley pulley : whole.state.pulleys) {
    if (pulley.def.before < columns.first || pulley.def.after > columns.last) continue;
    pulley.def.before -= columns.first;
    pulley.def.after -= columns.first;
    piece.state.pulleys.push_back(pulley);
  }
  piece.leave_out_links_on_wheels();
}

/// At the cut only one piece keeps what was attached. Its own masses are those of its definition to the last bit, by
/// which it is made again when a state is restored.
void take_attachments(const CordParts& whole, const CutPlace& where, int side, const Columns& columns,
                      CordParts& piece) {
  const bool keeps = where.side_of(where.column) == side;
  const int shift = columns.first * columns.rows;
  const int cut = where.column * columns.rows;
  for (int p = 0; p < static_cast<int>(piece.size()); ++p) {
    const std::size_t old = at(p + shift);
    const bool is_cut = p + shift >= cut && p + shift < cut + columns.rows;
    const double attached = is_cut && !keeps ? 0.0 : whole.state.masses[old] - whole.own_masses[old];
    piece.state.masses[at(p)] = piece.own_masses[at(p)] + attached;
    piece.state.kinds[at(p)] = is_cut && !keeps ? PointKind::free : whole.state.kinds[old];
    piece.state.targets[at(p)] = whole.state.targets[old];
    if (is_cut && !keeps && !piece.state.loads.empty()) piece.state.loads[at(p)] = {};
  }
}

void take_touches(const CordParts& whole, const CutPlace& where, int side, CordParts& piece) {
  if (whole.def.rows > 1) return;  // the outline of a ribbon is another one
  for (Touch touch : whole.state.touches) {
    const PieceFeature after = feature_after(where, touch.feature, whole.def.points);
    if (after.side != side) continue;
    touch.feature = after.feature;
    piece.state.touches.push_back(touch);
  }
}

/// Each piece has its share of the energies. What follows a cut is not smooth, so no piece may gain energy.
void take_energies_and_origin(const Cord::State& from, const Columns& columns, Cord::State& to) {
  const double share = static_cast<double>(columns.links()) / (columns.all - 1);
  to.regainable_energy = std::min(0.0, share * from.regainable_energy);
  to.energy_drift = share * from.energy_drift;
  to.damping_excluded = from.damping_excluded;
  to.depenetration_share = from.depenetration_share;
  to.newton_pause = from.newton_pause;
  to.family = from.family;
  to.split = from.split;
  if (columns.first == 0) to.joined_first = from.joined_first;
  if (columns.last == columns.all - 1) to.joined_last = from.joined_last;
}

std::optional<Cord> piece_of(const Cord& cord, const CutPlace& where, int side, std::optional<Cord> memory) {
  if (where.is_along()) return std::optional<Cord>(std::in_place, split_piece(cord.parts(), where.row, side));
  const Columns columns = columns_of(cord.def(), where, side);
  if (columns.size() < 2) return std::nullopt;
  std::optional<Cord> made = made_of(cord, columns, std::move(memory));
  const CordParts& whole = cord.parts();
  CordParts& piece = made->parts();
  take_points_and_links(whole, columns, piece);
  take_tensions(whole, columns, piece);
  take_attachments(whole, where, side, columns, piece);
  take_touches(whole, where, side, piece);
  take_pulleys(whole, columns, piece);
  take_energies_and_origin(whole.state, columns, piece.state);
  piece.elasticity->set_rest_lengths(piece.state.rest);
  piece.disturb();
  return made;
}

}  // namespace

CutPlace cut_at(const Cord& cord, double arc) {
  const int links = cord.def().points - 1;
  double length = 0.0;
  for (int i = 0; i < links; ++i) length += cord.rest_length(i);
  if (!(arc > 0.0 && arc < length)) {
    refuse("arc", arc, ("a place inside the cord, above 0 and below " + std::to_string(length)).c_str());
  }
  int link = 0;
  while (link + 1 < links && arc > cord.rest_length(link)) arc -= cord.rest_length(link++);
  const double place = link + std::min(1.0, arc / cord.rest_length(link));
  return {static_cast<int>(std::floor(place + 0.5)), place};
}

CutPlace cut_through(const Cord& cord, int link) {
  const int links = cord.def().points - 1;
  check_range("link", link, 0, links - 1);
  if (links == 1) return {-1, 0.5};
  return {link + 1 < links ? link + 1 : link, link + 0.5};
}

CutPlace cut_along(const Cord& cord, int row) {
  const int rows = cord.def().rows;
  if (rows < 3) {
    throw CallError("cut along a row is of a cord with " + std::to_string(rows) + (rows == 1 ? " row" : " rows") +
                    "; accepted is a ribbon of three or more rows");
  }
  check_range("row", row, 1, rows - 2);
  return {0, 0.0, row};
}

CutPieces cut(const Cord& cord, const CutPlace& where) { return cut(cord, where, {}); }

CutPieces cut(const Cord& cord, const CutPlace& where, CutPieces memory) {
  check_range("column of a cut", where.column, -1, cord.def().points - 1);
  if (where.is_along()) (void)cut_along(cord, where.row);
  if (where.column < 0) return {};
  return {piece_of(cord, where, 0, std::move(memory.first)), piece_of(cord, where, 1, std::move(memory.second))};
}

Cord memory_for_piece(int points) {
  CordDef def;
  def.points = points;
  check(def);
  auto parts = std::make_unique<CordParts>(def);
  parts->reserve();
  return Cord(std::move(parts));
}

double place_on_piece(const CutPlace& where, double at, int columns) {
  if (where.side_of(at) == 0) return std::min(at, static_cast<double>(where.column));
  return std::clamp(at - where.column, 0.0, static_cast<double>(columns - 1 - where.column));
}

void join_pieces(CutPieces& pieces, const CutNeighbour& cord) {
  if (!pieces.first || !pieces.second) return;
  Cord::State& first = pieces.first->parts().state;
  Cord::State& second = pieces.second->parts().state;
  if (!cord.where.is_along()) {
    first.joined_last = cord.pieces[1];
    second.joined_first = cord.pieces[0];
  }
  if (first.family == 0) first.family = second.family = cord.id;
}

void follow_cut(Cord& cord, const CutNeighbour& neighbour) {
  Cord::State& state = cord.parts().state;
  if (state.joined_first == neighbour.id) state.joined_first = neighbour.pieces[1];
  if (state.joined_last == neighbour.id) state.joined_last = neighbour.pieces[0];
  std::vector<Touch>& touches = state.touches;
  const auto is_with_it = [&](const Touch& touch) { return touch.other == neighbour.id; };
  if (std::none_of(touches.begin(), touches.end(), is_with_it)) return;
  cord.wake();
  if (neighbour.rows > 1 || neighbour.pieces[0] == 0) {
    touches.erase(std::remove_if(touches.begin(), touches.end(), is_with_it), touches.end());
    return;
  }
  for (Touch& touch : touches) {
    if (!is_with_it(touch)) continue;
    const PieceFeature after = feature_after(neighbour.where, touch.other_feature, neighbour.columns);
    touch.other = neighbour.pieces[after.side];
    touch.other_feature = after.feature;
  }
  std::sort(touches.begin(), touches.end(), [](const Touch& a, const Touch& b) { return a.place_before(b); });
}

}  // namespace ribbon
