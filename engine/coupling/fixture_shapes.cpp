#include "ribbon/box2d/fixture_shapes.h"

#include <algorithm>

#include "ribbon/box2d/convert.h"

namespace ribbon::box2d {
namespace {

constexpr std::uint64_t max_features = 1U << 20U;  // of a fixture; a chain has less than half as many vertices

/// Limits a value to 0 … max; NaN becomes 0. Box2D accepts any value.
double within(float value, double max) { return value > 0.0F ? std::min(static_cast<double>(value), max) : 0.0; }

/// The lists that the parts of a fixture are added to.
struct Parts {
  std::vector<RigidCircle>& circles;
  std::vector<RigidSegment>& segments;
};

/// The corners and edges of one fixture.
class Outline {
 public:
  Outline(const b2Fixture& fixture, int body, std::uint64_t id, const Box& box, const Parts& parts)
      : parts_(parts), body_(body), id_(id), box_(box), radius_(fixture.GetShape()->m_radius) {
    const b2Body& owner = *fixture.GetBody();
    transform_ = owner.GetTransform();
    center_ = to_double(owner.GetWorldCenter());
    friction_ = within(fixture.GetFriction(), 10.0);
    restitution_ = within(fixture.GetRestitution(), 1.0);
  }

  void add_corner(b2Vec2 local, int number) const {
    const Vec2 x = to_double(b2Mul(transform_, local));
    const auto r = static_cast<double>(radius_);
    if (!overlap({x - Vec2{r, r}, x + Vec2{r, r}}, box_)) return;
    parts_.circles.push_back({body_, x - center_, r, friction_, restitution_, feature(number)});
  }

  void add_edge(b2Vec2 local_a, b2Vec2 local_b, int number) const {
    const Vec2 a = to_double(b2Mul(transform_, local_a));
    const Vec2 b = to_double(b2Mul(transform_, local_b));
    const auto r = static_cast<double>(radius_);
    const Vec2 low{std::min(a.x, b.x) - r, std::min(a.y, b.y) - r};
    const Vec2 high{std::max(a.x, b.x) + r, std::max(a.y, b.y) + r};
    if (!overlap({low, high}, box_)) return;
    parts_.segments.push_back({body_, a - center_, b - center_, r, friction_, restitution_, feature(number) + 1});
  }

  void add_polygon(const b2PolygonShape& polygon) const {
    for (int k = 0; k < polygon.m_count; ++k) {
      add_corner(polygon.m_vertices[k], k);
      add_edge(polygon.m_vertices[k], polygon.m_vertices[(k + 1) % polygon.m_count], k);
    }
  }

  /// The last vertex of a loop is its first one again. The second corner there does no harm.
  void add_chain(const b2ChainShape& chain, std::span<const NearShape> children) const {
    int next_corner = 0;
    for (const NearShape& part : children) {
      for (int k = std::max(next_corner, part.child); k <= part.child + 1; ++k) add_corner(chain.m_vertices[k], k);
      next_corner = part.child + 2;
      add_edge(chain.m_vertices[part.child], chain.m_vertices[part.child + 1], part.child);
    }
  }

 private:
  std::uint64_t feature(int number) const { return id_ * max_features + 2 * static_cast<std::uint64_t>(number); }

  Parts parts_;
  int body_;
  std::uint64_t id_;
  Box box_;
  float radius_;
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
  const Outline outline(fixture, body, first.number, widened(swept_aabb, travel), {circles, segments});
  switch (fixture.GetType()) {
    case b2Shape::e_circle: outline.add_corner(static_cast<const b2CircleShape*>(shape)->m_p, 0); break;
    case b2Shape::e_edge: {
      const auto& edge = static_cast<const b2EdgeShape&>(*shape);
      outline.add_corner(edge.m_vertex1, 0);
      outline.add_edge(edge.m_vertex1, edge.m_vertex2, 0);
      outline.add_corner(edge.m_vertex2, 1);
      break;
    }
    case b2Shape::e_polygon: outline.add_polygon(static_cast<const b2PolygonShape&>(*shape)); break;
    case b2Shape::e_chain: outline.add_chain(static_cast<const b2ChainShape&>(*shape), parts); break;
    default: break;
  }
}

}  // namespace ribbon::box2d
