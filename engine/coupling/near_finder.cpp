#include "ribbon/box2d/near_finder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "ribbon/box2d/convert.h"

namespace ribbon::box2d {
namespace {

constexpr double travel_margin = 4.0;   // multiples of the distance that a body moves in a tick if nothing pushes it
constexpr double min_rounding = 1e-30;  // m
constexpr std::size_t group_size = LeafSearch::max_boxes;
constexpr int min_groups_per_task = 1;
constexpr int cache_line = 64;              // bytes
constexpr int next_in_body = 104;           // bytes, from a body's begin to its successor in the list; only for speed
constexpr std::size_t fetched_bodies = 16;  // of a walk, that are fetched from memory before they are read
constexpr int bodies_per_leaf = 30;         // that are walked through in the time that it takes to test a leaf
constexpr int list_again = 256;             // ticks after which distant leaves are counted again
constexpr float skin = 0.05F;    // m, by which the box of a search that is remembered is larger than asked for
constexpr int max_failures = 5;  // a remembered search that was of no use this often is tried every 2⁵ ticks

bool is_small(float number) { return std::abs(number) <= 1e9F; }  // false for NaN

bool is_sound(const b2AABB& box) {
  return is_small(box.lowerBound.x) && is_small(box.lowerBound.y) && is_small(box.upperBound.x) &&
         is_small(box.upperBound.y);
}

Box to_box(const b2AABB& box) { return {to_double(box.lowerBound), to_double(box.upperBound)}; }

/// Rounds a box outwards to single precision.
SearchBox search_box(const Box& box) {
  const auto rounding = [](double x) { return std::abs(x) * static_cast<double>(b2_epsilon) + min_rounding; };
  b2AABB aabb;
  aabb.lowerBound = to_float(box.low - Vec2{rounding(box.low.x), rounding(box.low.y)});
  aabb.upperBound = to_float(box.high + Vec2{rounding(box.high.x), rounding(box.high.y)});
  return SearchBox(aabb);
}

/// Box2D's own rule (b2ContactFilter::ShouldCollide).
bool should_collide(const b2Filter& a, const b2Filter& b) {
  if (a.groupIndex == b.groupIndex && a.groupIndex != 0) return a.groupIndex > 0;
  return (a.maskBits & b.categoryBits) != 0 && (a.categoryBits & b.maskBits) != 0;
}

/// Returns an upper bound of the distance that a part of a body moves in a tick, m. `fall` is g·dt² [m].
double max_travel(double fall) { return static_cast<double>(b2_maxTranslation) + travel_margin * fall; }

/// Returns the largest distance of a corner of a box from a position, m.
double extent(const Box& box, Vec2 from) {
  const Vec2 corner{std::max(from.x - box.low.x, box.high.x - from.x),
                    std::max(from.y - box.low.y, box.high.y - from.y)};
  return length(corner);
}

/// Returns an upper bound of the distance that a part of this body moves in a tick of dt seconds, m.
double travel_of(const b2Body& body, const Box& box, double fall, double dt) {
  const double turning = std::abs(static_cast<double>(body.GetAngularVelocity()));
  const double speed = static_cast<double>(body.GetLinearVelocity().Length()) +
                       (turning > 0.0 ? turning * extent(box, to_double(body.GetWorldCenter())) : 0.0);
  return std::min(max_travel(fall), travel_margin * (speed * dt + fall));
}

/// Starts to fetch the first and the last member that a walk through the bodies of a world reads of one. There need be
/// no body any more, and the address may be null.
void fetch_walked(const b2Body* body) {
  if (body == nullptr) return;
  const auto* const bytes = reinterpret_cast<const std::byte*>(body);
  prefetch(bytes);
  prefetch(bytes + next_in_body);
}

/// Adds a part of a fixture to the results of a query if the cord may touch it.
void test(b2Fixture& fixture, int child, const NearQuery& query, double fall, double dt) {
  const b2Body& body = *fixture.GetBody();
  const b2AABB& aabb = fixture.GetAABB(child);
  const bool is_sensor = fixture.IsSensor();  // which may be all of a dynamic body, without mass
  if (!is_sound(aabb) || !(is_sensor ? box2d::is_sound(body) : can_be_met(body))) return;
  const Box box = to_box(aabb);
  const double travel = travel_of(body, box, fall, dt);
  if (!overlap(box, widened(query.swept_aabb, travel))) return;
  if (!is_sensor && query.circles_only && fixture.GetType() != b2Shape::e_circle) return;
  if (!should_collide(fixture.GetFilterData(), query.filter)) return;
  (is_sensor ? query.sensors : query.near)->push_back({&fixture, child, travel});
}

const b2FixtureProxy& proxy_of(const b2TreeNode& leaf) { return *static_cast<const b2FixtureProxy*>(leaf.userData); }

void test(const b2FixtureProxy& proxy, const NearQuery& query, double fall, double dt) {
  test(*proxy.fixture, proxy.childIndex, query, fall, dt);
}

/// Returns whether a body moves. Then it may come near although its box in the tree is far away. Such a box has a
/// margin, but the body may have moved to its edge.
bool moves(const b2Body& body) {
  return body.GetType() != b2_staticBody && body.IsAwake() &&
         !(body.GetLinearVelocity() == b2Vec2_zero && body.GetAngularVelocity() == 0.0F);
}

}  // namespace

bool is_sound(const b2Body& body) {
  return is_small(body.GetPosition().x) && is_small(body.GetPosition().y) && is_small(body.GetAngle()) &&
         is_small(body.GetLinearVelocity().x) && is_small(body.GetLinearVelocity().y) &&
         is_small(body.GetAngularVelocity()) && is_small(body.GetWorldCenter().x) &&
         is_small(body.GetWorldCenter().y) && is_small(body.GetGravityScale());
}

bool can_be_met(const b2Body& body) {
  return is_sound(body) && (body.GetType() != b2_dynamicBody || body.GetMass() > 0.0F);
}

void NearFinder::reserve(std::size_t leaves, std::size_t cords) {
  if (tasks_.empty()) tasks_.emplace_back();
  tasks_.front().distant.reserve(leaves);
  tasks_.front().found.reserve(leaves);
  tasks_.front().search.reserve(leaves);
  while (groups_.size() * group_size < cords) {
    groups_.emplace_back();
    groups_.back().search.reserve(2 * leaves);
  }
  by_x_.reserve(cords);
  walked_.reserve(leaves);
}

/// A fixture whose box in the tree is not near a cord matters only if its body moves. Such fixtures are tested one by
/// one as long as that takes less time than a walk through all bodies; otherwise the moving bodies are walked through.
/// Where there were too many, they are counted again only from time to time.
void NearFinder::find(b2World& world, std::span<const NearQuery> queries, Vec2 gravity, double dt,
                      const ParallelFor& parallel_for) {
  const BroadPhaseTree tree(world.GetContactManager().m_broadPhase);
  if (tree.root() == b2_nullNode) return;
  walked_.resize(static_cast<std::size_t>(world.GetBodyCount()));  // now, so that what comes near allocates nothing
  dt_ = dt;
  fall_ = length(gravity) * dt * dt;
  const std::size_t groups = (queries.size() + group_size - 1) / group_size;
  groups_.resize(std::max(groups_.size(), groups));
  const int parts = parallel_for.parts(static_cast<int>(groups), min_groups_per_task);
  const auto count = static_cast<std::size_t>(parts);
  tasks_.resize(std::max(tasks_.size(), count));
  max_distant_ = static_cast<std::size_t>(world.GetBodyCount() / (bodies_per_leaf * parts));
  lists_distant_ = ticks_without_list_ % list_again == 0;
  is_recount_ = lists_distant_ && ticks_without_list_ > 0;
  parallel_for(parts, [&](int part) {
    const auto k = static_cast<std::size_t>(part);
    run(tasks_[k], tree, queries, groups * k / count, groups * (k + 1) / count);
  });
  const auto tasks = std::span(tasks_).first(count);
  if (!std::all_of(tasks.begin(), tasks.end(), [](const Task& task) { return task.lists_distant; })) {
    ++ticks_without_list_;
    test_moving_bodies(world, queries);
    return;
  }
  ticks_without_list_ = 0;
  for (const Task& task : tasks) {
    for (const auto& [k, leaf] : task.distant) test(proxy_of(tree[leaf]), queries[k], fall_, dt_);
  }
}

/// Runs the queries of the groups first … last − 1. It changes nothing but their results, the groups and the task.
void NearFinder::run(Task& task, const BroadPhaseTree& tree, std::span<const NearQuery> queries, std::size_t first,
                     std::size_t last) {
  task.distant.clear();
  task.found.clear();
  task.lists_distant = lists_distant_;
  for (; first < last; ++first) run_group(task, groups_[first], tree, queries, first * group_size);
}

/// Runs the queries of a group, from query `first` on. Neighbours in the list are mostly neighbours in the world, so
/// their boxes are searched together.
///
/// Bodies that do not move can only be in the smaller of the two boxes of a cord. While distant leaves are listed, the
/// search is for the larger one.
void NearFinder::run_group(Task& task, Group& group, const BroadPhaseTree& tree, std::span<const NearQuery> queries,
                           std::size_t first) {
  const auto of_group = queries.subspan(first, std::min(group_size, queries.size() - first));
  if (is_far_from_all(task, tree, of_group)) return;
  for (std::size_t k = 0; k < of_group.size(); ++k) {
    task.at_rest[k] = search_box(widened(of_group[k].swept_aabb, travel_margin * fall_));
    task.moving[k] =
        task.lists_distant ? search_box(widened(of_group[k].swept_aabb, max_travel(fall_))) : task.at_rest[k];
  }
  const auto boxes = std::span(task.moving).first(of_group.size());
  const auto take = [&](int leaf, BoxSet set) { take_leaf(task, tree, of_group, first, leaf, set); };
  if (group.lists_distant == task.lists_distant && group.search.is_current(tree, boxes)) {
    group.failures = 0;
    for (const RememberedSearch::Leaf& leaf : group.search.leaves()) take(leaf.node, leaf.boxes);
  } else if (group.pause > 0 || is_recount_) {
    group.pause = std::max(group.pause - 1, 0);
    task.search.find(tree, boxes, take);
  } else {
    group.lists_distant = task.lists_distant;
    group.pause = (1 << group.failures) - 1;
    group.failures = std::min(group.failures + 1, max_failures);
    for (std::size_t k = 0; k < boxes.size(); ++k) boxes[k] = boxes[k].widened(of_group[k].rests ? 0.0F : skin);
    group.search.search(task.search, tree, boxes);
    for (const RememberedSearch::Leaf& leaf : group.search.leaves()) take(leaf.node, leaf.boxes);
  }
  test_found(task);
}

/// Returns whether nothing can be near a group of cords, by the box around all of them. True is certain.
bool NearFinder::is_far_from_all(const Task& task, const BroadPhaseTree& tree,
                                 std::span<const NearQuery> of_group) const {
  Box all = of_group.front().swept_aabb;
  for (const NearQuery& query : of_group) all = joined(all, query.swept_aabb);
  const double travel = task.lists_distant ? max_travel(fall_) : travel_margin * fall_;
  return !may_overlap_leaf(tree, search_box(widened(all, travel)));
}

/// Takes a leaf that overlaps some boxes of a group, or of a search for larger boxes.
void NearFinder::take_leaf(Task& task, const BroadPhaseTree& tree, std::span<const NearQuery> queries,
                           std::size_t first, int leaf, BoxSet boxes) const {
  for_each_box(boxes, [&](std::size_t k) {
    if (task.at_rest[k].overlaps(tree[leaf].aabb)) {
      task.found.push_back({&proxy_of(tree[leaf]), &queries[k]});
    } else if (task.lists_distant) {
      task.distant.emplace_back(first + k, leaf);
    }
  });
  if (!task.lists_distant || task.distant.size() <= max_distant_) return;
  task.lists_distant = false;
  task.moving = task.at_rest;
}

/// Tests what a search found near cords. Proxies, fixtures and bodies are far apart in memory, so those of all results
/// are fetched at the same time before they are read.
void NearFinder::test_found(Task& task) const {
  constexpr int body_lines = 3;
  for (const Found& found : task.found) prefetch(found.proxy);
  for (const Found& found : task.found) prefetch(found.proxy->fixture);
  for (const Found& found : task.found) {
    const auto* body = reinterpret_cast<const std::byte*>(found.proxy->fixture->GetBody());
    for (int line = 0; line < body_lines; ++line) prefetch(body + cache_line * line);
  }
  for (const Found& found : task.found) test(*found.proxy, *found.query, fall_, dt_);
  task.found.clear();
}

/// Walks through all bodies of the world and tests those that move for all cords. Fixtures near a cord are found twice.
/// A list cannot be fetched ahead, but its addresses are mostly those of the last walk.
void NearFinder::test_moving_bodies(b2World& world, std::span<const NearQuery> queries) {
  sort_by_x(queries);
  std::size_t k = 0;
  for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext(), ++k) {
    if (k + fetched_bodies < walked_.size()) fetch_walked(walked_[k + fetched_bodies]);
    walked_[k] = body;
    if (!moves(*body) || !body->IsEnabled() || !is_sound(*body)) continue;
    for (b2Fixture* fixture = body->GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
      const int children = fixture->GetShape()->GetChildCount();
      for (int child = 0; child < children; ++child) test_moving_fixture(queries, *fixture, child);
    }
  }
}

