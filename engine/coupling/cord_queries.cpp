#include "ribbon/box2d/cord_queries.h"

#include <box2d/b2_distance.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/slot.h"

namespace ribbon::box2d {
namespace {

constexpr std::size_t block = 8;  // links of a cord that have one box in the tree
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr float rounding = 1e-5F;  // of a fraction of a ray, in single precision

/// A link of a rope or of the outline of a ribbon.
struct Link {
  int a, b;          // indices of its points
  bool is_reversed;  // b is in the column before a
};

struct Entry {
  CordId id;
  CordShape shape;
  double radius;
  std::uint16_t category;
  std::size_t first_point;  // in the positions of all cords
  std::size_t first_link, end_link;
  std::size_t first_block;
};

/// Appends the links around a cord, as its outline goes.
void add_links(const CordShape& shape, std::vector<Link>& links) {
  const int rows = shape.rows;
  const int last = (shape.columns - 1) * rows;
  for (int a = 0; a < last; a += rows) links.push_back({a, a + rows, false});
  if (rows == 1) return;
  for (int a = last; a < last + rows - 1; ++a) links.push_back({a, a + 1, false});
  for (int a = last + rows - 1; a > rows - 1; a -= rows) links.push_back({a, a - rows, true});
  for (int a = rows - 1; a > 0; --a) links.push_back({a, a - 1, false});
}

/// The share of the segment from a to b that is nearest to p.
double nearest_share(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 ab = b - a;
  const double size2 = dot(ab, ab);
  return size2 > 0.0 ? std::clamp(dot(p - a, ab) / size2, 0.0, 1.0) : 0.0;
}

double distance(Vec2 p, Vec2 a, Vec2 b) { return length(p - (a + nearest_share(p, a, b) * (b - a))); }

/// The fraction of a ray at which it enters the circle around c, or infinity. It begins outside.
double enter_circle(Vec2 from, Vec2 ray, Vec2 c, double radius) {
  const Vec2 f = from - c;
  const double a = dot(ray, ray);
  const double b = dot(f, ray);
  const double discriminant = b * b - a * (dot(f, f) - radius * radius);
  if (!(discriminant >= 0.0) || radius == 0.0) return infinity;
  const double t = (-b - std::sqrt(discriminant)) / a;
  return t >= 0.0 ? t : infinity;
}

/// The fraction of a ray at which it enters a link of this radius, or infinity: at one of its sides, which are parallel
/// to it, or at one of its round ends.
double enter_link(Vec2 from, Vec2 ray, double ray_length, Vec2 a, Vec2 b, double radius) {
  // Most links are on one side of the ray's line.
  const double side_a = cross(ray, a - from);
  const double side_b = cross(ray, b - from);
  const double wide = radius * ray_length;
  if ((side_a > wide && side_b > wide) || (side_a < -wide && side_b < -wide)) return infinity;
  if (distance(from, a, b) <= radius) return 0.0;
  double first = std::min(enter_circle(from, ray, a, radius), enter_circle(from, ray, b, radius));
  const Vec2 ab = b - a;
  const double turn = cross(ray, ab);
  const double size = length(ab);
  if (turn == 0.0 || size == 0.0) return first;
  const Vec2 offset = (radius / size) * perp(ab);
  for (const Vec2 side : {a + offset, a - offset}) {
    const double t = cross(side - from, ab) / turn;
    const double s = cross(side - from, ray) / turn;
    if (t >= 0.0 && s >= 0.0 && s <= 1.0) first = std::min(first, t);
  }
  return first;
}

b2AABB to_aabb(const Box& box) { return {to_float(box.low), to_float(box.high)}; }

/// The user data of a proxy is the index of its block.
void* user_data(std::size_t index) {
  return reinterpret_cast<void*>(index);  // NOLINT(performance-no-int-to-ptr): Box2D stores a pointer
}
std::size_t index_of(void* data) { return reinterpret_cast<std::size_t>(data); }

/// Calls a function with each box of the tree that a query meets.
template <typename Visit>
struct BoxVisitor {
  const b2DynamicTree& tree;
  Visit& visit;
  bool QueryCallback(int proxy) {  // NOLINT(readability-identifier-naming): called by Box2D
    visit(index_of(tree.GetUserData(proxy)));
    return true;
  }
};

/// The same for a ray; `visit` returns the fraction up to which it is followed from then on.
template <typename Visit>
struct RayVisitor {
  const b2DynamicTree& tree;
  Visit& visit;
  float RayCastCallback(const b2RayCastInput& input, int proxy) {  // NOLINT(readability-identifier-naming)
    const double end = visit(index_of(tree.GetUserData(proxy)));
    return std::min(input.maxFraction, static_cast<float>(end) + rounding);
  }
};

}  // namespace

struct CordQueries::Parts {
  std::vector<Entry> cords, cords_before;
  std::vector<Link> links;
  std::vector<Vec2> positions;
  std::vector<std::size_t> block_cords;  // by block
  std::vector<int> proxies;              // by block
  b2DynamicTree tree;

