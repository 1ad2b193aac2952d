#pragma once

#include <vector>

#include "tests/study/report.h"
#include "tests/tradeoff/scenes.h"

namespace tradeoff {

/// What a scene came to, for a page and plots: its error is the column rms_error_m if it has one, and penetration_m if
/// not; stretch, energy and the error against its own converged motion are plots of their own. What did not converge
/// counts as failed. Where a method that is none of our cords is ahead, a note says so.
study::Report report_of(const Scene& scene, const std::vector<Row>& rows);

}  // namespace tradeoff