/// Sorts the queries by the left side of their boxes. It starts from the order of the last tick, which is almost right.
void NearFinder::sort_by_x(std::span<const NearQuery> queries) {
  if (by_x_.size() != queries.size()) {
    by_x_.resize(queries.size());
    std::iota(by_x_.begin(), by_x_.end(), std::size_t{0});
  }
  max_width_ = 0.0;
  for (std::size_t k = 0; k < by_x_.size(); ++k) {
    const std::size_t query = by_x_[k];
    const Box& box = queries[query].swept_aabb;
    max_width_ = std::max(max_width_, box.high.x - box.low.x);
    std::size_t place = k;
    for (; place > 0 && queries[by_x_[place - 1]].swept_aabb.low.x > box.low.x; --place)
      by_x_[place] = by_x_[place - 1];
    by_x_[place] = query;
  }
}

/// Tests a part of a fixture of a moving body for all cords that it may reach.
void NearFinder::test_moving_fixture(std::span<const NearQuery> queries, b2Fixture& fixture, int child) {
  const b2AABB& aabb = fixture.GetAABB(child);
  if (!is_sound(aabb)) return;
  const Box box = to_box(aabb);
  const Box swept = widened(box, travel_of(*fixture.GetBody(), box, fall_, dt_));
  const auto begins_before = [queries](std::size_t k, double x) { return queries[k].swept_aabb.low.x < x; };
  auto k = std::lower_bound(by_x_.begin(), by_x_.end(), swept.low.x - max_width_, begins_before);
  for (; k != by_x_.end() && queries[*k].swept_aabb.low.x <= swept.high.x; ++k) {
    if (overlap(queries[*k].swept_aabb, swept)) test(fixture, child, queries[*k], fall_, dt_);
  }
}

}  // namespace ribbon::box2d
