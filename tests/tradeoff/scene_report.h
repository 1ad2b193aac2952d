#pragma once

#include <vector>

#include "tests/study/report.h"
#include "tests/tradeoff/scenes.h"

namespace tradeoff {

/// What a scene came to, for a page and a plot: its error is the column rms_error_m if it has one. What did not
/// converge or has no number counts as failed.
study::Report report_of(const Scene& scene, const std::vector<Row>& rows);

}  // namespace tradeoff
