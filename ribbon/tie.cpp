#include "ribbon/tie.h"

#include "ribbon/system/tie_groups.h"

namespace ribbon {

void check_ties(std::span<const Tie> ties, std::span<const int> points) { TieGroups().find(ties, points); }

}  // namespace ribbon
