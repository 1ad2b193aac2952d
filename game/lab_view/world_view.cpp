#include "game/lab_view/world_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "game/lab_view/look.h"
#include "game/lab_view/numbers.h"
#include "game/words/lab_words.h"
#include "game/words/words.h"
#include "ribbon/box2d/convert.h"

namespace game::lab {
namespace {

using engine::Canvas;
using engine::Mesh;
using ribbon::Vec2;
using ribbon::box2d::CordView;
using ribbon::box2d::to_double;

constexpr double min_line = 2.0;        // units of text, for the thinnest cord
constexpr int pieces_of_link = 3;       // of a smooth line
constexpr int most_smooth_cords = 200;  // more of them are small, and drawn with straight links
constexpr double visible_gap = 0.02;    // m, between two links of a chain

/// The camera of a scene: the pixels per metre, and the middle of the scene.
struct Camera {
  double scale;
  Vec2 middle;
};
Camera camera_of(const Scene& scene, const Rectangle& place) {
  const Vec2 size = scene.high - scene.low;
  return {std::max(std::min(place.size.x / size.x, place.size.y / size.y), 1e-3), 0.5 * (scene.low + scene.high)};
}

/// Returns points of a cord as what to draw.
ribbon::PointGrid grid_of(const CordView& cord, std::span<const Vec2> x) {
  ribbon::PointGrid grid = cord.grid();
  grid.positions = x;
  return grid;
}

/// The shapes of one kind, so that they are painted at once.
struct Shapes {
  Mesh cords, lights, cloth, edges;
  Mesh links, gaps;
  Mesh bodies, rims, asleep, asleep_rims, fixed, fixed_rims;
  Mesh free, operated, constrained, bars;
};

struct Drawer {
  Canvas& canvas;
  const Layout& layout;
  Shapes shapes{};
  std::vector<Vec2> line{};
  std::vector<ribbon::LineVertex> vertices{};
  std::vector<ribbon::StripVertex> strip{};
  std::vector<int> indices{};

  double width_of(double metres) const {
    return std::max(metres * canvas.view().pixels_per_metre, min_line * layout.unit);
  }

  void add_rope(const CordView& cord, std::span<const Vec2> x, int pieces) {
    line.clear();
    if (pieces > 1) {
      vertices.resize(ribbon::smooth_line_size(cord.shape().columns, pieces));
      for (const ribbon::LineVertex& v : ribbon::smooth_line(grid_of(cord, x), 0, pieces, vertices))
        line.push_back(canvas.to_pixels(v.position));
    } else {
      for (const Vec2 point : x) line.push_back(canvas.to_pixels(point));
    }
    const double width = width_of(2.0 * cord.direct().def().radius);
    add_polyline(shapes.cords, line, width);
    if (width > 3.0 * layout.unit) add_polyline(shapes.lights, line, 0.25 * width);
  }

  void add_ribbon(const CordView& cord, std::span<const Vec2> x) {
    strip.resize(ribbon::smooth_strip_size(cord.shape().columns, pieces_of_link));
    line.clear();
    for (const ribbon::StripVertex& v : ribbon::smooth_strip(grid_of(cord, x), 0.0, pieces_of_link, strip))
      line.push_back(canvas.to_pixels(v.position));
    indices.clear();
    for (int k = 0; k + 2 < static_cast<int>(line.size()); ++k) indices.insert(indices.end(), {k, k + 1, k + 2});
    add_triangles(shapes.cloth, line, indices);
    std::vector<Vec2> outline;
    for (std::size_t k = 0; k < line.size(); k += 2) outline.push_back(line[k]);
    for (std::size_t k = line.size() - 1; k < line.size(); k -= 2) outline.push_back(line[k]);
    outline.push_back(outline.front());
    add_polyline(shapes.edges, outline, 1.4 * layout.unit);
  }

  /// Draws bars and points, as the thesis does.
  void add_mesh(const CordView& cord, std::span<const Vec2> x) {
    for (const ribbon::Connection& bar : cord.thesis().mesh().connections) {
      const std::array ends = {canvas.to_pixels(x[static_cast<std::size_t>(bar.a)]),
                               canvas.to_pixels(x[static_cast<std::size_t>(bar.b)])};
      add_polyline(shapes.bars, ends, 1.2 * layout.unit);
    }
    for (std::size_t p = 0; p < x.size(); ++p) {
      const ribbon::PointKind kind = cord.kind(static_cast<int>(p));
      Mesh& points = kind == ribbon::PointKind::free       ? shapes.free
                     : kind == ribbon::PointKind::operated ? shapes.operated
                                                           : shapes.constrained;
      add_disc(points, canvas.to_pixels(x[p]), 2.6 * layout.unit);
    }
  }

