#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "game/lab/scene_list.h"
#include "ribbon/cord_forces.h"

namespace game::lab {
namespace {

using ribbon::Vec2;

constexpr double post_radius = 0.5;       // m
constexpr double cord_radius = 0.015;     // m
constexpr double light_weight = 5.0;      // kg
constexpr double mass_per_length = 0.01;  // kg/m, so that the weights alone pull
constexpr double straight_part = 1.2;     // m, at both ends
constexpr double weight_radius = 0.16;    // m
constexpr int links_of_half_turn = 20;

double angle_of(const KnobValues& values) { return std::numbers::pi * (2.0 * values[Knob::turns] + 1.0); }

/// A cord that comes up at the left, runs around the post and goes down at the right. The middles of its links touch
/// the post, and the angle between them is constant.
ribbon::CordDef around_post(double angle) {
  ribbon::CordDef def;
  def.radius = cord_radius;
  const double reach = post_radius + cord_radius;
  const int turning = static_cast<int>(std::lround(links_of_half_turn * angle / std::numbers::pi));
  const double half_turn = 0.5 * angle / turning;
  const double link = 2.0 * reach * std::tan(half_turn);
  const int free = static_cast<int>(std::lround(straight_part / link));
  const int links = 2 * free + turning;
  def.points = links + 1;
  def.length = link * links;
  def.positions.push_back({-reach, -link * (free + 0.5)});
  for (int k = 0; k < links; ++k) {
    const int turned = std::min(std::max(k - free, 0), turning);
    const double direction = 0.5 * std::numbers::pi - 2.0 * half_turn * turned;
    def.positions.push_back(def.positions.back() + link * Vec2{std::cos(direction), std::sin(direction)});
  }
  return def;
}

void build_capstan(Bench& bench, const KnobValues& values, Vec2) {
  ribbon::CordDef def = around_post(angle_of(values));
  def.mass_per_length = mass_per_length;
  def.friction = values[Knob::friction];
  def.stretch_stiffness = values[Knob::stretch];
  def.bending_stiffness = values[Knob::bending];
  def.damping = 0.02;
  def.accuracy = accuracy_of(values);
  bench.add(def);
  bench.add(Disc{.type = b2_staticBody, .at = {}, .radius = post_radius, .friction = def.friction});
  bench.add_edges(std::array{Vec2{-2.4, -2.6}, Vec2{2.4, -2.6}}, 0.5);
  const auto hang = [&](int point, Vec2 at, double mass) {
    b2Body& weight =
        bench.add(Disc{.at = at, .radius = weight_radius, .mass = mass, .meets_cords = false, .damping = 0.1});
    bench.hold(0, point, weight);
  };
  hang(0, def.positions.front(), light_weight);
  hang(def.points - 1, def.positions.back(), light_weight * values[Knob::weight_ratio]);
}

void tune_capstan(Bench& bench, const KnobValues& values) {
  bench.set_mass(*bench.bodies().back().body, light_weight * values[Knob::weight_ratio]);
}

std::vector<Reading> readings_of_capstan(const Bench& bench, const KnobValues& values) {
  const ribbon::Cord& cord = bench.coupling().cord(0).direct();
  const double slack = tension_of(cord, 0);
  const double taut = tension_of(cord, cord.def().points - 2);
  return {{Reading::Kind::pull_ratio, slack > 0.0 ? taut / slack : std::numeric_limits<double>::quiet_NaN()},
          {Reading::Kind::holding_limit, std::exp(values[Knob::friction] * angle_of(values))},
          {Reading::Kind::unconverged, 1.0 * unconverged(bench)}};
}

}  // namespace

Scene capstan() {
  using Scale = KnobRange::Scale;
  return {.name = "capstan",
          .low = {-2.5, -2.75},
          .high = {2.5, 0.75},
          .knobs = together(
              {{Knob::weight_ratio, 1.0, 1e4, 2.3, Scale::logarithmic},
               {.knob = Knob::turns, .min = 0.0, .max = 3.0, .initial = 0.0, .scale = Scale::whole, .rebuilds = true},
               {Knob::friction, 0.0, 1.0, 0.3},
               stretch_knob(1e3, 1e8),
               {.knob = Knob::bending,
                .min = 1e-4,
                .max = 1.0,
                .initial = 0.0,
                .scale = Scale::logarithmic,
                .min_is_zero = true}},
              accuracy_knobs(1)),
          .build = build_capstan,
          .tune = tune_capstan,
          .readings = readings_of_capstan};
}

}  // namespace game::lab
