#include "tests/support/contact_scenes.h"

#include <cmath>

#include "game/lab/scene_list.h"
#include "ribbon/box2d/convert.h"
#include "tests/support/dice.h"
#include "tests/support/slot.h"

namespace test_support {
namespace {

using game::lab::sagging;
using ribbon::CordDef;
using ribbon::Vec2;

constexpr double pi = std::numbers::pi;

/// Returns two rows of a ribbon, at half of `width` to both sides of a line: the second one to its left.
std::vector<Vec2> two_rows(const std::vector<Vec2>& line, double width) {
  std::vector<Vec2> both;
  for (std::size_t p = 0; p < line.size(); ++p) {
    const Vec2 along = line[std::min(p + 1, line.size() - 1)] - line[p > 0 ? p - 1 : 0];
    const Vec2 left = (0.5 * width / length(along)) * perp(along);
    both.push_back(line[p] - left);
    both.push_back(line[p] + left);
  }
  return both;
}

constexpr double strip_width = 0.03;

/// A cord along a line of equal links, or a ribbon of rubber: E = 1 MPa, 1 cm thick.
CordDef along(std::vector<Vec2> line, double link, int rows, double radius) {
  CordDef def;
  def.points = static_cast<int>(line.size());
  def.rows = rows;
  def.length = link * (def.points - 1);
  def.radius = radius;
  def.mass_per_length = 0.1;
  def.positions = std::move(line);
  if (rows == 1) return def;
  def.width = strip_width;
  def.area_stiffness = 1.0;
  ribbon::solid(1e6, 0.3, 0.01, def.width).apply_to(def);
  def.positions = two_rows(def.positions, def.width);
  return def;
}

}  // namespace

b2Body& hang_load(CoupledWorld& world, double ratio, double stiffness) {
  CordDef def;
  def.points = 31;
  def.length = 3.0;
  def.mass_per_length = 1.0 / 3.0;
  def.stretch_stiffness = stiffness * (1.0 + ratio) * 9.81;
  def.damping = 0.02;
  def.pins = {0};
  for (int p = 0; p < def.points; ++p) def.positions.push_back({0.0, -0.1 * p});
  const int cord = world.add(def);
  b2Body& load = world.add_load(b2_dynamicBody, {0.0, -3.0}, ratio, 0.1 * ratio);
  world.hold(cord, def.points - 1, load);
  return load;
}

void lay_over_circles(CoupledWorld& world, double friction) {
  CordDef def;
  def.points = 50;
  def.length = 5.0;
  def.friction = friction;
  for (int p = 0; p < def.points; ++p) def.positions.push_back({-2.5 + 5.0 * p / 49.0, 1.0});
  world.add(def);
  for (int k = 0; k < 20; ++k) {
    world.add_circle(b2_staticBody, {-2.3 + 4.6 * k / 19.0, -0.5 * std::cos(1.0 * k)}, 0.1, 0.0, friction);
  }
}

b2Body& hang_bridge(CoupledWorld& world, double ratio, int settling) {
  CordDef def;
  def.points = 41;
  def.length = 4.2;
  def.radius = 0.02;
  def.friction = 0.5;
  def.positions = sagging(def.points, def.length, {}, 4.0);
  def.pins = {0, def.points - 1};
  world.add(def);
  const Vec2 middle = def.positions[20];
  b2Body& ball = world.add_circle(b2_dynamicBody, middle + Vec2{0.0, 0.28}, 0.25, 0.42 * ratio, 0.5);
  world.settle(settling);
  return ball;
}

void wind_around_post(CoupledWorld& world, double angle, double friction) {
  CordDef def;
  def.radius = 0.01;
  def.friction = friction;
  const double reach = 0.5 + def.radius;
  // The middles of the links touch the circle; the angle between links is constant.
  const int turning = static_cast<int>(std::lround(20.0 * angle / pi));
  const double half_turn = 0.5 * angle / turning;
  const double link = 2.0 * reach * std::tan(half_turn);
  const int straight = static_cast<int>(std::lround(0.5 / link));
  const int links = 2 * straight + turning;
  def.points = links + 1;
  def.length = link * links;
  Vec2 x{-reach, -link * (straight + 0.5)};
  def.positions.push_back(x);
  for (int k = 0; k < links; ++k) {
    const int turned = std::min(std::max(k - straight, 0), turning);
    const double direction = 0.5 * pi - 2.0 * half_turn * turned;
    x += link * Vec2{std::cos(direction), std::sin(direction)};
    def.positions.push_back(x);
  }
  world.add(def);
  world.add_circle(b2_staticBody, {}, 0.5, 0.0, friction);
}

void hang_hall(CoupledWorld& world, unsigned seed) {
  constexpr int side = 10;
  constexpr Vec2 cell{1.6, 1.2};
  const double right = side * cell.x;
  world.add_edges({{0.0, 20.0}, {0.0, -1.5}, {right, -1.5}, {right, 20.0}}, 0.4);
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      CordDef def;
      def.points = 50;
      def.friction = 0.4;
      const Vec2 corner{cell.x * column + 0.15, cell.y * row};
      if ((row + column) % 2 == 0) {
        def.length = 1.5;
        def.positions = sagging(def.points, def.length, corner, 1.3);
        def.pins = {0, def.points - 1};
      } else {
        def.length = 0.8;
        for (int p = 0; p < def.points; ++p) {
          def.positions.push_back(corner + Vec2{0.65, -def.length * p / (def.points - 1)});
        }
        def.pins = {0};
      }
      world.add(def);
    }
  }
  // Each ball is between two rows of cords, beside the hanging ones.
  Dice dice(seed);
  for (int ball = 0; ball < 2 * side * side; ++ball) {
    const int column = ball % side;
    const int row = ball / side % side;
    const bool left = ball / (side * side) == 0;
    const Vec2 place{cell.x * column + (left ? 0.3 : 1.0) + 0.25 * dice(), cell.y * row + 0.25 + 0.5 * dice()};
    world.add_circle(b2_dynamicBody, place, 0.08, 0.1 + 0.3 * dice(), 0.4);
  }
}

