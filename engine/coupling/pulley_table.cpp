#include "ribbon/box2d/pulley_table.h"

#include <algorithm>
#include <string>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/near_finder.h"
#include "ribbon/definition.h"
#include "ribbon/pulley.h"

namespace ribbon::box2d {

PulleyId PulleyTable::add(CoupledCord& cord, b2Body& body, const PulleyDef& def) {
  const int index = add_pulley(cord.direct(), def);
  for (BodyPulley& other : pulleys_) {
    if (other.cord == cord.id && other.index >= index) ++other.index;
  }
  pulleys_.push_back({{next_, cord.id, index, body.GetLocalPoint(to_float(def.center))}, &body, SeenBody(body)});
  return next_++;
}

void PulleyTable::remove(PulleyId id, CordTable& cords) {
  const auto place =
      std::find_if(pulleys_.begin(), pulleys_.end(), [id](const BodyPulley& pulley) { return pulley.id == id; });
  if (place == pulleys_.end()) return;
  const BodyPulley removed = *place;
  pulleys_.erase(place);
  remove_pulley(cords.at(removed.cord).direct(), removed.index);
  for (BodyPulley& other : pulleys_) {
    if (other.cord == removed.cord && other.index > removed.index) --other.index;
  }
}

void PulleyTable::remove_all(CoupledCord& cord) {
  if (!cord.is_direct()) return;
  while (!pulleys_of(cord.direct()).empty()) remove_pulley(cord.direct(), 0);
  std::erase_if(pulleys_, [&cord](const BodyPulley& pulley) { return pulley.cord == cord.id; });
}

const BodyPulley* PulleyTable::find(PulleyId id) const {
  const auto found = std::lower_bound(pulleys_.begin(), pulleys_.end(), id,
                                      [](const BodyPulley& pulley, PulleyId wanted) { return pulley.id < wanted; });
  return found != pulleys_.end() && found->id == id ? &*found : nullptr;
}

const BodyPulley& PulleyTable::at(PulleyId id) const {
  if (const BodyPulley* const found = find(id)) return *found;
  throw CallError("pulley is " + std::to_string(id) + "; accepted is the id of one that has not been removed");
}

template <typename Condition>
void PulleyTable::remove_if(CordTable& cords, Condition&& condition) {
  for (std::size_t k = 0; k < pulleys_.size();) {
    if (condition(pulleys_[k])) {
      remove(pulleys_[k].id, cords);
    } else {
      ++k;
    }
  }
}

void PulleyTable::forget(const b2Body& body, CordTable& cords) {
  remove_if(cords, [&body](const BodyPulley& pulley) { return pulley.body == &body; });
}

void PulleyTable::drop_unable(BodyFinder& finder, bool trusts_forget, CordTable& cords) {
  if (pulleys_.empty()) return;
  if (!trusts_forget) {
    finder.clear();
    for (const BodyPulley& pulley : pulleys_) finder.want(pulley.body);
    finder.search();
    remove_if(cords, [&finder](const BodyPulley& pulley) { return !finder.was_found(pulley.seen); });
  }
  remove_if(cords, [](const BodyPulley& pulley) { return !pulley.body->IsEnabled() || !is_sound(*pulley.body); });
  for (BodyPulley& pulley : pulleys_) pulley.seen = SeenBody(*pulley.body);
}

void PulleyTable::gather(CordTable& cords, const std::function<int(b2Body&)>& index_of) const {
  for (const BodyPulley& pulley : pulleys_) {
    CoupledCord& cord = cords.at(pulley.cord);
    cord.axles.resize(pulleys_of(cord.direct()).size());
    const Vec2 axle = to_double(pulley.body->GetWorldPoint(pulley.local_anchor));
    cord.axles[static_cast<std::size_t>(pulley.index)] = {index_of(*pulley.body),
                                                          axle - to_double(pulley.body->GetWorldCenter())};
  }
}

/// The pieces have the pulleys in the order that they had.
void PulleyTable::follow_cut(CoupledCord& whole, const std::function<CoupledCord*(const Pulley&)>& piece_of) {
  std::erase_if(pulleys_, [&](BodyPulley& pulley) {
    if (pulley.cord != whole.id) return false;
    const auto all = pulleys_of(whole.direct());
    const auto index = static_cast<std::size_t>(pulley.index);
    CoupledCord* const piece = piece_of(all[index]);
    if (piece == nullptr) return true;
    const auto before = std::count_if(all.begin(), all.begin() + pulley.index,
                                      [&](const Pulley& other) { return piece_of(other) == piece; });
    pulley.cord = piece->id;
    pulley.index = static_cast<int>(before);
    return false;
  });
}

void PulleyTable::clear(PulleyId next) {
  pulleys_.clear();
  next_ = next;
}

void PulleyTable::restore(const PulleyMemory& memory, b2Body& body) {
  pulleys_.push_back({memory, &body, SeenBody(body)});
}

}  // namespace ribbon::box2d
