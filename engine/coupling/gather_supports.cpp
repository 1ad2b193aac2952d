#include "ribbon/box2d/gather_supports.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "ribbon/box2d/supports.h"

namespace ribbon::box2d {
namespace {

constexpr int max_depth = 2;  // of bodies that press on one another

/// Gathers the supports of one cord.
class SupportGatherer {
 public:
  SupportGatherer(CouplingParts& parts, CoupledCord& cord) : parts_(parts), cord_(cord) {
    parts_.supported.clear();
    for (const Grip& grip : cord.grips) visit(grip.body);
    for (const Axle& axle : cord.axles) visit(axle.body);
    for (const RigidCircle& circle : cord.circles) visit(circle.body);
    for (const RigidSegment& segment : cord.segments) visit(segment.body);
  }

  void gather() {
    for (std::size_t k = 0; k < parts_.supported.size(); ++k) gather_of(parts_.supported[k]);
    for (const Support& support : cord_.supports) {
      leave(support.body, support.normal);
      if (support.other >= 0) leave(support.other, -support.normal);
    }
  }

 private:
  bool is_known(int body) const {
    const auto& known = parts_.supported;
    return std::any_of(known.begin(), known.end(), [body](const SupportedBody& of) { return of.index == body; });
  }

  void visit(int body) {
    const auto& known = parts_.supported;
    if (!known.empty() && known.back().index == body) return;  // another shape of the same body
    if (parts_.bodies.rigid[static_cast<std::size_t>(body)].inverse_mass == 0.0 || is_known(body)) return;
    parts_.supported.push_back({body, 0});
  }

  /// A support between two bodies is added with the one that has the lower index.
  void gather_of(SupportedBody of) {
    const auto index = static_cast<std::size_t>(of.index);
    const double reach = parts_.grips.reach_of_kept_off(cord_, of.index, parts_.conditions.dt);
    std::vector<FoundSupport>& found = parts_.found_supports;
    found.clear();
    const double max_push = append_supports(*parts_.bodies.entries[index].body, {reach, parts_.near_fixtures}, found);
    if (found.empty()) return;
    parts_.bodies.entries[index].max_push = max_push;
    for (FoundSupport& support : found) {
      support.support.body = of.index;
      support.support.arm = support.place - parts_.bodies.rigid[index].position;
      if (support.other != nullptr && !find_other(support, of)) continue;
      cord_.supports.push_back(support.support);
    }
  }

  bool find_other(FoundSupport& found, SupportedBody of) {
    if (of.depth == max_depth && parts_.bodies.find(found.other) == nullptr) return false;
    const int other = parts_.bodies.index_of(*found.other, parts_.carry, parts_.conditions);
    if (of.depth == max_depth && !is_known(other)) return false;
    if (!is_known(other)) parts_.supported.push_back({other, of.depth + 1});
    found.support.other = other;
    found.support.other_arm = found.place - parts_.bodies.rigid[static_cast<std::size_t>(other)].position;
    return of.index < other;
  }

  void leave(int body, Vec2 normal) {
    const auto index = static_cast<std::size_t>(body);
    parts_.carry.leave_to_support(*parts_.bodies.entries[index].body, parts_.bodies.rigid[index], normal,
                                  parts_.conditions.dt);
  }

  CouplingParts& parts_;
  CoupledCord& cord_;
};

}  // namespace

void gather_supports(CouplingParts& parts) {
  for (CoupledCord& cord : parts.cords.active()) {
    if (cord.enabled && cord.is_direct()) SupportGatherer(parts, cord).gather();
  }
}

}  // namespace ribbon::box2d
