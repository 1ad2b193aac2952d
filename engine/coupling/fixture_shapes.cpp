#include "ribbon/box2d/fixture_shapes.h"

#include <algorithm>

#include "ribbon/box2d/convert.h"

namespace ribbon::box2d {
namespace {

constexpr std::uint64_t max_features = 1U << 20U;  // of a fixture; a chain has less than half as many vertices

/// Limits a value to 0 … max; NaN becomes 0. Box2D accepts any value.
double within(float value, double max) { return value > 0.0F ? std::min(static_cast<double>(value), max) : 0.0; }

/// The corners and edges of one fixture.
class Outline {
 public:
  Outline(const b2Fixture& fixture, int body, std::uint64_t id, const Box& box) : body_(body), id_(id), box_(box) {
    const b2Body& owner = *fixture.GetBody();
    transform_ = owner.GetTransform();
    center_ = to_double(owner.GetWorldCenter());
    friction_ = within(fixture.GetFriction(), 10.0);
    restitution_ = within(fixture.GetRestitution(), 1.0);
  }

  void add_corner(b2Vec2 local, float radius, std::uint64_t feature, std::vector<RigidCircle>& circles) const {
    const Vec2 x = to_double(b2Mul(transform_, local));
    const double r = static_cast<double>(radius);
    if (!overlap({x - Vec2{r, r}, x + Vec2{r, r}}, box_)) return;
    circles.push_back({body_, x - center_, r, friction_, restitution_, id_ * max_features + 2 * feature});
  }

  void add_edge(b2Vec2 local_a, b2Vec2 local_b, float radius, std::uint64_t feature,
                std::vector<RigidSegment>& segments) const {
    const Vec2 a = to_double(b2Mul(transform_, local_a));
    const Vec2 b = to_double(b2Mul(transform_, local_b));
    const double r = static_cast<double>(radius);
    const Vec2 low{std::min(a.x, b.x) - r, std::min(a.y, b.y) - r};
    const Vec2 high{std::max(a.x, b.x) + r, std::max(a.y, b.y) + r};
    if (!overlap({low, high}, box_)) return;
    segments.push_back(
        {body_, a - center_, b - center_, r, friction_, restitution_, id_ * max_features + 2 * feature + 1});
  }

 private:
  int body_;
  std::uint64_t id_;
  Box box_;
  b2Transform transform_;
  Vec2 center_;
  double friction_;
  double restitution_;
};

}  // namespace

std::uint64_t fixture_of(std::uint64_t id) { return id >> 63U != 0 ? 0 : id / max_features; }

void add_shapes(std::span<const NearShape> parts, int body, const Box& swept_aabb, std::vector<RigidCircle>& circles,
                std::vector<RigidSegment>& segments) {
  const NearShape& first = parts.front();
  const b2Fixture& fixture = *first.fixture;
  const b2Shape* shape = fixture.GetShape();
  double travel = 0.0;
  for (const NearShape& part : parts) travel = std::max(travel, part.travel);
  const Outline outline(fixture, body, first.number, widened(swept_aabb, travel));
  const auto add_line = [&](const b2Vec2* vertices, int count, bool closed) {
    for (int k = 0; k < count; ++k) {
      const auto feature = static_cast<std::uint64_t>(k);
      outline.add_corner(vertices[k], shape->m_radius, feature, circles);
      if (k + 1 < count || closed) {
        outline.add_edge(vertices[k], vertices[(k + 1) % count], shape->m_radius, feature, segments);
      }
    }
  };
  switch (fixture.GetType()) {
    case b2Shape::e_circle:
      outline.add_corner(static_cast<const b2CircleShape*>(shape)->m_p, shape->m_radius, 0, circles);
      break;
    case b2Shape::e_edge: {
      const auto& edge = static_cast<const b2EdgeShape&>(*shape);
      const b2Vec2 vertices[2] = {edge.m_vertex1, edge.m_vertex2};
      add_line(vertices, 2, false);
      break;
    }
    case b2Shape::e_polygon: {
      const auto& polygon = static_cast<const b2PolygonShape&>(*shape);
      add_line(polygon.m_vertices, polygon.m_count, true);
      break;
    }
    case b2Shape::e_chain: {
      // The last vertex of a loop is its first one again. The second corner there does no harm.
      const auto& chain = static_cast<const b2ChainShape&>(*shape);
      int next_corner = 0;
      for (const NearShape& part : parts) {
        for (int k = std::max(next_corner, part.child); k <= part.child + 1; ++k) {
          outline.add_corner(chain.m_vertices[k], shape->m_radius, static_cast<std::uint64_t>(k), circles);
        }
        next_corner = part.child + 2;
        outline.add_edge(chain.m_vertices[part.child], chain.m_vertices[part.child + 1], shape->m_radius,
                         static_cast<std::uint64_t>(part.child), segments);
      }
      break;
    }
    default: break;
  }
}

}  // namespace ribbon::box2d
