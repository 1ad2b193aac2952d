#pragma once

#include <box2d/box2d.h>

#include <array>
#include <functional>
#include <vector>

#include "engine/tick/workers.h"
#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "tests/support/thesis_scenes.h"

namespace tradeoff {

using ribbon::Vec2;
using test_support::earth_gravity;
using test_support::frame_dt;

/// A world with cords of 21 points that hang down at rest, 3 m apart in as many rows as columns.
class LargeWorld {
 public:
  static constexpr int points = 21;     // of a cord
  static constexpr double link = 0.05;  // m

  LargeWorld(int cords, bool may_sleep);

  void use(engine::Workers& workers) { coupling_.use(workers.parallel_for()); }
  void trust_forget() { coupling_.trust_forget(true); }
  void gather() { coupling_.gather(world_, frame_dt); }
  void step() {
    coupling_.step();
    coupling_.apply();
  }
  void step_world() { world_.Step(static_cast<float>(frame_dt), 8, 3); }
  void rest() {
    step();
    step_world();
  }
  void settle();
  int cords() const { return coupling_.size(); }
  /// Returns the median processor times of a gather, of a step of the cords and of one of the world, µs.
  std::array<double, 3> median_times();

  /// Adds up to 10,000 static boxes, one metre apart.
  void add_boxes_far_away();
  /// The same on the area of the cords, where no cord is.
  void add_boxes_among();
  /// Adds a chain of 20,000 edges of half a metre below the first cord.
  void add_chain();
  void add_sleepers();
  /// Adds bodies that fly in a circle of 6 m around the first cord at 20 m/s.
  void add_fast();
  void turn_the_fast();
  void hold_by_a_body();

  /// Returns the processor time that some work takes, µs. The one of this thread, which excludes other processes of a
  /// shared machine. To read it takes some 0.2 µs.
  static double microseconds(const std::function<void()>& work);

 private:
  Vec2 pin(int k) const;
  void hang_cord(int k, bool may_sleep);
  bool is_clear(Vec2 place) const;
  void add_box(Vec2 place);
  b2Body* add_circle(const b2BodyDef& def);

  b2World world_{ribbon::box2d::to_float(earth_gravity)};
  ribbon::box2d::Coupling coupling_;
  std::vector<b2Body*> fast_;
  int columns_;
  int unsettled_ticks_ = 0;
};

}  // namespace tradeoff
