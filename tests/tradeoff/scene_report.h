#pragma once

#include <vector>

#include "tests/study/report.h"
#include "tests/tradeoff/scenes.h"

namespace tradeoff {

/// Returns the results of a scene for a page and plots. The error is the first existing one of the columns rms_error_m,
/// stretch_error_m, creep_95pct_m and penetration_m; values below a micrometre count as one. Each other kind of error
/// has its own plot. A run failed if it was unstable (a lost point, or an energy gain above total weight times the
/// longest cord), tunnelled, or did not converge in any tick. A note says where a method other than ours is
/// better.
study::Report report_of(const Scene& scene, const std::vector<Row>& rows);

}  // namespace tradeoff
