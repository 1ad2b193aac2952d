#pragma once

#include <cstdint>
#include <optional>

#include "ribbon/cord.h"

// Cuts of a cord into two. With a coupling, CordRef::cut does all of this.

namespace ribbon {

/// Where a cord is cut: across at a column, or a ribbon along a row from its first column to its last one. Each point
/// of this column or row becomes two points, with the mass of their own sides. So a cut halves the mass of a rope's
/// point and moves nothing. What is attached to the cord goes to the side that it is on. Side 0 has the first column or
/// row, side 1 the last one. A side of less than two columns is dust: it does not become a piece.
struct CutPlace {
  int column = 0;  ///< of the points that are doubled, 0 … columns − 1; −1 for a broken cord of one link, all dust
  double place = 0.0;  ///< columns from the first one
  int row = 0;         ///< of the points that are doubled by a cut along it, 1 … rows − 2; 0 for a cut across

  bool is_along() const { return row > 0; }  ///< it is along a row
  /// Returns the side of something attached at a place [columns] of a cord that is cut across; at the cut itself it
  /// belongs to side 0.
  int side_of(double at) const { return at <= place ? 0 : 1; }
  /// Returns the side of something attached at a place [columns] of a row; at the cut itself it belongs to side 0.
  int side_of(double at, int at_row) const { return is_along() ? (at_row <= row ? 0 : 1) : side_of(at); }
};

/// Returns the cut at `arc` [m of rest length from the first column]: its column is the nearest one. Throws
/// DefinitionError unless the arc is inside the cord, 0 < arc < its length.
CutPlace cut_at(const Cord& cord, double arc);
/// Returns the cut of a cord whose link from column `link` to the next one breaks in the middle. Its column is an inner
/// one; a cord of one link becomes dust. Throws DefinitionError for an unknown link.
CutPlace cut_through(const Cord& cord, int link);

/// Returns the cut of a ribbon along a row, over its whole length. Throws CallError for a cord of less than three rows,
/// which has no row of points between two rows of cells, and DefinitionError for a row that is not 1 … rows − 2.
CutPlace cut_along(const Cord& cord, int row);

/// The pieces of a cord. One that would be dust does not exist.
struct CutPieces {
  std::optional<Cord> first;   ///< side 0
  std::optional<Cord> second;  ///< side 1
};

/// Returns the pieces of a cord. Momentum is conserved to round-off. The energy falls by that of the bending at the
/// cut; a ribbon of bars (Elements::bars) gains the energy of the bars across it at the cut. If one piece is dust, the
/// other one has all points, without the pins, loads and masses on the side of the dust. Contacts of a rope keep their
/// forces and their sticking friction; those of a ribbon are found anew. The pieces are awake, and the first step of
/// a piece by itself allocates memory. The cord itself does not change. O(points).
///
/// Of a cut along a row, each piece has the part of the mass, of EA and of the breaking forces that its width is of the
/// ribbon's, and of EI the cube of that part. A pin in the row holds both pieces. A solid strip (see `solid`) keeps its
/// energy to round-off, and both pieces are solid strips. A ribbon with a smaller EI has bars along its middle line,
/// and each piece along its own. So that a bent ribbon does not snap apart, each link of a piece gets the rest length
/// at which its middle line is strained as that of the ribbon was; then the energy falls, unless the ribbon is folded
/// by about a right angle in a link. In a ribbon of bars, those along the cut are doubled, and all are softer.
CutPieces cut(const Cord& cord, const CutPlace& where);
/// Does the same in the memory of other cords, which become the pieces. It allocates nothing for a rope without bending
/// stiffness and two cords of memory_for_piece with as many points.
CutPieces cut(const Cord& cord, const CutPlace& where, CutPieces memory);
/// Returns a cord as memory for a piece of a rope with up to `points` points, 2 … 1,000,000. Throws DefinitionError for
/// another number.
Cord memory_for_piece(int points);

/// Returns the place [columns] of something at `at` on its piece, within the piece. `columns` is the number of columns
/// of the uncut cord.
double place_on_piece(const CutPlace& where, double at, int columns);

/// A cord that was cut, for the cords that touch it.
struct CutNeighbour {
  std::uint64_t id = 0;          ///< by which they knew it, IslandCord::id
  CutPlace where;                ///< of the cut
  int columns = 0;               ///< of the uncut cord
  int rows = 1;                  ///< of the uncut cord
  std::uint64_t pieces[2] = {};  ///< ids of its pieces; of dust, that of the other piece; 0 if all is dust
};

/// Tells the pieces of a cord their ids, so that they know each other. They collide with each other if the cord has
/// self_contact, but not at the cut, where their ends overlap: parts that were nearer than three radii in the cord at
/// rest never touch. Pieces of a cord that was cut along a row never touch at all, because their whole edges overlap. A
/// body that holds one piece touches none of them.
void join_pieces(CutPieces& pieces, const CutNeighbour& cord);

/// Updates a cord whose neighbour was cut. Its contacts with a rope become contacts with the pieces of the rope. Its
/// contacts with a ribbon end; the next step finds them anew. If an earlier cut separated it from the neighbour, it now
/// knows the piece that it was joined to. Wakes the cord if it had a contact. Call it also for the pieces of a cord
/// that touched itself.
void follow_cut(Cord& cord, const CutNeighbour& neighbour);

}  // namespace ribbon