  void list(const Coupling& coupling);
  bool has_same_links() const;
  void rebuild();
  Box box_of(const Entry& cord, std::size_t first, std::size_t end) const;
  static bool finds(const Entry& cord, const QueryFilter& filter) {
    if ((cord.category & filter.mask) == 0) return false;
    return std::find(filter.except.begin(), filter.except.end(), cord.id) == filter.except.end();
  }
  Vec2 at(const Entry& cord, int point) const { return positions[cord.first_point + slot(point)]; }
  /// Calls visit(cord, link) for each link of a block, if the filter finds its cord.
  template <typename Visit>
  void for_links(std::size_t index, const QueryFilter& filter, Visit&& visit) const {
    const Entry& cord = cords[block_cords[index]];
    if (!finds(cord, filter)) return;
    const std::size_t first = cord.first_link + (index - cord.first_block) * block;
    const std::size_t end = std::min(first + block, cord.end_link);
    for (std::size_t k = first; k < end; ++k) visit(cord, links[k]);
  }
  template <typename Visit>
  void for_near(const b2AABB& box, const QueryFilter& filter, Visit&& visit) const {
    const auto visit_block = [&](std::size_t index) { for_links(index, filter, visit); };
    BoxVisitor<const decltype(visit_block)> visitor{tree, visit_block};
    tree.Query(&visitor, box);
  }
  /// The hit of a ray that enters a link of a cord at a fraction of its length.
  RayHit hit_at(const Entry& cord, const Link& link, Vec2 from, Vec2 ray, double fraction) const;
};

void CordQueries::Parts::list(const Coupling& coupling) {
  cords.swap(cords_before);
  cords.clear();
  positions.clear();
  for (const CordId id : coupling.cords()) {
    const CordView cord = coupling.cord(id);
    if (!cord.is_enabled()) continue;
    const double radius = cord.solver() == Solver::direct ? cord.direct().def().radius : 0.0;
    const auto x = cord.positions();
    cords.push_back({id, cord.shape(), radius, cord.filter().categoryBits, positions.size(), 0, 0, 0});
    positions.insert(positions.end(), x.begin(), x.end());
  }
}

bool CordQueries::Parts::has_same_links() const {
  const auto is_same = [](const Entry& a, const Entry& b) {
    return a.id == b.id && a.shape.columns == b.shape.columns && a.shape.rows == b.shape.rows;
  };
  return std::equal(cords.begin(), cords.end(), cords_before.begin(), cords_before.end(), is_same);
}

/// Lists the links and gives each block of them a proxy in the tree.
void CordQueries::Parts::rebuild() {
  for (const int proxy : proxies) tree.DestroyProxy(proxy);
  proxies.clear();
  block_cords.clear();
  links.clear();
  for (std::size_t c = 0; c < cords.size(); ++c) {
    Entry& cord = cords[c];
    cord.first_link = links.size();
    cord.first_block = block_cords.size();
    add_links(cord.shape, links);
    cord.end_link = links.size();
    for (std::size_t first = cord.first_link; first < cord.end_link; first += block) {
      const b2AABB box = to_aabb(box_of(cord, first, std::min(first + block, cord.end_link)));
      proxies.push_back(tree.CreateProxy(box, user_data(block_cords.size())));
      block_cords.push_back(c);
    }
  }
}

Box CordQueries::Parts::box_of(const Entry& cord, std::size_t first, std::size_t end) const {
  Box box = box_around(at(cord, links[first].a), at(cord, links[first].b), cord.radius);
  for (std::size_t k = first + 1; k < end; ++k) {
    box = joined(box, box_around(at(cord, links[k].a), at(cord, links[k].b), cord.radius));
  }
  return box;
}

CordQueries::CordQueries() : parts_(std::make_unique<Parts>()) {}
CordQueries::CordQueries(CordQueries&& other) noexcept = default;
CordQueries& CordQueries::operator=(CordQueries&& other) noexcept = default;
CordQueries::~CordQueries() = default;

void CordQueries::update(const Coupling& coupling) {
  Parts& parts = *parts_;
  parts.list(coupling);
  if (!parts.has_same_links()) return parts.rebuild();
  for (std::size_t c = 0; c < parts.cords.size(); ++c) {
    Entry& cord = parts.cords[c];
    const Entry& before = parts.cords_before[c];
    cord.first_link = before.first_link;
    cord.end_link = before.end_link;
    cord.first_block = before.first_block;
    std::size_t index = cord.first_block;
    for (std::size_t first = cord.first_link; first < cord.end_link; first += block, ++index) {
      const b2AABB box = to_aabb(parts.box_of(cord, first, std::min(first + block, cord.end_link)));
      parts.tree.MoveProxy(parts.proxies[index], box, {0.0F, 0.0F});
    }
  }
}

RayHit CordQueries::Parts::hit_at(const Entry& cord, const Link& link, Vec2 from, Vec2 ray, double fraction) const {
  const Vec2 a = at(cord, link.a);
  const Vec2 b = at(cord, link.b);
  RayHit result;
  result.cord = cord.id;
  result.fraction = fraction;
  result.position = from + fraction * ray;
  const double share = nearest_share(result.position, a, b);
  const bool is_across = std::abs(link.a - link.b) != cord.shape.rows && cord.shape.rows > 1;
  result.point = link.is_reversed ? link.b : link.a;
  result.along = is_across ? 0.0 : link.is_reversed ? 1.0 - share : share;
  const Vec2 out = result.position - (a + share * (b - a));
  const double ray_length = length(ray);
  const Vec2 against = ray_length > 0.0 ? (-1.0 / ray_length) * ray : Vec2{0.0, 1.0};
  if (fraction == 0.0) {
    result.normal = against;
  } else if (cord.radius > 0.0) {
    result.normal = (1.0 / length(out)) * out;
  } else {
    const Vec2 side = (1.0 / length(b - a)) * perp(b - a);
    result.normal = dot(side, against) >= 0.0 ? side : -side;
  }
  return result;
}

std::optional<RayHit> CordQueries::ray_cast(Vec2 from, Vec2 to, const QueryFilter& filter) const {
  check_coordinates("from", from);
  check_coordinates("to", to);
  const Vec2 ray = to - from;
  const double ray_length = length(ray);
  double first = infinity;
  const Entry* hit = nullptr;
  Link hit_link{};
  const auto visit = [&](const Entry& cord, const Link& link) {
    const double t = enter_link(from, ray, ray_length, parts_->at(cord, link.a), parts_->at(cord, link.b), cord.radius);
    if (!(t <= 1.0) || t > first) return;
    if (t == first && (cord.id > hit->id || (cord.id == hit->id && link.a > hit_link.a))) return;
    first = t;
    hit = &cord;
    hit_link = link;
  };
  const b2RayCastInput input{to_float(from), to_float(to), 1.0F};
  if (input.p1 == input.p2) {  // not a ray in single precision
    parts_->for_near(to_aabb(box_around(from, to, 0.0)), filter, visit);
  } else {
    const auto visit_block = [&](std::size_t index) {
      parts_->for_links(index, filter, visit);
      return std::min(first, 1.0);
    };
    RayVisitor<const decltype(visit_block)> visitor{parts_->tree, visit_block};
    parts_->tree.RayCast(&visitor, input);
  }
  if (hit == nullptr) return std::nullopt;
  return parts_->hit_at(*hit, hit_link, from, ray, first);
}

std::optional<CordPoint> CordQueries::nearest_place(Vec2 position, double reach, const QueryFilter& filter) const {
  check_coordinates("position", position);
  check_range("reach", reach, 0.0, 1e9);
  std::optional<CordPoint> nearest;
  const auto is_before = [](const CordPoint& a, const CordPoint& b) {
    if (a.distance != b.distance) return a.distance < b.distance;
    return a.cord != b.cord ? a.cord < b.cord : a.point < b.point;
  };
  const auto visit = [&](const Entry& cord, const Link& link) {
    const Vec2 a = parts_->at(cord, link.a);
    const Vec2 b = parts_->at(cord, link.b);
    const double share = nearest_share(position, a, b);
    const bool is_across = std::abs(link.a - link.b) != cord.shape.rows && cord.shape.rows > 1;
    CordPoint place{cord.id, link.is_reversed ? link.b : link.a, length(a + share * (b - a) - position)};
    place.along = is_across ? 0.0 : link.is_reversed ? 1.0 - share : share;
    if (place.distance <= reach && (!nearest || is_before(place, *nearest))) nearest = place;
  };
  parts_->for_near(to_aabb(box_around(position, position, reach)), filter, visit);
  return nearest;
}

void CordQueries::find_overlaps(const b2Shape& shape, const b2Transform& transform, std::vector<CordPoint>& found,
                                const QueryFilter& filter) const {
  found.clear();
  for (int child = 0; child < shape.GetChildCount(); ++child) {
    b2AABB box;
    shape.ComputeAABB(&box, transform, child);
    b2DistanceInput input{};
    input.proxyA.Set(&shape, child);
    input.transformA = transform;
    input.transformB.SetIdentity();
    input.useRadii = true;
    parts_->for_near(box, filter, [&](const Entry& cord, const Link& link) {
      // Relative to the shape, so that single precision is fine enough.
      const Vec2 origin = to_double(transform.p);
      const std::array<b2Vec2, 2> ends{to_float(parts_->at(cord, link.a) - origin),
                                       to_float(parts_->at(cord, link.b) - origin)};
      input.transformA.p.SetZero();
      input.proxyB.Set(ends.data(), 2, static_cast<float>(cord.radius));
      b2SimplexCache cache{};
      b2DistanceOutput output{};
      b2Distance(&output, &cache, &input);
      if (output.distance > 0.0F) return;
      CordPoint place{cord.id, link.is_reversed ? link.b : link.a};
      const auto same = std::lower_bound(found.begin(), found.end(), place,
                                         [](const CordPoint& a, const CordPoint& b) { return a.cord < b.cord; });
      if (same == found.end() || same->cord != cord.id) {
        found.insert(same, place);
      } else if (place.point < same->point) {
        *same = place;
      }
    });
  }
}

}  // namespace ribbon::box2d
