#pragma once

#include <memory>

#include "ribbon/system/cord_parts.h"

namespace ribbon {

/// Returns a piece of a ribbon of three or more rows that is cut along an inner row. Its points become two rows, each
/// with the mass of its own side, so nothing moves. Side 0 has the rows up to it and what is attached to it, side 1 has
/// the rows from it on; a pin in the row holds both.
///
/// The piece has its share of EA, of the mass and of the breaking force, in proportion to its width, and of EI, in
/// proportion to the cube of it. So the cells of a solid strip, EI = EA·width²/12, stay as they are, with their energy.
/// A ribbon with a smaller EI has a spine of bars along its middle line, and the piece has one along its own, which is
/// longer or shorter if the ribbon is bent: each link of the piece gets the rest length at which its middle line is
/// strained as that of the ribbon was.
std::unique_ptr<CordParts> split_piece(const CordParts& whole, int row, int side);

}  // namespace ribbon
