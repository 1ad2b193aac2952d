#include "game/view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "engine/convert.h"
#include "game/ghost.h"
#include "game/hud.h"

namespace game {
namespace {

using engine::Canvas;
using engine::Color;
using engine::to_double;
using ribbon::Vec2;

constexpr double metres_high = 13.0;  // of the picture

constexpr Color sky_top{92, 160, 214};
constexpr Color sky_bottom{214, 236, 246};
constexpr Color far_hill{168, 202, 205};
constexpr Color near_hill{136, 182, 168};
constexpr Color earth{112, 84, 64};
constexpr Color grass{104, 162, 76};
constexpr Color ink{44, 44, 52};
constexpr Color rope{201, 158, 98};
constexpr Color rope_edge{128, 92, 52};
constexpr Color rope_light{228, 194, 140};
constexpr Color ball{222, 106, 76};
constexpr Color ball_edge{150, 60, 44};
constexpr Color peg{120, 120, 132};
constexpr Color shirt{52, 98, 168};
constexpr Color trousers{50, 56, 84};
constexpr Color skin{236, 190, 152};
constexpr Color goal_cloth{236, 190, 60};
// Goto 2017, Fig. 4.1.
constexpr Color free_point{40, 90, 230};
constexpr Color operated_point{250, 220, 40};
constexpr Color constrained_point{225, 40, 40};

Vec2 rotated(Vec2 v, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

/// A row of round hills that moves by `follow` of the camera's way: 1 stands still on the screen.
void draw_hills(Canvas& canvas, Vec2 camera, double follow, double base, double radius, double step, Color color) {
  const double left = camera.x - 20.0;
  const double shift = follow * camera.x;
  const int first = static_cast<int>(std::floor((left - shift) / step)) - 1;
  for (int k = first; k < first + static_cast<int>(40.0 / step) + 3; ++k) {
    const double x = shift + k * step;
    const double size = radius * (1.0 + 0.25 * std::sin(2.3 * k));
    canvas.circle({x, base - 0.55 * radius}, size, color);
  }
}

void draw_background(Canvas& canvas, Vec2 camera) {
  canvas.clear(sky_top, sky_bottom);
  draw_hills(canvas, camera, 0.8, 2.0, 7.0, 7.5, far_hill);
  draw_hills(canvas, camera, 0.6, 0.5, 5.0, 5.5, near_hill);
}

void draw_polygon_body(Canvas& canvas, const b2PolygonShape& shape, const Snapshot::Body& pose) {
  std::vector<Vec2> corners;
  for (int k = 0; k < shape.m_count; ++k) {
    corners.push_back(pose.position + rotated(to_double(shape.m_vertices[k]), pose.angle));
  }
  canvas.polygon(corners, earth);
  // Grass on what faces up.
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec2 a = corners[k];
    const Vec2 b = corners[(k + 1) % corners.size()];
    if (a.x - b.x > 0.8 * length(b - a)) canvas.polyline(std::array{a, b}, 0.16, grass);
  }
}

void draw_circle_body(Canvas& canvas, const b2CircleShape& shape, const Snapshot::Body& pose, bool is_static) {
  const double radius = static_cast<double>(shape.m_radius);
  const Vec2 center = pose.position + rotated(to_double(shape.m_p), pose.angle);
  canvas.circle(center, radius, is_static ? ink : ball_edge);
  canvas.circle(center, radius - 0.05, is_static ? peg : ball);
  if (is_static) return;
  const Vec2 spoke = rotated({0.55 * radius, 0.0}, pose.angle);
  canvas.polyline(std::array{center - spoke, center + spoke}, 0.07, ball_edge);
  canvas.circle(center + Vec2{-0.3 * radius, 0.35 * radius}, 0.16 * radius, {255, 255, 255, 120});
}

/// A cord at a moment between two ticks.
struct DrawnCord {
  const engine::Coupling& coupling;
  engine::CordIndex index;
  engine::CordShape shape;
  const std::vector<Vec2>& points;

