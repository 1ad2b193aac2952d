#include "tests/peers/figures.h"

#include <algorithm>

#include "ribbon/box2d/convert.h"
#include "tests/support/contact_figures.h"
#include "tests/support/heavy_swing.h"

namespace peers {
namespace {

using ribbon::Vec2;
using test_support::Outline;

constexpr std::size_t jitter_ticks = 60;

Outline outline_of(const CordPlan& cord, const std::vector<Vec2>& points) {
  return {test_support::outline_of(points, cord.def.rows), cord.def.rows > 1, cord.def.radius};
}

double stretch_m(const CordPlan& cord, const std::vector<Vec2>& points) {
  double along = 0.0;
  for (std::size_t p = 1; p < points.size(); ++p) along += length(points[p] - points[p - 1]);
  return along - cord.def.length;
}

/// std::max ignores NaN as its second argument.
void raise(double& most, double value) { most = std::max(value, most); }

int crossings_of(const Plan& plan, const Frame& frame) {
  int crossings = 0;
  std::vector<Outline> outlines;
  for (std::size_t c = 0; c < plan.cords.size(); ++c) {
    if (!plan.cords[c].def.self_contact) return 0;
    outlines.push_back(outline_of(plan.cords[c], frame.cords[c]));
  }
  for (std::size_t a = 0; a < outlines.size(); ++a) {
    crossings += test_support::self_crossings(outlines[a].points, outlines[a].closed);
    for (std::size_t b = 0; b < a; ++b) {
      crossings += test_support::mutual_crossings(outlines[a].points, outlines[a].closed, outlines[b].points,
                                                  outlines[b].closed);
    }
  }
  return crossings;
}

}  // namespace

Figures figures_of(const SetUp& set_up, const Plan& plan, const Recording& recording) {
  test_support::CoupledWorld world{test_support::CordMethod{}};
  set_up(world);
  const std::vector<b2Body*> moving_bodies = moving_bodies_of(world.world);
  Figures figures;
  for (std::size_t tick = 0; tick < recording.size(); ++tick) {
    const Frame& frame = recording[tick];
    if (!is_in_bounds(frame)) {
      figures.blew_up = static_cast<int>(tick) + 1;
      return figures;
    }
    for (std::size_t m = 0; m < moving_bodies.size(); ++m) {
      moving_bodies[m]->SetTransform(ribbon::box2d::to_float(frame.moving_bodies[m]), moving_bodies[m]->GetAngle());
    }
    for (std::size_t c = 0; c < plan.cords.size(); ++c) {
      const CordPlan& cord = plan.cords[c];
      raise(figures.penetration, test_support::penetration(world.world, outline_of(cord, frame.cords[c]), b2Filter{}));
      if (cord.def.rows > 1) continue;
      raise(figures.stretch_m, stretch_m(cord, frame.cords[c]));
      raise(figures.stretch, stretch_m(cord, frame.cords[c]) / cord.def.length);
    }
    if (frame.moving_bodies.empty()) continue;
    raise(figures.drift, length(frame.moving_bodies.back() - recording.front().moving_bodies.back()));
    if (tick == 0 || tick + jitter_ticks < recording.size()) continue;
    raise(figures.jitter, length(frame.moving_bodies.back() - recording[tick - 1].moving_bodies.back()));
  }
  const Frame& last = recording.back();
  figures.crossings = crossings_of(plan, last);
  figures.tunnelled = !last.moving_bodies.empty() && !last.cords.empty() &&
                      std::all_of(last.cords[0].begin(), last.cords[0].end(),
                                  [&](Vec2 p) { return last.moving_bodies.back().y < p.y; });
  return figures;
}

double path_error(const Recording& recording, const std::vector<Vec2>& path) {
  if (recording.size() < path.size()) return std::numeric_limits<double>::infinity();
  std::vector<Vec2> went;
  for (std::size_t k = 0; k < path.size(); ++k) went.push_back(recording[k].moving_bodies.back());
  return test_support::rms_distance(went, path);
}

}  // namespace peers
