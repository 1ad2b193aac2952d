#pragma once

#include <vector>

#include "tests/study/report.h"
#include "tests/tradeoff/scenes.h"

namespace tradeoff {

/// What a scene came to, for a page and plots: its error is the first that it has of the columns rms_error_m,
/// stretch_error_m, creep_95pct_m and penetration_m, of which what is below a micrometre counts as one; each other kind
/// of error is a plot of its own. What blew up (a point was lost, or energy rose by more than all weight times the
/// longest cord), let something through, or did not converge in any tick counts as failed. Where a method that is none
/// of our cords is better, a note says so.
study::Report report_of(const Scene& scene, const std::vector<Row>& rows);

}  // namespace tradeoff
