#pragma once

#include "ribbon/cord.h"

namespace ribbon {

// In this order, with some time between: each reads what the one before it fetches.

/// Starts to fetch the object of a cord.
void fetch_cord(const Cord& cord);
/// Starts to fetch what a cord consists of: where its lists are.
void fetch_parts(const Cord& cord);
/// Starts to fetch the lists that each step of a cord that is awake reads.
void fetch_lists(const Cord& cord);

}  // namespace ribbon
