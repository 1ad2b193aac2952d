#include <memory>

#include "tests/support/reference_scenes.h"
#include "tests/support/thesis_scenes.h"
#include "tests/tradeoff/scene_lists.h"

namespace tradeoff {
namespace {

using ribbon::Accuracy;
using ribbon::Cord;
using ribbon::CordDef;
using test_support::earth_gravity;
using test_support::frame_dt;

constexpr int ticks_of_terms = 120;

/// A rope of 5 m with links of 0.1 m, released from the horizontal, with a load of the rope's mass at its end.
CordDef swinging() {
  CordDef def;
  def.length = 5.0;
  def.pins = {0};
  return def;
}

/// A ribbon that is held by its first column.
CordDef strip(int rows) {
  CordDef def = swinging();
  def.rows = rows;
  def.width = 0.1 * (rows - 1);
  ribbon::solid(1e6, 0.3, 0.01, def.width).apply_to(def);
  for (int j = 1; j < rows; ++j) def.pins.push_back(j);
  return def;
}

/// A cord that is created and timed, and run once for its Newton iterations per tick and unconverged substeps.
Variant swing(std::string setting, const CordDef& def) {
  Cord start(def);
  start.attach_mass(start.index(def.points - 1, def.rows / 2), def.mass_per_length * def.length);
  const auto cord = std::make_shared<Cord>(def);
  const auto state = std::make_shared<Cord::State>(start.save());
  const auto work = std::make_shared<std::int64_t>();
  return {
      def.rows == 1 ? "rope" : "ribbon",
      std::move(setting),
      cord->size(),
      [cord, state] { cord->restore(*state); },
      [cord, work] { *work = cord->step(frame_dt, earth_gravity).work; },
      [cord, state] {
        cord->restore(*state);
        ribbon::IslandReport sum;
        for (int k = 0; k < ticks_of_terms; ++k) sum += cord->step(frame_dt, earth_gravity);
        return std::vector{static_cast<double>(sum.iterations) / ticks_of_terms, static_cast<double>(sum.unconverged)};
      },
      {},
      {},
      [work] { return *work; }};
}

std::vector<Variant> terms() {
  std::vector<Variant> list = {swing("none", swinging())};
  const auto add = [&](const char* setting, CordDef def, auto declare) {
    declare(def);
    list.push_back(swing(setting, def));
  };
  add("drag", swinging(), [](CordDef& d) { d.drag = 0.2; });
  add("stretch_stiffness", swinging(), [](CordDef& d) { d.stretch_stiffness = 1e4; });
  add("stretch_stiffness damping", swinging(), [](CordDef& d) { d.stretch_stiffness = 1e4, d.damping = 0.01; });
  add("stretch_stiffness tension_only", swinging(),
      [](CordDef& d) { d.stretch_stiffness = 1e4, d.tension_only = true; });
  add("bending_stiffness", swinging(), [](CordDef& d) { d.bending_stiffness = 0.05; });
  add("self_contact", swinging(), [](CordDef& d) { d.self_contact = true; });
  add("cord_contact", swinging(), [](CordDef& d) { d.cord_contact = true; });
  add("fast", swinging(), [](CordDef& d) { d.accuracy = Accuracy::fast(); });
  add("accurate", swinging(), [](CordDef& d) { d.accuracy = Accuracy::accurate(); });
  list.push_back(swing("rows=2", strip(2)));
  add("rows=2 area_stiffness", strip(2), [](CordDef& d) { d.area_stiffness = 1.0; });
  add("rows=2 bars", strip(2), [](CordDef& d) {
    d.elements = ribbon::Elements::bars;
    d.bending_stiffness = 0.0;
    d.poisson_ratio = 0.0;
  });
  list.push_back(swing("rows=3", strip(3)));
  list.push_back(swing("rows=5", strip(5)));
  return list;
}

/// The error of the sag of a rope of 1.5 times its span, relative to the continuous catenary.
Variant hung(int links) {
  const auto& exact = test_support::catenaries[2];
  const CordDef def = test_support::hanging_between_pins(exact, links);
  const auto cord = std::make_shared<Cord>(def);
  const auto state = std::make_shared<Cord::State>(cord->save());
  const auto work = std::make_shared<std::int64_t>();
  return {"rope",
          "links=" + std::to_string(links),
          cord->size(),
          [cord, state] { cord->restore(*state); },
          [cord, work] { *work = cord->step(frame_dt, earth_gravity).work; },
          [def, sag = exact.sag] {
            CordDef tight = def;
            tight.accuracy = test_support::tight();
            Cord rope(tight);
            test_support::come_to_rest(rope, earth_gravity);
            return std::vector{100.0 * (test_support::shape_of(rope).sag / sag - 1.0)};
          },
          {},
          {},
          [work] { return *work; }};
}

std::vector<Variant> links() {
  std::vector<Variant> list;
  for (const int count : {4, 8, 16, 32, 64, 128}) list.push_back(hung(count));
  return list;
}

}  // namespace

std::vector<Scene> guide_scenes() {
  return {
      {"terms",
       "51 points let go from the horizontal with as much weight at the end, and each term of the model: its cost",
       ticks_of_terms,
       terms,
       {us_per_tick(), p99_us(), figure("iterations_per_tick", 0), figure("unconverged", 1)}},
      {"links",
       "a hanging rope of 4 to 128 links: how far its sag is from that of a continuous one",
       ticks_of_terms,
       links,
       {us_per_tick(), p99_us(), figure("sag_error_pct", 0)}},
  };
}

}  // namespace tradeoff
