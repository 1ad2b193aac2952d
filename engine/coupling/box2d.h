#pragma once

/// @file
/// All of the coupling of cords with Box2D. The headers can be included separately too.

#include "ribbon/box2d/contact_listener.h"
#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/cord_queries.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/coupling_state.h"
#include "ribbon/box2d/coupling_types.h"
#include "ribbon/box2d/debug_draw.h"
#include "ribbon/box2d/handles.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/box2d/step_watcher.h"
#include "ribbon/box2d/world_snapshot.h"