  int size() const { return static_cast<int>(points.size()); }
  int point(int i, int j) const { return i * shape.rows + j; }
  Vec2 at(int p) const { return points[static_cast<std::size_t>(p)]; }
  ribbon::PointKind kind(int p) const { return coupling.kind(index, p); }
};

std::vector<Vec2> middle_line(const DrawnCord& cord) {
  std::vector<Vec2> line;
  for (int i = 0; i < cord.shape.columns; ++i) {
    Vec2 sum;
    for (int j = 0; j < cord.shape.rows; ++j) sum += cord.at(cord.point(i, j));
    line.push_back((1.0 / cord.shape.rows) * sum);
  }
  return line;
}

void draw_cord(Canvas& canvas, const DrawnCord& cord) {
  const double width = cord.shape.thickness;
  const double edge = std::max(width, 0.07);  // as thick as what it touches feels it, unless it could not be seen
  const std::vector<Vec2> line = middle_line(cord);
  canvas.polyline(line, edge, rope_edge);
  canvas.polyline(line, std::max(edge - 0.08, 0.5 * edge), rope);  // a thin one keeps its colour too
  canvas.polyline(line, 0.25 * width, rope_light);
  for (int i = 0; i < cord.shape.columns; ++i) {
    if (cord.kind(cord.point(i, 0)) != ribbon::PointKind::constrained) continue;
    const Vec2 pin = line[static_cast<std::size_t>(i)];
    canvas.circle(pin, 0.6 * width + 0.08, ink);
    canvas.circle(pin, 0.6 * width + 0.02, peg);
  }
}

void draw_bars(Canvas& canvas, const DrawnCord& cord) {
  const auto draw_bar = [&](int a, int i, int j) {
    if (i >= cord.shape.columns || j < 0 || j >= cord.shape.rows) return;
    canvas.polyline(std::array{cord.at(a), cord.at(cord.point(i, j))}, 0.015, {255, 255, 255, 200});
  };
  for (int i = 0; i < cord.shape.columns; ++i) {
    for (int j = 0; j < cord.shape.rows; ++j) {
      const int a = cord.point(i, j);
      draw_bar(a, i, j + 1);
      draw_bar(a, i + 1, j);
      if (!cord.shape.braced) continue;
      draw_bar(a, i + 1, j - 1);
      draw_bar(a, i + 1, j + 1);
    }
  }
}

void draw_cord_points(Canvas& canvas, const DrawnCord& cord) {
  draw_bars(canvas, cord);
  for (int p = 0; p < cord.size(); ++p) {
    const ribbon::PointKind kind = cord.kind(p);
    const Color color = kind == ribbon::PointKind::free       ? free_point
                        : kind == ribbon::PointKind::operated ? operated_point
                                                              : constrained_point;
    canvas.circle(cord.at(p), kind == ribbon::PointKind::operated ? 0.11 : 0.055, color);
  }
}

void draw_goal(Canvas& canvas, const Level& level, bool reached) {
  const Vec2 foot = level.goal.center - 0.5 * level.goal.size;
  const Vec2 top = foot + Vec2{0.0, level.goal.size.y + 0.4};
  canvas.polyline(std::array{foot, top}, 0.1, ink);
  const double flap = reached ? 0.12 : 0.0;
  const std::array flag = {top, top + Vec2{1.3, -0.35 + flap}, top + Vec2{0.0, -0.8}};
  canvas.polygon(flag, goal_cloth);
  canvas.circle(top, 0.1, goal_cloth);
}

void draw_player(Canvas& canvas, const Player& player, Vec2 at, const Vec2* held) {
  const double r = player.tuning().radius;
  const double half = 0.5 * player.tuning().height;
  const double side = player.faces_left() ? -1.0 : 1.0;
  const double speed = static_cast<double>(player.body().GetLinearVelocity().x);
  const double swing = player.is_on_ground() && std::abs(speed) > 0.3 ? 0.28 * std::sin(7.0 * at.x) : 0.1;
  const Vec2 hip = at + Vec2{0.0, -0.15};
  const Vec2 shoulder = at + Vec2{0.0, half - 0.72};
  for (const double leg : {-swing, swing}) {
    canvas.polyline(std::array{hip, at + Vec2{leg, -half + 0.1}}, 0.17, trousers);
  }
  canvas.polyline(std::array{hip, shoulder}, 1.2 * r, shirt);
  if (held == nullptr) canvas.polyline(std::array{shoulder, shoulder + Vec2{0.3 * side, -0.32}}, 0.13, skin);
  const Vec2 head = at + Vec2{0.0, half - 0.3};
  canvas.circle(head, 0.28, skin);
  canvas.circle(head + Vec2{-0.05 * side, 0.1}, 0.24, {96, 62, 40});
  canvas.circle(head + Vec2{0.06 * side, -0.03}, 0.22, skin);
  canvas.circle(head + Vec2{0.15 * side, 0.02}, 0.04, ink);
  if (held == nullptr) return;
  for (const double elbow : {-0.3, 0.3}) {
    const Vec2 middle = 0.5 * (shoulder + *held) + Vec2{elbow, 0.0};
    canvas.polyline(std::array{shoulder + Vec2{0.5 * elbow, 0.0}, middle, *held}, 0.12, skin);
  }
  canvas.circle(*held, 0.13, skin);
}

}  // namespace

engine::View View::camera(const Canvas& canvas, Vec2 player) const {
  const Vec2 size = simulation_->level().map.size;
  const double scale = canvas.height() / metres_high;
  const double half_width = std::min(0.5 * canvas.width() / scale, 0.5 * size.x);
  const double half_height = std::min(0.5 * metres_high, 0.5 * size.y);
  return {{std::clamp(player.x + 1.5, half_width, size.x - half_width),
           std::clamp(player.y + 1.0, half_height, size.y - half_height)},
          scale};
}

void View::draw(Canvas& canvas, double alpha, const ViewOptions& options) {
  const Snapshot now = interpolate(simulation_->previous(), simulation_->current(), alpha);
  const engine::Scene& scene = simulation_->scene();
  const Player& player = simulation_->player();
  const Vec2 player_at = now.bodies.back().position;  // the player was made last
  canvas.set_view(camera(canvas, player_at));

  draw_background(canvas, canvas.view().center);
  draw_goal(canvas, simulation_->level(), simulation_->goal_ticks().has_value());
  std::size_t index = now.bodies.size();
  for (const b2Body* body = scene.world().GetBodyList(); body != nullptr; body = body->GetNext()) {
    const Snapshot::Body& pose = now.bodies[--index];
    if (body == &player.body()) continue;
    const b2Shape& shape = *body->GetFixtureList()->GetShape();
    if (shape.GetType() == b2Shape::e_polygon) {
      draw_polygon_body(canvas, static_cast<const b2PolygonShape&>(shape), pose);
    } else {
      draw_circle_body(canvas, static_cast<const b2CircleShape&>(shape), pose, body->GetType() == b2_staticBody);
    }
  }
  const engine::Coupling& coupling = scene.coupling();
  std::vector<DrawnCord> cords;
  for (int c = 0; c < coupling.size(); ++c) {
    cords.push_back({coupling, c, coupling.shape(c), now.cords[static_cast<std::size_t>(c)]});
  }
  for (const DrawnCord& cord : cords) draw_cord(canvas, cord);
  const auto held = coupling.held_by(player.body());
  const Vec2* held_at =
      held ? &now.cords[static_cast<std::size_t>(held->cord)][static_cast<std::size_t>(held->point)] : nullptr;
  if (options.ghost) draw_ghost(canvas, *options.ghost);
  draw_player(canvas, player, player_at, held_at);
  if (options.debug) {
    for (const DrawnCord& cord : cords) draw_cord_points(canvas, cord);
  }
  if (options.hud) draw_hud(canvas, *simulation_, options);
}

}  // namespace game
