#include "tests/study/level_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <set>

#include "engine/replay/replay.h"
#include "game/simulation/buttons.h"
#include "tests/study/command.h"
#include "tests/study/level_study_fixture.h"
#include "tests/study/results.h"
#include "tests/study/trace_file.h"
#include "tests/support/refusal.h"

namespace study {
namespace {

using test_support::refusal;

bool is_same_number(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

TEST(Setting, AGridHasEachSettingOnce) {
  for (const bool quick : {false, true}) {
    std::set<std::string> names;
    for (const Setting& setting : grid(quick)) EXPECT_TRUE(names.insert(setting.solver + name_of(setting)).second);
    EXPECT_GE(names.size(), quick ? 8U : 25U);
  }
}

TEST_F(LevelStudy, ALevelGetsTheSettingAndNoOtherChange) {
  const LevelFile file(level_path);
  const game::Level level = file.with(Setting{"direct", "implicit_euler", 3, 1e-6, 2.0});
  const auto changed = level.make_scene();
  const auto before = file.level().make_scene();
  for (int c = 0; c < changed->coupling().size(); ++c) {
    const ribbon::CordDef& def = changed->coupling().cord(c).direct().def();
    const ribbon::CordDef& old = before->coupling().cord(c).direct().def();
    EXPECT_EQ(def.accuracy.integrator, ribbon::Integrator::implicit_euler);
    EXPECT_EQ(def.accuracy.substeps, 3);
    EXPECT_EQ(def.accuracy.tolerance, 1e-6);
    EXPECT_EQ(def.points - 1, 2 * (old.points - 1));
    EXPECT_EQ(def.friction, old.friction);
    EXPECT_EQ(def.bending_stiffness, old.bending_stiffness);
  }
  EXPECT_EQ(file.with(Setting{"direct", "tr_bdf2", 1, 5e-4, 1.0, 32})
                .make_scene()
                ->coupling()
                .cord(0)
                .direct()
                .def()
                .accuracy,
            (ribbon::Accuracy{ribbon::Integrator::tr_bdf2, 1, 32, 5e-4}));
  const auto thesis = file.with(Setting{"thesis", "", 4, 0.0}).make_scene();
  EXPECT_EQ(thesis->coupling().cord(0).solver(), ribbon::box2d::Solver::thesis);
  EXPECT_EQ(thesis->coupling().cord(0).thesis().def().substeps, 4);
}

TEST_F(LevelStudy, ARibbonInPlaceOfARopeHasItsMassBendingAndThickness) {
  const LevelFile file(TEST_ASSETS "/levels/first_swing.tmj");
  const auto ropes = file.level().make_scene();
  for (const int rows : {2, 3}) {
    const game::Level level = file.with(Setting{"direct", "tr_bdf2", 1, 5e-4, 1.0, 0, rows});
    const auto ribbons = level.make_scene();
    for (int c = 0; c < ropes->coupling().size(); ++c) {
      const ribbon::CordDef& is = ribbons->coupling().cord(c).direct().def();
      const ribbon::CordDef& was = ropes->coupling().cord(c).direct().def();
      EXPECT_EQ(is.rows, rows);
      EXPECT_EQ(is.points, was.points);
      EXPECT_EQ(is.mass_per_length, was.mass_per_length);
      EXPECT_EQ(is.bending_stiffness, was.bending_stiffness);
      EXPECT_NEAR(is.width + 2.0 * is.radius, 2.0 * was.radius, 1e-15);
      EXPECT_EQ(is.stretch_stiffness, file.ribbon_stiffness());
    }
    engine::TickInput right;
    right.buttons = game::button_right | game::button_grab;
    std::vector<engine::TickInput> inputs(100, right);
    for (std::size_t k = 50; k < 100; ++k) inputs[k].buttons |= game::button_jump;
    const Trace trace = run(level, inputs);
    // Of three rows the player pulls the middle one, and the soft outer ones yield. Two rows oscillate along their
    // length for some ticks after a catch.
    int overstretched = 0;
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      const double stretch = rows == 2 ? trace.stretch[k] : trace.figures[k].tension / file.ribbon_stiffness();
      overstretched += stretch < 2e-4 ? 0 : 1;
    }
    // A catch takes three ticks with the tension of an impulse; it begins between two points.
    EXPECT_LE(overstretched, 3 * (rows - 2));
    EXPECT_GT(trace.player.back().y, 6.5);  // the player hangs on one
  }
}

TEST_F(LevelStudy, AnAppliedSettingIsInTheFile) {
  LevelFile(level_path).apply(Setting{"direct", "tr_bdf2", 2, 1e-5});
  const auto scene = game::load_level(level_path).make_scene();
  EXPECT_EQ(scene->coupling().cord(0).direct().def().accuracy.substeps, 2);
  EXPECT_EQ(scene->coupling().cord(0).direct().def().accuracy.tolerance, 1e-5);
  EXPECT_EQ(LevelFile(level_path).declares("friction"), true);
  const std::string before = read_file(level_path);
  EXPECT_THROW(LevelFile(level_path).apply(Setting{"direct", "tr_bdf2", 0, 1e-5}), engine::MapError);
  EXPECT_EQ(read_file(level_path), before);
}

TEST_F(LevelStudy, MoreSubstepsAndLessToleranceAreMoreExact) {
  const Study study = measure(LevelFile(level_path), replay_path, options());
  ASSERT_TRUE(study.complete);
  const auto error_of = [&](const Setting& setting) {
    const auto found = std::find_if(study.settings.begin(), study.settings.end(),
                                    [&](const Measured& m) { return m.setting == setting; });
    return found->error.position_m;
  };
  const double one = error_of({});
  const double four = error_of({"direct", "tr_bdf2", 4, 1e-4});
  EXPECT_NEAR(std::log(one / four) / std::log(4.0), 2.0, 0.4);  // the order of the integrator
  const double euler = error_of({"direct", "implicit_euler", 1, 5e-4});
  const double euler_four = error_of({"direct", "implicit_euler", 4, 5e-4});
  EXPECT_NEAR(std::log(euler / euler_four) / std::log(4.0), 1.0, 0.2);
  EXPECT_LT(study.references[0].agreement_m, 0.1 * four);
  for (const Measured& m : study.settings) {
    EXPECT_GT(m.least_us, 0.0);
    if (m.setting.solver == "direct") {
      EXPECT_GE(m.cost_us, m.least_us);
    }
    EXPECT_GE(m.point().error_m, m.resolution_m);
  }
}

/// Compares everything that does not depend on the clock.
void expect_the_same(const Measured& a, const Measured& b) {
  for (const auto member : {&Errors::position_m, &Errors::position_relative, &Errors::player_m, &Errors::stretch,
                            &Errors::tension, &Errors::penetration, &Errors::energy, &Errors::momentum}) {
    EXPECT_PRED2(is_same_number, a.error.*member, b.error.*member);
    EXPECT_PRED2(is_same_number, a.mesh.*member, b.mesh.*member);
  }
  for (std::size_t k = 0; k < Statistics::count; ++k) {
    EXPECT_PRED2(is_same_number, a.chaotic.values[k], b.chaotic.values[k]);
  }
  EXPECT_EQ(a.resolution_m, b.resolution_m);
  EXPECT_EQ(a.work.iterations, b.work.iterations);
  EXPECT_EQ(a.work.work, b.work.work);
  EXPECT_EQ(a.work.posed, b.work.posed);
  EXPECT_EQ(a.unconverged_ticks, b.unconverged_ticks);
  EXPECT_EQ(a.contacts, b.contacts);
  EXPECT_EQ(a.failure, b.failure);
}

TEST_F(LevelStudy, AnInterruptedStudyContinues) {
  StudyOptions elsewhere = options();
  elsewhere.folder = home + "/other_report";
  const Study uninterrupted = measure(LevelFile(level_path), replay_path, elsewhere);
  const int all_runs = 4 + static_cast<int>(grid(true).size());  // the present setting is run first
  EXPECT_EQ(uninterrupted.runs, all_runs);

  int runs = 0;
  const auto run_until = [&](int most_asked) {
    StudyOptions stops = options();
    int asked = 0;
    stops.stopped = [&asked, most_asked] { return ++asked > most_asked; };
    Study study = measure(LevelFile(level_path), replay_path, stops);
    runs += study.runs;
    return study;
  };
  EXPECT_FALSE(run_until(1).complete);  // after the present setting and both kicked runs, before the converged ones
  EXPECT_GT(runs, 0);
  EXPECT_LT(runs, 4);
  const Study half = run_until(8);
  EXPECT_FALSE(half.complete);
  ASSERT_GT(half.settings.size(), 0U);
  const std::string path = options().folder + "/results.jsonl";
  const std::string kept = read_file(path);
  EXPECT_EQ(static_cast<std::size_t>(std::count(kept.begin(), kept.end(), '\n')), half.settings.size());

  std::ofstream(path, std::ios::app) << "{\"key\": \"half a li";
  std::ofstream(path, std::ios::app) << '\n';
  const Study whole = run_until(1000);
  EXPECT_TRUE(whole.complete);
  EXPECT_EQ(runs, all_runs);  // nothing was run again
  ASSERT_EQ(whole.settings.size(), grid(true).size());
  for (std::size_t k = 0; k < whole.settings.size(); ++k) {
    expect_the_same(whole.settings[k], uninterrupted.settings[k]);
  }
  EXPECT_EQ(whole.references[0].agreement_m, uninterrupted.references[0].agreement_m);
  EXPECT_EQ(read_file(path).find(kept), 0U);
  const std::string all = read_file(path);
  EXPECT_EQ(static_cast<std::size_t>(std::count(all.begin(), all.end(), '\n')), grid(true).size() + 1);
}

TEST(WorkFigures, AreThoseOfTheTicks) {
  const std::array<std::int64_t, 5> ticks = {1, 2, 3, 4, 90};
  const WorkFigures figures = figures_of(ticks);
  EXPECT_EQ(figures.mean, 20.0);
  EXPECT_EQ(figures.p99, 4.0);
  EXPECT_EQ(figures.most, 90.0);
  EXPECT_TRUE(std::isnan(figures_of({}).mean));
}

/// A cord falls on the ground, with a budget of one unit of work.
TEST_F(LevelStudy, WhatSpendsItsBudgetIsMeasuredAgainWithAnAmpleOne) {
  leave_a_loose_cord();
  change_level(level_path, [](Json& cord) {
    cord["properties"].push_back({{"name", "max_work"}, {"type", "int"}, {"value", 1}});
  });
  StudyOptions some = options();
  some.folder.clear();
  some.grid = {present(), {"direct", "tr_bdf2", 4, 1e-4}};
  some.repeats = 3;
  std::vector<double> shares;
  some.progress = [&shares](double share, double) { shares.push_back(share); };
  const std::vector<engine::TickInput> inputs(30);
  const Study study = measure(LevelFile(level_path), inputs, some);
  EXPECT_EQ(std::count_if(shares.begin(), shares.end(), [](double share) { return share > 0.999; }), 1)
      << "the bar is full when all is done";
  ASSERT_EQ(study.settings.size(), 3U);  // the present one stays as it is
  EXPECT_TRUE(spends_budget(study.settings[1]));
  EXPECT_EQ(study.settings[2].setting, with_ample_work(some.grid[1]));
  EXPECT_FALSE(spends_budget(study.settings[2]));
  some.ample_budgets = false;
  EXPECT_EQ(measure(LevelFile(level_path), inputs, some).settings.size(), 2U);
}

TEST_F(LevelStudy, ASettingIsSavedWithAllItsNumbers) {
  Measured measured;
  measured.setting.max_work = ample_work;
  measured.windows.spends_budget = true;
  measured.others.spends_budget = true;
  measured.error = {1.0, 2.0, 3.0, 4.0, unavailable, 6.0, 7.0, 8.0};
  measured.mesh = {11.0, 12.0, 13.0, 14.0, 15.0, 16.0, unavailable, 18.0};
  measured.chaotic.values = {21.0, 22.0, unavailable, 24.0, 25.0, 26.0};
  measured.resolution_m = 0.1;
  measured.tick_work = {41.0, 42.0, 43.0};
  measured.others.work = {51.0, 52.0, 53.0};
  measured.work.work = 12345;
  measured.work.posed = 6;
  measured.unconverged_ticks = 31;
  measured.contacts = 77;
  measured.failure = "31 ticks not converged";
  Results(home + "/saved", 1, replay_path, false).add(measured);
  const Results again(home + "/saved", 1, replay_path, false);
  EXPECT_EQ(again.find({}), nullptr);  // it has another budget
  const Measured* saved = again.find(measured.setting);
  ASSERT_NE(saved, nullptr);
  expect_the_same(*saved, measured);
  EXPECT_EQ(saved->tick_work.most, 43.0);
  EXPECT_EQ(saved->others.work.most, 53.0);
  EXPECT_TRUE(saved->windows.spends_budget);
  EXPECT_TRUE(saved->others.spends_budget);
  EXPECT_EQ(Results(home + "/saved", 1, replay_path, true).find(measured.setting),
            nullptr);  // another grid's reference
  EXPECT_EQ(Results(home + "/saved", 2, replay_path, false).find(measured.setting), nullptr);
}

/// A folder may have the runs of several levels.
TEST_F(LevelStudy, ARunIsSavedForItsLevelOnly) {
  const std::string folder = home + "/saved";
  const Trace trace = run(game::load_level(level_path), std::vector<engine::TickInput>(2));
  Trace other = trace;
  other.failure = "another";
  Results first(folder, 1, replay_path, false);
  Results second(folder, 2, replay_path, false);
  first.add_run("some", trace);
  second.add_run("some", other);
  ASSERT_TRUE(first.run("some"));
  ASSERT_TRUE(second.run("some"));
  EXPECT_EQ(first.run("some")->failure, "");
  EXPECT_EQ(second.run("some")->failure, "another");
  fs::remove_all(folder);
  EXPECT_NE(refusal<std::runtime_error>([&] { first.add_run("some", trace); }).find("cannot write to"),
            std::string::npos);
}

/// With a small budget of work the converged runs of these ticks are those of one linearised step a tick: two of them
/// agree, and every setting is wrong by centimetres.
TEST(Reference, IsNotReplacedByALinearisedStepWhereACordIsTouched) {
  const LevelFile file(TEST_ASSETS "/levels/curtains.tmj");
  std::vector<engine::TickInput> inputs = inputs_of(engine::load_replay(TEST_ASSETS "/replays/curtains.replay"));
  inputs.resize(312);
  const auto posed = [&](int max_work) {
    Setting setting = reference({}, false, true);
    setting.max_work = max_work;
    return run_part(file.level(), inputs, {297, 15, Windows::lead_in, {accuracy_of(setting)}}).work.posed;
  };
  EXPECT_GT(posed(20), 0);
  EXPECT_EQ(posed(unlimited_work), 0);
  EXPECT_EQ(reference({}, false, true).max_work, unlimited_work);
  EXPECT_EQ(file.with(reference({}, false, true)).make_scene()->coupling().cord(0).direct().def().accuracy.max_work,
            unlimited_work);
}

/// A cord upwards from its pin buckles: its path is not one that a setting could follow.
TEST_F(LevelStudy, ASensitivePathIsNotCompared) {
  const Study steady = measure(LevelFile(level_path), std::vector<engine::TickInput>(20), options());
  EXPECT_EQ(steady.references[0].ticks, 20U);
  change_level(level_path, [](Json& cord) {
    cord["polyline"] = {{{"x", 0}, {"y", 0}}, {{"x", 1}, {"y", -160}}};
    cord["properties"].push_back({{"name", "stretch_stiffness"}, {"type", "float"}, {"value", 1e4}});
  });
  const Study sensitive = measure(LevelFile(level_path), std::vector<engine::TickInput>(20), options());
  EXPECT_LT(sensitive.references[0].ticks, 20U);
  EXPECT_GT(sensitive.references[0].ticks, 0U);
}

TEST_F(LevelStudy, AConvergedRunIsSavedToTheSameBits) {
  const std::string path = home + "/some.run";
  const std::vector<engine::TickInput> inputs(5);
  Trace trace = run(game::load_level(level_path), inputs);
  trace.failure = "blew up in tick 5";
  ASSERT_TRUE(save_trace(trace, "this one", path));
  const auto again = load_trace("this one", path);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->lengths, trace.lengths);
  EXPECT_EQ(again->places, trace.places);
  EXPECT_EQ(again->player, trace.player);
  EXPECT_EQ(again->stretch, trace.stretch);
  EXPECT_EQ(again->figures.back().energy, trace.figures.back().energy);
  EXPECT_EQ(again->declared, trace.declared);
  EXPECT_EQ(again->crossings, trace.crossings);
  EXPECT_EQ(again->mass, trace.mass);
  EXPECT_EQ(again->gravity, trace.gravity);
  EXPECT_EQ(again->work, trace.work);
  EXPECT_EQ(again->failure, trace.failure);
  EXPECT_FALSE(load_trace("another", path));
  EXPECT_FALSE(load_trace("this one", home + "/no.run"));
  const std::string content = read_file(path);
  std::string changed = content;
  changed[content.size() / 2] = static_cast<char>(changed[content.size() / 2] ^ 1);
  for (const std::string& broken : {content.substr(0, content.size() / 2), content + "x", changed, std::string()}) {
    std::ofstream(path, std::ios::binary) << broken;
    EXPECT_FALSE(load_trace("this one", path));
  }
}

TEST(Failure, IsInstabilityPenetrationOrNonconvergence) {
  Trace reference;
  reference.declared = {through_body};
  reference.crossings.assign(10, {0});
  Trace trace = reference;
  EXPECT_EQ(failure_of(trace, reference, 10), "");
  trace.unconverged_ticks = 1;
  EXPECT_EQ(failure_of(trace, reference, 10), "1 tick not converged");
  trace.unconverged_ticks = 2;
  EXPECT_EQ(failure_of(trace, reference, 10), "2 ticks not converged");
  trace.crossings[4] = {through_body};
  EXPECT_EQ(failure_of(trace, reference, 10), "cord 1 went through a body in tick 5");
  EXPECT_EQ(failure_of(trace, trace, 10), "2 ticks not converged");  // the reference also lets it through
  trace.failure = "blew up in tick 6";
  EXPECT_EQ(failure_of(trace, reference, 10), "blew up in tick 6");
}

/// Cords of the thesis collide with circles, but not with the ground: released above it, they fall through.
TEST_F(LevelStudy, ACordThatFallsThroughTheGroundHasFailed) {
  leave_a_loose_cord();
  record(replay_path, 30);
  const Study study = measure(LevelFile(level_path), replay_path, options());
  for (const Measured& m : study.settings) {
    const bool passed = m.failure.find("went through a body in tick") != std::string::npos;
    EXPECT_EQ(passed, m.setting.solver == "thesis") << name_of(m.setting) << ": " << m.failure;
  }
}

TEST_F(LevelStudy, RefusesInvalidInput) {
  const LevelFile file(level_path);
  record(home + "/none.replay", 0);
  EXPECT_NE(refusal<std::exception>([&] { measure(file, home + "/none.replay", options()); }).find("has no ticks"),
            std::string::npos);
  EXPECT_NE(refusal<std::exception>([&] { measure(file, home + "/absent.replay", options()); }).find("absent.replay"),
            std::string::npos);
  StudyOptions nowhere = options();
  nowhere.folder = level_path + "/inside";
  EXPECT_NE(refusal<std::exception>([&] { measure(file, replay_path, nowhere); }).find("cannot write to"),
            std::string::npos);
  Command command;
  command.level = level_path;
  EXPECT_NE(refusal<std::exception>([&] { run(command); }).find("no --replay given"), std::string::npos);
  EXPECT_NE(refusal<std::exception>([&] { LevelFile(home + "/absent.tmj"); }).find("absent.tmj"), std::string::npos);
  // No line arrives in the first two ticks of a level that has nothing else.
  const LevelFile lines(TEST_ASSETS "/levels/long_line.tmj");
  EXPECT_NE(refusal<engine::MapError>([&] {
              measure(lines, std::vector<engine::TickInput>(2), options());
            }).find("nothing to study: no cord exists in any tick"),
            std::string::npos);
  EXPECT_NE(refusal<std::exception>([&] { lines.apply(Setting{}); }).find("has no cord that the setting"),
            std::string::npos);
}

}  // namespace
}  // namespace study
