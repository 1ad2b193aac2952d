#include <memory>

#include "tests/support/reference_scenes.h"
#include "tests/support/thesis_scenes.h"
#include "tests/tradeoff/scene_lists.h"

namespace tradeoff {
namespace {

using ribbon::Accuracy;
using ribbon::Cord;
using ribbon::CordDef;
using ribbon::Vec2;
using test_support::earth_gravity;
using test_support::frame_dt;

/// Times a copy of the cord from its start, with ticks of 1/60 s.
Variant variant(std::string setting, const Cord& start, Vec2 gravity, std::function<std::vector<double>()> figures) {
  const auto cord = std::make_shared<Cord>(start.def());
  const auto state = std::make_shared<Cord::State>(start.save());
  const auto work = std::make_shared<std::int64_t>();
  cord->restore(*state);
  return {start.def().rows == 1 ? "rope" : "ribbon",
          std::move(setting),
          cord->size(),
          [cord, state] { cord->restore(*state); },
          [cord, gravity, work] { *work = cord->step(frame_dt, gravity).work; },
          std::move(figures),
          {},
          {},
          [work] { return *work; }};
}

double relative(double found, double exact) { return found / exact - 1.0; }

Variant hanging_cord(const test_support::Catenary& exact) {
  constexpr int links = 100;
  const CordDef def = test_support::hanging_between_pins(exact, links);
  return variant("L/D=" + number(exact.slackness) + " wL/EA=" + number(exact.give), Cord(def), earth_gravity,
                 [def, exact] {
                   CordDef tight = def;
                   tight.accuracy = test_support::tight();
                   Cord cord(tight);
                   test_support::come_to_rest(cord, earth_gravity);
                   const auto found = test_support::shape_of(cord);
                   const auto lumped = test_support::lumped_shape(exact, links);
                   return std::vector{relative(found.sag, exact.sag), relative(found.tension, exact.tension),
                                      relative(found.sag, lumped.sag), relative(found.tension, lumped.tension)};
                 });
}

std::vector<Variant> catenary() {
  std::vector<Variant> list;
  for (const auto& exact : test_support::catenaries) list.push_back(hanging_cord(exact));
  return list;
}

Variant bent_cord(int columns, int rows, double width, const test_support::Cantilever& exact) {
  std::string setting = std::to_string(columns) + "x" + std::to_string(rows) + " PL2/EI=" + number(exact.load);
  if (rows > 1) setting += " L/width=" + number(1.0 / width);
  const auto make = [=](const Accuracy& accuracy) {
    return test_support::clamped_beam(columns, rows, width, exact, accuracy);
  };
  return variant(setting, make(Accuracy::balanced()), {}, [make, exact] {
    Cord cord = make(test_support::tight());
    test_support::come_to_rest(cord, {});
    const auto found = test_support::bent(cord, exact.load);
    return std::vector{found.down - exact.down, found.inward - exact.inward};
  });
}

std::vector<Variant> cantilever() {
  std::vector<Variant> list;
  for (const auto& exact : test_support::cantilevers) {
    if (exact.load != 1.0 && exact.load != 5.0 && exact.load != 10.0) continue;
    list.push_back(bent_cord(51, 1, 0.0, exact));
    for (const double width : {0.05, 0.01}) {
      for (const int rows : {2, 3, 5}) list.push_back(bent_cord(20, rows, width, exact));
    }
  }
  return list;
}

Variant swung(const std::string& setting, const Accuracy& accuracy) {
  return variant(setting, test_support::swung_chain(0, accuracy), earth_gravity, [accuracy] {
    std::vector<double> errors;
    for (int mode = 0; mode < 3; ++mode) {
      Cord chain = test_support::swung_chain(mode, accuracy);
      errors.push_back(relative(test_support::measured_frequency(chain, mode, 5, frame_dt),
                                test_support::hanging_frequencies[static_cast<std::size_t>(mode)]));
    }
    return errors;
  });
}

std::vector<Variant> hanging_modes() {
  std::vector<Variant> list = {swung("fast", Accuracy::fast()), swung("balanced", Accuracy::balanced()),
                               swung("accurate", Accuracy::accurate())};
  for (const int substeps : {16, 64}) {
    list.push_back(swung("substeps=" + std::to_string(substeps), {ribbon::Integrator::tr_bdf2, substeps, 12, 1e-6}));
  }
  return list;
}

Variant thrown_cord(const std::string& setting, const CordDef& def, double speed, double heavy_mass) {
  const Cord start = test_support::thrown(def, speed, heavy_mass);
  return variant(setting, start, {}, [start_def = def, speed, heavy_mass] {
    Cord cord = test_support::thrown(start_def, speed, heavy_mass);
    const Vec2 before = test_support::momentum(cord);
    for (int k = 0; k < 300; ++k) cord.step(frame_dt, {});
    return std::vector{length(test_support::momentum(cord) - before) / length(before)};
  });
}

std::vector<Variant> free_flight() {
  CordDef rope;
  CordDef bending = rope;
  bending.bending_stiffness = 1.0;
  CordDef ribbon;
  ribbon.points = 25;
  ribbon.rows = 2;
  ribbon.length = 1.2;
  ribbon.width = 0.05;
  ribbon::solid(1e6, 0.3, 0.01, ribbon.width).apply_to(ribbon);
  CordDef broad = ribbon;
  broad.points = 10;
  broad.rows = 5;
  broad.length = 0.45;
  broad.width = 0.2;
  ribbon::solid(1e5, 0.3, 0.01, broad.width).apply_to(broad);
  return {thrown_cord("51x1", rope, 1.0, 30.0), thrown_cord("51x1 bending", bending, 1.0, 30.0),
          thrown_cord("25x2", ribbon, 0.1, 1.0), thrown_cord("10x5", broad, 0.1, 1.0)};
}

}  // namespace

std::vector<Scene> reference_scenes() {
  return {
      {"catenary",
       "100 links at rest between two pins: error of sag and tension, of the continuous and the lumped solution",
       60,
       catenary,
       {us_per_tick(), p99_us(), figure("sag_error", 0), figure("tension_error", 1), figure("lumped_sag_error", 2),
        figure("lumped_tension_error", 3)}},
      {"cantilever",
       "a clamped rope and ribbons at rest under a load at the tip: error of its way down and inward",
       60,
       cantilever,
       {us_per_tick(), p99_us(), figure("down_error_of_length", 0), figure("inward_error_of_length", 1)}},
      {"hanging_modes",
       "ten masses on a chain, small swings: error of the first three frequencies over five periods",
       300,
       hanging_modes,
       {us_per_tick(), p99_us(), figure("mode_1_error", 0), figure("mode_2_error", 1), figure("mode_3_error", 2)},
       "balanced"},
      {"free_flight",
       "cords and ribbons thrown without gravity: drift of the momentum in five seconds",
       300,
       free_flight,
       {us_per_tick(), p99_us(), figure("momentum_drift", 0)}},
  };
}

}  // namespace tradeoff
