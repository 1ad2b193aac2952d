#include "game/lab/scene_list.h"

#include <cmath>
#include <limits>

#include "game/lab/figures.h"
#include "ribbon/cord_forces.h"

namespace game::lab {

using ribbon::Vec2;

std::vector<KnobRange> accuracy_knobs(int preset) {
  KnobValues values;
  values[Knob::preset] = preset;
  follow_preset(values);
  using Scale = KnobRange::Scale;
  return {{Knob::preset, 0.0, 2.0, 1.0 * preset, Scale::choice},
          {Knob::substeps, 1.0, 16.0, values[Knob::substeps], Scale::whole},
          {Knob::tolerance, 1e-8, 0.1, values[Knob::tolerance], Scale::logarithmic}};
}

KnobRange stretch_knob(double min, double max) {
  return {.knob = Knob::stretch,
          .min = min,
          .max = max,
          .initial = std::numeric_limits<double>::infinity(),
          .scale = KnobRange::Scale::logarithmic,
          .max_is_infinite = true};
}

std::vector<KnobRange> together(std::vector<KnobRange> a, const std::vector<KnobRange>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::vector<Vec2> straight(int points, Vec2 start, Vec2 span) {
  std::vector<Vec2> line;
  for (int p = 0; p < points; ++p) line.push_back(start + (1.0 * p / (points - 1)) * span);
  return line;
}

std::vector<Vec2> sagging(int points, double length, Vec2 start, double span) {
  const double link = length / (points - 1);
  const auto arc = [&](double half_angle) {
    std::vector<Vec2> line = {start};
    for (int k = 0; k + 1 < points; ++k) {
      const double angle = half_angle * ((2.0 * k + 1.0) / (points - 1) - 1.0);
      line.push_back(line.back() + link * Vec2{std::cos(angle), std::sin(angle)});
    }
    return line;
  };
  double low = 0.0;
  double high = 1.5;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (arc(middle).back().x - start.x > span ? low : high) = middle;
  }
  return arc(high);
}

double excess_length(const Bench& bench) {
  if (bench.method() == Method::chains) {
    return length_now(bench.chains().front()) - bench.definitions().front().length;
  }
  const ribbon::box2d::CordView cord = bench.coupling().cord(0);
  const ribbon::CordDef& def = cord.direct().def();
  double elastic = 0.0;
  for (int link = 0; link + 1 < def.points; ++link) {
    elastic += tension_of(cord.direct(), link) / def.stretch_stiffness * cord.direct().rest_length(link);
  }
  return length_now(cord) - def.length - elastic;
}

std::vector<Reading> excess_readings(const Bench& bench) {
  return {{Reading::Kind::excess, excess_length(bench)}, {Reading::Kind::unconverged, 1.0 * unconverged(bench)}};
}

int unconverged(const Bench& bench) {
  int sum = 0;
  for (const ribbon::box2d::CordId id : bench.coupling().cords())
    sum += bench.coupling().cord(id).island_total().unconverged;
  return sum;
}

int contacts(const Bench& bench) {
  int sum = 0;
  for (const ribbon::box2d::CordId id : bench.coupling().cords()) sum += bench.coupling().cord(id).report().contacts;
  return sum;
}

}  // namespace game::lab
