#pragma once

/// @file
/// All of the library that is meant for users. The headers can be included separately too.

#include "ribbon/box.h"
#include "ribbon/cord.h"
#include "ribbon/cord_def.h"
#include "ribbon/cord_forces.h"
#include "ribbon/cord_line.h"
#include "ribbon/cord_sweep.h"
#include "ribbon/cut.h"
#include "ribbon/definition.h"
#include "ribbon/direct_solver.h"
#include "ribbon/error_probe.h"
#include "ribbon/island_cord.h"
#include "ribbon/layout.h"
#include "ribbon/medium.h"
#include "ribbon/parallel_for.h"
#include "ribbon/pulley.h"
#include "ribbon/reports.h"
#include "ribbon/rigid_circle.h"
#include "ribbon/smooth_line.h"
#include "ribbon/thesis/thesis_cord.h"
#include "ribbon/tie.h"
#include "ribbon/touch.h"
#include "ribbon/vec2.h"
#include "ribbon/version.h"
#include "ribbon/weather.h"
