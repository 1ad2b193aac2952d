#pragma once

#include "ribbon/cord_def.h"

// When an error says something of a setting.

namespace ribbon::study {

/// m. Two converged runs with different substeps differ by at most that where settings are compared with them.
inline constexpr double max_reference_difference = 1e-4;

/// Where the motion is too sensitive, no setting is judged. Two runs with a moderate setting whose velocities differ by
/// twice probe_kick [m/s], about a millimetre in a quarter of a second, must not differ by max_probe_difference [m].
inline constexpr double probe_kick = 2e-3;
/// m, see probe_kick.
inline constexpr double max_probe_difference = 1e-2;

/// Errors below that many times the difference of the converged runs are unknown.
inline constexpr double resolution_per_agreement = 10.0;

/// The share of a limit that a setting may use where it was measured. The rest is a margin for other runs.
inline constexpr double usable_error_share = 0.8;

/// Ticks of a window, and of the lead-in before it.
inline constexpr int window_ticks = 15;

/// The budget of work of what others are compared with. A step that spends its budget where a cord touches something is
/// redone as one linearised step, which is less accurate than one substep, and the same for any number of them.
inline constexpr int unlimited_work = 1'000'000;

/// The setting of all cords in a lead-in. Contacts are compliant, and stiffer with more substeps: without a lead-in, a
/// converged run throws off what presses on the contacts of one substep.
inline constexpr Accuracy lead_in_accuracy{Integrator::tr_bdf2, 16, 8, 1e-6, unlimited_work};

}  // namespace ribbon::study