std::vector<Vec2> wound(int points, double link, double radius, double pitch) {
  double angle = 0.0;
  const auto place = [&](double a) {
    const double r = radius + pitch * a / (2.0 * pi);
    return r * Vec2{std::cos(a), std::sin(a)};
  };
  std::vector<Vec2> line = {place(angle)};
  for (int p = 1; p < points; ++p) {
    double low = angle;
    double high = angle + 2.0 * link / radius;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      (length(place(middle) - line.back()) < link ? low : high) = middle;
    }
    angle = high;
    line.push_back(place(angle));
  }
  return line;
}

void wind_coil(CoupledWorld& world, int rows, double friction, double looseness) {
  constexpr double post = 0.3;
  const double link = rows > 1 ? 0.1 : 0.05;
  constexpr double radius = 0.01;
  const double half = radius + (rows > 1 ? 0.5 * strip_width : 0.0);
  const double start = post + 1.2 * half;
  const double pitch = 2.0 * looseness * half;
  // Four turns of this many links, and a straight end.
  const int links = static_cast<int>(std::lround(4.0 * 2.0 * pi * (start + 2.0 * pitch) / link));
  std::vector<Vec2> line = wound(links + 1, link, start, pitch);
  const Vec2 last = line.back() - line[line.size() - 2];
  for (int k = 0; k < std::lround(1.0 / link); ++k) line.push_back(line.back() + last);
  CordDef def = along(std::move(line), link, rows, radius);
  def.friction = friction;
  def.self_contact = true;
  for (int j = 0; j < rows; ++j) def.pins.push_back(j);
  world.add(def);
  world.add_circle(b2_staticBody, {}, post, 0.0, friction);
}

void pull_coil(CoupledWorld& world, double force) {
  const std::vector<Vec2> x = world.points(0);
  const int rows = world.def(0).rows;
  const int last = static_cast<int>(x.size()) - 1;
  const Vec2 along = x[slot(last)] - x[slot(last - rows)];
  for (int j = 0; j < rows; ++j) world.pull(0, last - j, (force / (rows * length(along))) * along);
}

void haul_coil(CoupledWorld& world, double speed) {
  const std::vector<Vec2> x = world.points(0);
  const int rows = world.def(0).rows;
  const int last = static_cast<int>(x.size()) - 1;
  const Vec2 along = x[slot(last)] - x[slot(last - rows)];
  b2Body& hauler = world.add_load(b2_kinematicBody, x[slot(last)], 0.0, 0.0);
  for (int j = 0; j < rows; ++j) world.hold(0, last - j, hauler);
  hauler.SetLinearVelocity(ribbon::box2d::to_float((speed / length(along)) * along));
}

void stand_in_bucket(CoupledWorld& world, int rows, double friction) {
  constexpr double link = 0.05;
  constexpr double radius = 0.01;
  std::vector<Vec2> line = {{0.0, 5.2}};
  for (int k = 0; k < 100; ++k) {
    const double off = 0.1 * std::sin(0.37 * k) + 0.05;  // rad, from straight down
    line.push_back(line.back() + link * Vec2{std::sin(off), -std::cos(off)});
  }
  CordDef def = along(std::move(line), link, rows, radius);
  def.friction = friction;
  def.self_contact = true;
  world.add(def);
  const double middle = 0.25;  // where the lower end is
  world.add_edges({{middle - 0.5, 6.0}, {middle - 0.5, 0.0}, {middle + 0.5, 0.0}, {middle + 0.5, 6.0}}, friction);
}

void drop_strips(CoupledWorld& world, int count, bool strip_contact) {
  constexpr int columns = 10;
  constexpr double cell = 2.0;  // m, of the lattice, and what a strip has
  const double right = columns * cell;
  world.add_edges({{0.0, 60.0}, {0.0, -8.0}, {right, -8.0}, {right, 60.0}}, 0.4);
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column <= 2 * columns; ++column) {
      const Vec2 place{0.5 * cell * column + (row % 2 == 0 ? 0.0 : 0.25 * cell), -0.8 * row};
      world.add_circle(b2_staticBody, place, 0.12, 0.0, 0.4);
    }
  }
  for (int k = 0; k < count; ++k) {
    const int row = k / columns;
    CordDef def;
    def.points = 33;
    def.rows = 2;
    def.length = 0.05 * 32;
    def.width = 0.05;
    def.mass_per_length = 0.002 * 66 / def.length;
    def.friction = 0.4;
    def.area_stiffness = 1.0;
    def.self_contact = strip_contact;
    def.cord_contact = strip_contact;
    ribbon::solid(1e5, 0.3, 0.01, def.width).apply_to(def);
    const Vec2 corner{cell * (k % columns) + 0.1 + 0.02 * (k * 7 % 11), 0.4 + 0.3 * row};
    for (int i = 0; i < def.points; ++i) {
      for (int j = 0; j < 2; ++j) def.positions.push_back(corner + Vec2{0.05 * i, 0.05 * j});
    }
    world.add(def);
  }
}

}  // namespace test_support