  void add(const CordView& cord, std::span<const Vec2> x, int pieces) {
    if (cord.solver() == ribbon::box2d::Solver::thesis) return add_mesh(cord, x);
    if (cord.shape().rows > 1) return add_ribbon(cord, x);
    add_rope(cord, x, pieces);
    for (const int pin : cord.direct().def().pins) {
      add_disc(shapes.constrained, canvas.to_pixels(x[static_cast<std::size_t>(pin)]),
               std::max(3.2 * layout.unit * std::min(1.0, canvas.view().pixels_per_metre / 40.0), layout.unit));
    }
  }

  void add(std::span<const std::pair<Vec2, Vec2>> links, const ribbon::CordDef& def) {
    Vec2 before = links.front().first;
    for (const auto& [front, rear] : links) {
      const std::array box = {canvas.to_pixels(front), canvas.to_pixels(rear)};
      add_polyline(shapes.links, box, width_of(2.0 * def.radius));
      if (length(front - before) > visible_gap)
        add_polyline(shapes.gaps, std::array{canvas.to_pixels(before), box[0]}, 1.3 * layout.unit);
      before = rear;
    }
    for (const int pin : def.pins) {
      const Vec2 at = canvas.to_pixels(def.positions[static_cast<std::size_t>(pin)]);
      add_disc(shapes.constrained, at, 3.2 * layout.unit);
    }
  }

  /// Its centre is that of its body, as Bench adds it.
  void add_disc_of(const b2Body& body, const b2CircleShape& circle, const Snapshot::Body& pose) {
    const bool is_fixed = body.GetType() == b2_staticBody;
    const Vec2 center = canvas.to_pixels(pose.position);
    const double radius = static_cast<double>(circle.m_radius) * canvas.view().pixels_per_metre;
    const bool is_asleep = !is_fixed && !body.IsAwake();
    add_disc(is_fixed ? shapes.fixed : is_asleep ? shapes.asleep : shapes.bodies, center, radius);
    Mesh& rims = is_fixed ? shapes.fixed_rims : is_asleep ? shapes.asleep_rims : shapes.rims;
    const double width = std::min(1.8 * layout.unit, 0.4 * radius);
    add_ring(rims, center, radius - 0.5 * width, width);
    if (is_fixed || radius < 6.0 * layout.unit) return;
    const Vec2 spoke{radius * std::cos(pose.angle), -radius * std::sin(pose.angle)};
    add_polyline(rims, std::array{center, center + spoke}, width);
  }

  void add(const b2Body& body, const Snapshot::Body& pose) {
    for (const b2Fixture* fixture = body.GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
      const b2Shape& shape = *fixture->GetShape();
      if (shape.GetType() == b2Shape::e_circle) add_disc_of(body, static_cast<const b2CircleShape&>(shape), pose);
      if (shape.GetType() != b2Shape::e_edge) continue;
      const auto& edge = static_cast<const b2EdgeShape&>(shape);
      const std::array ends = {canvas.to_pixels(to_double(edge.m_vertex1)),
                               canvas.to_pixels(to_double(edge.m_vertex2))};
      add_polyline(shapes.fixed_rims, ends, 3.0 * layout.unit);
    }
  }

  void add(const Bench& bench, const Picture::Bench& shown) {
    std::size_t number = shown.snapshot.bodies.size();
    for (const b2Body* body = bench.world().GetBodyList(); body != nullptr; body = body->GetNext())
      add(*body, shown.snapshot.bodies[--number]);
    const int pieces = bench.coupling().size() > most_smooth_cords ? 1 : pieces_of_link;
    for (const ribbon::box2d::CordId id : bench.coupling().cords())
      add(bench.coupling().cord(id), shown.snapshot.cords[static_cast<std::size_t>(id)], pieces);
    for (std::size_t k = 0; k < shown.chains.size(); ++k) add(shown.chains[k], bench.definitions()[k]);
  }

