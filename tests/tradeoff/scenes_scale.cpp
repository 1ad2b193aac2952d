#include <box2d/box2d.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "engine/tick/workers.h"
#include "ribbon/box2d/cord_queries.h"
#include "ribbon/box2d/coupling.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/dice.h"
#include "tests/support/thesis_scenes.h"
#include "tests/tradeoff/contact_run.h"
#include "tests/tradeoff/large_world.h"
#include "tests/tradeoff/measure.h"
#include "tests/tradeoff/scene_lists.h"

namespace tradeoff {
namespace {

constexpr int points = LargeWorld::points;
constexpr double link = LargeWorld::link;  // m
constexpr int settling_ticks = 60;

struct Layout {
  const char* setting;
  int cords;
  bool asleep;
  std::function<void(LargeWorld&)> populate;
};

Variant variant(const Layout& layout) {
  // Created at the first use, because some of them are large.
  const auto made = std::make_shared<std::unique_ptr<LargeWorld>>();
  const auto large = [made, layout]() -> LargeWorld& {
    if (*made == nullptr) {
      *made = std::make_unique<LargeWorld>(layout.cords, layout.asleep);
      if (layout.populate) layout.populate(**made);
      (*made)->settle();
    }
    return **made;
  };
  return {"coupling",
          layout.setting,
          layout.cords * points,
          [] {},
          [large] { large().gather(); },
          [large] {
            const auto [gather, step, world] = large().median_times();
            return std::vector{gather, step, world, static_cast<double>(large().cords())};
          },
          [large] {
            large().turn_the_fast();
            large().rest();
          },
          {},
          {}};
}

std::vector<Variant> large_worlds() {
  const auto far = [](LargeWorld& large) { large.add_boxes_far_away(); };
  const auto among = [](LargeWorld& large) { large.add_boxes_among(); };
  const auto held = [](LargeWorld& large) { large.hold_by_a_body(); };
  std::vector<Variant> list;
  for (const Layout& layout : std::vector<Layout>{
           {"1 cord, nothing else", 1, false, {}},
           {"1 cord, 10,000 boxes", 1, false, far},
           {"1 cord that a body holds, 10,000 boxes", 1, false,
            [=](LargeWorld& large) {
              far(large);
              held(large);
            }},
           {"the same, and destructions are reported", 1, false,
            [=](LargeWorld& large) {
              far(large);
              held(large);
              large.trust_forget();
            }},
           {"1 cord, a chain of 20,000 edges near it", 1, false, [](LargeWorld& large) { large.add_chain(); }},
           {"1 cord, 10,000 sleeping bodies", 1, false, [](LargeWorld& large) { large.add_sleepers(); }},
           {"1 cord, 100 fast bodies", 1, false, [](LargeWorld& large) { large.add_fast(); }},
           {"10 cords, nothing else", 10, false, {}},
           {"100 cords, nothing else", 100, false, {}},
           {"1,000 cords, nothing else", 1000, false, {}},
           {"1,000 cords, 10,000 boxes far away", 1000, false, far},
           {"1,000 cords among 10,000 boxes", 1000, false, among},
           {"1,000 cords asleep, nothing else", 1000, true, {}},
           {"1,000 cords asleep among 10,000 boxes", 1000, true, among},
           {"10,000 cords, nothing else", 10'000, false, {}},
       }) {
    list.push_back(variant(layout));
  }
  return list;
}

Column ns_per_cord() {
  return {"gather_and_step_ns_per_cord", 0,
          [](const Row& row) { return 1e3 * (row.figures[0] + row.figures[1]) / row.figures[3]; }};
}

/// Cords without contacts, in a continuing world.
Variant free_cords(int count) {
  const auto workers = std::make_shared<engine::Workers>(count);
  const auto large = std::make_shared<LargeWorld>(1000, false);
  large->use(*workers);
  return {"coupling",
          std::to_string(count) + (count == 1 ? " worker" : " workers"),
          1000 * points,
          [] {},
          [large, workers] {
            large->gather();
            large->step();
          },
          [] { return std::vector<double>{}; },
          [large] { large->step_world(); },
          "1,000 free cords",
          {}};
}

Variant in_contact(int count, const std::string& name, const SetUp& set_up) {
  const auto workers = std::make_shared<engine::Workers>(count);
  NamedMethod method = presets({"fast"}).front();
  method.setting = std::to_string(count) + (count == 1 ? " worker" : " workers");
  return tradeoff::variant(ContactVariant{method,
                                          name,
                                          [=](test_support::CoupledWorld& world) {
                                            set_up(world);
                                            world.coupling.use(workers->parallel_for());
                                          },
                                          false,
                                          {0.0, -9.81},
                                          [](test_support::CoupledWorld&) { return std::vector<double>{}; }});
}

/// 10,000 rays through 100 or 1,000 ropes of 21 points that swing, each across all of them.
Variant rays(int cords) {
  struct Rays {
    ribbon::box2d::Coupling coupling;
    ribbon::box2d::CordQueries queries;
    std::vector<std::pair<Vec2, Vec2>> rays;
    int hits = 0;
  };
  const auto scene = std::make_shared<Rays>();
  test_support::Dice dice(1);
  const int columns = static_cast<int>(std::ceil(std::sqrt(cords)));
  for (int k = 0; k < cords; ++k) {
    ribbon::CordDef def;
    def.points = points;
    def.length = link * (points - 1);
    for (int p = 0; p < points; ++p) {
      const int row = k / columns;
      def.positions.push_back({k % columns + link * p * 0.6, 1.5 * row - link * p * 0.8});
    }
    scene->coupling.add(ribbon::Cord(def));
  }
  const double high = 1.5 * columns;
  for (int k = 0; k < 10'000; ++k) {
    scene->rays.push_back(
        {{dice(-1.0, columns + 1.0), dice(-1.0, high)}, {dice(-1.0, columns + 1.0), dice(-1.0, high)}});
  }
  return {"queries",
          "10,000 rays",
          cords * points,
          [] {},
          [scene] {
            scene->queries.update(scene->coupling);
            for (const auto& [from, to] : scene->rays) scene->hits += scene->queries.ray_cast(from, to) ? 1 : 0;
          },
          [scene] { return std::vector{static_cast<double>(scene->rays.size())}; },
          {},
          number(cords) + " cords"};
}

/// What is done to a cord that falls.
enum class Done : unsigned char { tick, cut, cut_along };

/// A cord that falls from level with a load at its end: a tick of it, or a cut. What makes the cord anew is not timed.
Variant cut_or_tick(const ribbon::CordDef& def, Done done) {
  struct Falling {
    b2World world{{0.0F, -9.81F}};
    ribbon::box2d::Coupling coupling;
    ribbon::CordDef def{};
    ribbon::box2d::CordId cord = -1;

    void renew() {
      while (coupling.size() > 0) coupling.remove(coupling.cords().front());
      ribbon::Cord made(def);
      made.attach_mass(made.size() - 1, 1.0);
      cord = coupling.add(std::move(made));
      for (int k = 0; k < settling_ticks; ++k) coupling.tick(world, frame_dt);
    }
  };
  const auto falling = std::make_shared<Falling>();
  falling->def = def;
  const char* const names[] = {"a tick", "a cut", "a cut along a row"};
  return {"coupling",
          (def.rows > 1 ? std::string("a ribbon, ") : std::string()) + names[static_cast<std::size_t>(done)],
          def.points * def.rows,
          [falling] { falling->renew(); },
          [falling, done] {
            if (done == Done::cut_along) {
              falling->coupling.cord(falling->cord).cut_along(2);
            } else if (done == Done::cut) {
              falling->coupling.cord(falling->cord).cut(5.03);
            } else {
              falling->coupling.gather(falling->world, frame_dt);
              falling->coupling.step();
              falling->coupling.apply();
            }
          },
          [] { return std::vector<double>{}; },
          [falling] { falling->renew(); }};
}

/// A rope of 51 points, and a ribbon of 51 × 5.
std::vector<Variant> cuts_and_ticks() {
  ribbon::CordDef rope;
  rope.pins = {0};
  ribbon::CordDef strip;
  strip.rows = 5;
  strip.width = 0.4;
  ribbon::solid(1e6, 0.0, 1.0, strip.width).apply_to(strip);
  strip.pins = {0, 1, 2, 3, 4};
  std::vector<Variant> list;
  for (const Done done : {Done::tick, Done::cut}) list.push_back(cut_or_tick(rope, done));
  for (const Done done : {Done::tick, Done::cut, Done::cut_along}) list.push_back(cut_or_tick(strip, done));
  return list;
}

std::vector<Variant> by_workers() {
  std::vector<Variant> list;
  for (const int count : {1, 2}) list.push_back(free_cords(count));
  for (const int count : {1, 2}) {
    list.push_back(in_contact(count, "cords_and_circles", [](auto& world) { test_support::hang_hall(world); }));
  }
  for (const int count : {1, 2}) {
    list.push_back(in_contact(count, "30 strips", [](auto& world) { test_support::drop_strips(world, 30, true); }));
  }
  return list;
}

}  // namespace

std::vector<Scene> scale_scenes() {
  return {
      {"scale",
       "cords that hang in large worlds: the cost of finding what is near them, and of a step of many of them",
       20,
       large_worlds,
       {figure("gather_us", 0), figure("step_us", 1), figure("world_step_us", 2), ns_per_cord()}},
      {"cut",
       "a rope of 51 points and a ribbon of 51 x 5 that fall with a load: a tick of each, and a cut",
       20,
       cuts_and_ticks,
       {cords_us(), cords_max_us()}},
      {"rays",
       "10,000 rays through ropes, with the update of the queries in the same tick",
       20,
       [] {
         std::vector<Variant> list;
         for (const int cords : {10, 100, 1000}) list.push_back(rays(cords));
         return list;
       },
       {us_per_tick(), {"ns_per_ray", 0, [](const Row& row) { return 1e3 * row.timing.median_us / row.figures[0]; }}}},
      {"workers",
       "many cords by one worker and by two: free ones, a hall of cords and balls, and strips that fall on each other",
       120,
       by_workers,
       {us_per_tick(), cords_us(), cords_max_us()},
       "1 worker",
       {},
       {},
       5}};
}

}  // namespace tradeoff
