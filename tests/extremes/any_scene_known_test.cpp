#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/extremes/any_scene/runs.h"

// Random scenes that an earlier solver failed: unconverged, stretched, with energy gain or crossed. Each tests one part
// of the solver: without this part the figure exceeds its limit.

namespace any_scene {
namespace {

struct Known {
  const char* part;  ///< the part of the solver
  SceneId which;
  const char* figure;
  double (*value)(const Summary& run);
  double limit;
};

double unconverged(const Summary& run) { return run.unconverged; }
double stretch(const Summary& run) { return run.stretch; }
double gain(const Summary& run) { return run.gain; }
double crossings(const Summary& run) { return run.crossings; }
double crossings_of_bodies(const Summary& run) { return run.crossings_moving + run.crossings_pressed; }
double speed(const Summary& run) { return run.speed; }
double gap(const Summary& run) { return std::max(run.gap, run.gap_pressed); }
double late_stretch(const Summary& run) { return run.late_stretch; }
double hanging(const Summary& run) { return run.hanging; }
double work(const Summary& run) { return run.max_work; }

SceneId gentle(Family family, unsigned seed, Preset preset) { return {seed, family, Difficulty::gentle, preset}; }
SceneId wild(Family family, unsigned seed, Preset preset) { return {seed, family, Difficulty::wild, preset}; }

const Known scenes[] = {
    {"SlippingHandsPressWhereTheyAre", gentle(Family::mixed, 26, Preset::accurate), "gain of energy", gain, 3e-3},
    {"LimitsOfFrictionAreKept", gentle(Family::ribbons_both, 14, Preset::accurate), "unconverged substeps", unconverged,
     6},
    {"LimitsOfFrictionAreKeptInHeaps", gentle(Family::ribbons_both, 2, Preset::accurate), "unconverged substeps",
     unconverged, 6},
    {"WhatGainedGoesBack", gentle(Family::ribbons_both, 17, Preset::accurate), "gain of energy", gain, 3e-3},
    {"WhatIsStretchedGoesBack", gentle(Family::mixed, 16, Preset::balanced), "stretch", stretch, 1e-2},
    {"WhatIsStretchedIsNotStretchedMore", gentle(Family::rope_self, 79, Preset::fast), "stretch", stretch, 1e-2},
    {"WhatIsSolvedIsNotStretched", gentle(Family::rope_self, 118, Preset::fast), "stretch", stretch, 1e-2},
    {"WhatStaysStretchedIsNoSolution", gentle(Family::grips_slip, 2028, Preset::fast), "stretch", stretch, 1e-2},
    {"WhatIsDrivenIsNotStretched", gentle(Family::mixed, 264, Preset::fast), "stretch", stretch, 1e-2},
    {"WhatIsCutShortIsNotCompressed", gentle(Family::mixed, 2043, Preset::balanced), "stretch", stretch, 1e-3},
    {"WhatIsNotSolvedMovesOn", gentle(Family::grips_slip, 2036, Preset::accurate), "unconverged substeps", unconverged,
     30},
    {"WhatIsNotStoppedMovesOn", gentle(Family::grips_slip, 365, Preset::accurate), "ticks that hang", hanging, 10},
    {"HandsThatCannotBeDrawnAreDrawnLess", gentle(Family::grips_slip, 720, Preset::accurate), "ticks that hang",
     hanging, 10},
    {"WhatWouldStopIsTruncated", gentle(Family::ropes_both, 402, Preset::fast), "unconverged substeps", unconverged,
     30},
    {"TruncatedSolvesBeginWithoutImpossibleTensions", gentle(Family::ropes_both, 269, Preset::accurate),
     "unconverged substeps", unconverged, 30},
    {"WhatTheToleranceLeavesIsNoStretch", gentle(Family::ropes_mutual, 34, Preset::balanced), "stretch", stretch, 1e-3},
    {"WhatIsStoppedRegainsItsLength", gentle(Family::mixed, 158, Preset::accurate), "stretch", stretch, 1e-3},
    {"WhatIsTruncatedRegainsItsLength", gentle(Family::rope_self, 68, Preset::accurate), "stretch", stretch, 1e-3},
    {"WhatTheToleranceLeavesIsNoEnergy", gentle(Family::ribbons_both, 84, Preset::fast), "gain of energy", gain, 1e-3},
    {"CellsThatAreTurnedBackGainNoMotion", gentle(Family::ribbons_both, 32, Preset::accurate), "gain of energy", gain,
     1e-3},
    {"CellsThatWouldGainMuchAreNotTurnedBack", gentle(Family::ribbons_both, 57, Preset::balanced), "gain of energy",
     gain, 1e-2},
    {"TiesThatCannotCloseDoNotStretch", gentle(Family::tied, 38, Preset::accurate), "stretch", stretch, 1e-2},
    {"TiesThatCloseAreHeldBackByAllTheyConnect", gentle(Family::tied, 130, Preset::balanced), "stretch", stretch, 1e-2},
    {"ShortPiecesDoNotHideWhatIsStretched", gentle(Family::tied, 82, Preset::balanced), "stretch", stretch, 2e-2},
    {"BeltsDoNotStretch", gentle(Family::belts, 41, Preset::accurate), "stretch", stretch, 1e-2},
    {"LengthsAreRestoredAsLongAsTheyAreWrong", gentle(Family::rope_self, 214, Preset::balanced), "stretch", stretch,
     1e-3},
    {"WhatABodyPressesIsNotPulledOut", gentle(Family::hold_between, 3, Preset::fast), "stretch", stretch, 1e-2},
    {"HandsThatAreHeldUpComeBackSlowly", gentle(Family::grips_slip, 5, Preset::accurate), "gain of energy", gain, 2e-3},
    {"WhatSlipsPastABendIsNotThrown", gentle(Family::grips_slip, 67, Preset::balanced), "gain of energy", gain, 1e-2},
    {"WhatSlipsIsTurnedByABend", gentle(Family::grips_slip, 492, Preset::fast), "gap of a grip, m", gap, 0.02},
    {"WhatSlipsIsTurnedByEachBend", gentle(Family::grips_slip, 466, Preset::accurate), "gap of a grip, m", gap, 0.02},
    {"WhatSlipsFollowsItsCordInATick", gentle(Family::grips_slip, 378, Preset::accurate), "gap of a grip, m", gap, 1.0},
    {"WhatSlipsStaysAtItsCord", gentle(Family::grips_slip, 62, Preset::balanced), "gap of a grip, m", gap, 1.0},
    {"WhatSlipsIsHeldAtTheNearestPlace", gentle(Family::grips_slip, 89, Preset::balanced), "gap of a grip, m", gap,
     1.0},
    {"BlockedHandsDoNoWork", gentle(Family::hold_points, 63, Preset::balanced), "gain of energy", gain, 5e-3},
    {"CordsReturnSlowlyToBlockedAnchors", gentle(Family::hold_between, 104, Preset::accurate), "gain of energy", gain,
     1e-3},
    {"WhatIsPushedTogetherConverges", gentle(Family::mixed, 110, Preset::accurate), "unconverged substeps", unconverged,
     10},
    {"InteriorPointsBeginNearTheirForces", gentle(Family::mixed, 114, Preset::fast), "systems in a tick", work, 110},
    {"NeighboursHaveRoomWherePosed", gentle(Family::ropes_both, 126, Preset::fast), "crossings", crossings, 0},
    {"WhatHasConvergedIsKept", gentle(Family::ropes_both, 128, Preset::accurate), "unconverged substeps", unconverged,
     5},
    {"ReboundsOfWhatIsDrivenThrowNothing", wild(Family::ropes_both, 0, Preset::fast), "m/s", speed, 200},
    {"WhatIsDrawnApartIsNotThrown", wild(Family::rope_self, 10, Preset::balanced), "m/s", speed, 200},
    {"WhatRunsThroughAGrooveIsNotThrown", wild(Family::reeved, 3, Preset::fast), "m/s", speed, 200},
    {"WheelsDriveNothing", gentle(Family::reeved, 63, Preset::fast), "gain of energy", gain, 1e-2},
    {"WhatHasToStopStopsOthers", gentle(Family::heap, 14, Preset::fast), "crossings", crossings, 0},
    {"HeapsKeepTheirEnergyWhileCellsAreTurnedBack", gentle(Family::heap, 29, Preset::fast), "gain of energy", gain,
     5e-4},
    {"LinksOfHeapsKeepTheirLengths", gentle(Family::heap_held, 12, Preset::fast), "stretch", stretch, 0.1},
    {"TensionsOfHeapsAreThoseOfTheirShapes", gentle(Family::heap_held, 5, Preset::balanced), "gain of energy", gain,
     2e-2},
    {"WhatIsTakenBackHasNoForces", gentle(Family::heap_held, 20, Preset::balanced), "gain of energy", gain, 2e-3},
    {"ForcesOfStifferContactsAreForgotten", gentle(Family::heap_held, 18, Preset::fast), "gain of energy", gain, 1e-2},
    {"BalancedHeapsAreTruncated", gentle(Family::heap_held, 6, Preset::balanced), "gain of energy", gain, 1e-3},
    {"KeepersLeaveSomeOfTheCord", gentle(Family::reeved, 39, Preset::balanced), "unconverged substeps", unconverged,
     20},
    {"UntiedPointsPart", gentle(Family::tied, 5, Preset::accurate), "unconverged substeps", unconverged, 30},
    {"CordsThatAreTiedAreNoHeap", gentle(Family::tied, 0, Preset::fast), "unconverged substeps", unconverged, 10},
    {"WhichLinksAreSlackIsPartOfTheSolution", gentle(Family::ropes_both, 102, Preset::balanced), "unconverged substeps",
     unconverged, 25},
    {"TensionsOfWhatIsTornApartStaySmall", wild(Family::hold_points, 34, Preset::fast), "unconverged substeps",
     unconverged, 60},
    {"WhatBox2DPushesTakesTheCordAlong", gentle(Family::hold_points, 16, Preset::balanced), "crossings",
     crossings_of_bodies, 0},
    {"WhatBox2DPushesIsNotExpectedToBePushed", gentle(Family::hold_between, 226, Preset::balanced), "gain of energy",
     gain, 1e-3},
    {"PushesThrowNothing", gentle(Family::ribbon_falls, 97, Preset::balanced), "gain of energy", gain, 1e-3},
    {"WhatIsFarFromSolvedIsNotKept", wild(Family::rope_falls, 25, Preset::balanced), "stretch", stretch, 10},
    {"WhatIsLostIsTruncated", wild(Family::grips_slip, 11, Preset::accurate), "stretch", stretch, 1e3},
    {"WhatWasStretchedIsReeledIn", wild(Family::rope_self, 69, Preset::fast), "stretch after a second", late_stretch,
     1e-2},
    {"WhatWasStretchedIsReeledInBetweenHands", wild(Family::hold_points, 53, Preset::accurate),
     "stretch after a second", late_stretch, 1e-2},
    {"WhatWasStretchedDoesNotHang", wild(Family::hold_points, 53, Preset::accurate), "ticks that hang", hanging, 20},
    {"WhatNeededTheInteriorPointBeginsWithIt", gentle(Family::rope_self, 68, Preset::balanced), "unconverged substeps",
     unconverged, 3},
    {"SeveralAttemptsLeaveFewerSystems", gentle(Family::tied, 29, Preset::accurate), "systems in a tick", work, 330},
    {"WhatTouchesNothingIsPosedInTheEnd", wild(Family::hold_points, 9, Preset::fast), "systems in a tick", work, 400},
};

class KnownScene : public testing::TestWithParam<Known> {};

TEST_P(KnownScene, StaysWithinItsLimit) {
  const Known& known = GetParam();
  const Summary run = run_guarded(known.which, generate(known.which), 60.0);
  ASSERT_EQ(run.end, End::completed);
  EXPECT_LE(known.value(run), known.limit) << known.figure;
}

INSTANTIATE_TEST_SUITE_P(AnyScene, KnownScene, testing::ValuesIn(scenes),
                         [](const auto& known) { return std::string(known.param.part); });

}  // namespace
}  // namespace any_scene