  void paint() const {
    canvas.mesh(shapes.fixed, look::fixed);
    canvas.mesh(shapes.fixed_rims, look::fixed_rim);
    canvas.mesh(shapes.asleep, look::asleep);
    canvas.mesh(shapes.asleep_rims, look::asleep_rim);
    canvas.mesh(shapes.bodies, look::body);
    canvas.mesh(shapes.rims, look::body_rim);
    canvas.mesh(shapes.cloth, look::cloth);
    canvas.mesh(shapes.edges, look::cord);
    canvas.mesh(shapes.gaps, look::gap);
    canvas.mesh(shapes.links, look::chain);
    canvas.mesh(shapes.cords, look::cord);
    canvas.mesh(shapes.lights, look::cord_light);
    canvas.mesh(shapes.bars, look::faint);
    canvas.mesh(shapes.free, look::free_point);
    canvas.mesh(shapes.constrained, look::constrained_point);
    canvas.mesh(shapes.operated, look::operated_point);
  }
};

/// Draws a line each metre, or every ten where these would be too close.
void draw_grid(Canvas& canvas, const Layout& layout) {
  const Rectangle& place = layout.world;
  const double step = canvas.view().pixels_per_metre > 12.0 * layout.unit ? 1.0 : 10.0;
  const Vec2 low = canvas.to_world(place.corner + Vec2{0.0, place.size.y});
  const Vec2 high = canvas.to_world(place.corner + Vec2{place.size.x, 0.0});
  Mesh lines;
  for (double x = std::ceil(low.x / step) * step; x <= high.x; x += step) {
    const double at = canvas.to_pixels({x, 0.0}).x;
    add_polyline(lines, std::array{Vec2{at, place.corner.y}, Vec2{at, place.corner.y + place.size.y}}, 1.0);
  }
  for (double y = std::ceil(low.y / step) * step; y <= high.y; y += step) {
    const double at = canvas.to_pixels({0.0, y}).y;
    add_polyline(lines, std::array{Vec2{place.corner.x, at}, Vec2{place.corner.x + place.size.x, at}}, 1.0);
  }
  canvas.mesh(lines, look::grid);
}

/// Marks what the pointer drags.
void draw_dragged(Canvas& canvas, const Bench& bench, const Snapshot& shown, double unit) {
  Mesh ring;
  if (const auto& point = bench.drag().cord_point()) {
    const Vec2 at = shown.cords[static_cast<std::size_t>(point->cord)][static_cast<std::size_t>(point->point)];
    add_ring(ring, canvas.to_pixels(at), 8.0 * unit, 2.0 * unit);
  }
  if (const b2Body* body = bench.drag().body())
    add_ring(ring, canvas.to_pixels(shown.bodies[number_of(*body)].position), 12.0 * unit, 2.0 * unit);
  canvas.mesh(ring, look::operated_point);
}

void draw_forces(Canvas& canvas, std::span<const ShownForce> forces, const Layout& layout) {
  Mesh arrows;
  const double size = 13.0 * layout.unit;
  for (const ShownForce& force : forces) {
    const Vec2 tip = canvas.to_pixels(force.tip);
    const Vec2 tail = canvas.to_pixels(force.tip - force.arrow);
    const double reach = length(tip - tail);
    if (reach > 1.0) {
      const Vec2 along = (1.0 / reach) * (tip - tail);
      const double head = std::min(8.0 * layout.unit, reach);
      add_polyline(arrows, std::array{tail, tip - head * along}, 2.5 * layout.unit);
      add_convex(arrows, std::array{tip, tip - head * along + 0.5 * head * perp(along),
                                    tip - head * along - 0.5 * head * perp(along)});
    }
    canvas.text(canvas.to_pixels(force.number_at),
                words::filled(words::lab::times_value, {{"number", fixed_text(force.share, 2)}}), size, look::white,
                engine::Align::center);
  }
  canvas.mesh(arrows, look::gold);
}

}  // namespace

void set_view(Canvas& canvas, const Scene& scene, const Rectangle& place) {
  const Camera camera = camera_of(scene, place);
  const Vec2 off = place.corner + 0.5 * place.size - 0.5 * Vec2{1.0 * canvas.width(), 1.0 * canvas.height()};
  canvas.set_view({camera.middle - (1.0 / camera.scale) * Vec2{off.x, -off.y}, camera.scale});
}

Vec2 to_world(const Scene& scene, const Rectangle& place, Vec2 pixel) {
  const Camera camera = camera_of(scene, place);
  const Vec2 off = pixel - place.corner - 0.5 * place.size;
  return camera.middle + (1.0 / camera.scale) * Vec2{off.x, -off.y};
}

void draw_world(Canvas& canvas, const Experiment& experiment, const Picture& picture, const Layout& layout) {
  canvas.clear(look::sky_top, look::sky_bottom);
  draw_grid(canvas, layout);
  Drawer drawer{canvas, layout};
  const auto benches = experiment.benches();
  for (std::size_t k = 0; k < benches.size(); ++k) drawer.add(*benches[k], picture.benches[k]);
  drawer.paint();
  draw_forces(canvas, picture.forces, layout);
  for (std::size_t k = 0; k < benches.size(); ++k)
    draw_dragged(canvas, *benches[k], picture.benches[k].snapshot, layout.unit);
}

}  // namespace game::lab
