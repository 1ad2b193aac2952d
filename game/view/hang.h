#pragma once

#include "game/view/pose.h"

namespace game {

/// Sets the pose of a figure that hangs from its cord. Precondition: state.cord.
void hang(Pose& pose, const FigureState& state);

/// Returns the hand that holds the cord if only one does: the far one while the near one throws or cheers.
std::size_t holding_hand(const FigureState& state);

}  // namespace game
