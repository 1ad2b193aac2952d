#include "game/simulation/lines.h"

#include <algorithm>

namespace game {

using ribbon::Vec2;

Lines::Lines(const LineTuning& tuning, std::size_t count) : lines_{Line(tuning), Line(tuning)}, count_(count) {}

const Line* Lines::held() const {
  if (lines_[last_thrown_].is_held()) return &lines_[last_thrown_];
  const auto held = std::find_if(lines_.begin(), lines_.end(), [](const Line& line) { return line.is_held(); });
  return held == lines_.end() ? nullptr : &*held;
}

void Lines::use(const Command& command, const Targets& targets, Vec2 hand, ribbon::box2d::Coupling& coupling,
                double dt) {
  for (Line& line : lines_) line.follow(coupling);
  for (std::size_t h = 0; h < most; ++h) {
    if (!command.throws[h]) continue;
    const std::size_t used = std::min(h, count_ - 1);
    if (lines_[used].release(coupling) || !targets.thrown) continue;
    lines_[used].throw_at(*targets.thrown, hand, dt);
    last_thrown_ = used;
  }
  if (command.ties) tie(targets.at_hand, coupling);
}

bool Lines::arrive() const {
  return std::any_of(lines_.begin(), lines_.end(), [](const Line& line) { return line.arrives(); });
}

void Lines::move(const Command& command, ribbon::box2d::Coupling& coupling, b2Body& body, Vec2 hand, double dt) {
  for (Line& line : lines_) {
    line.fly(coupling, body, hand);
    line.reel(command.reel, coupling, dt);
  }
}

bool Lines::release(ribbon::box2d::Coupling& coupling) {
  bool released = false;
  for (Line& line : lines_) released = line.release(coupling) || released;
  return released;
}

/// Ties the two lines that are held to each other, or the one that is held to the target. The hands are free then.
void Lines::tie(const std::optional<Target>& target, ribbon::box2d::Coupling& coupling) {
  const int last = lines_.front().tuning().points - 1;
  if (lines_[0].is_held() && lines_[1].is_held()) {
    const ribbon::box2d::CordId a = lines_[0].leave(coupling);
    const ribbon::box2d::CordId b = lines_[1].leave(coupling);
    coupling.tie({a, last, b, last});
    remember_knot(a, coupling);
    remember_knot(b, coupling);
    return;
  }
  const auto line = std::find_if(lines_.begin(), lines_.end(), [](const Line& each) { return each.is_held(); });
  if (line == lines_.end() || !target) return;
  const double length = line->length();
  const ribbon::box2d::CordId cord = line->leave(coupling);
  if (target->body == nullptr) {
    coupling.cord(cord).pin(last, target->place());
  } else {
    ribbon::box2d::GripDef grip;
    grip.cord = cord;
    grip.arc = length;
    grip.local_anchor = target->local;
    coupling.hold(*target->body, grip);
  }
  remember_knot(cord, coupling);
}

void Lines::remember_knot(ribbon::box2d::CordId cord, ribbon::box2d::Coupling& coupling) {
  if (knot_count_ == most_knots) {
    if (coupling.cord(knots_.front()).is_valid()) coupling.remove(knots_.front());
    std::rotate(knots_.begin(), knots_.begin() + 1, knots_.end());
    --knot_count_;
  }
  knots_[knot_count_++] = cord;
}

void Lines::add_to(ribbon::box2d::Hasher& hasher) const {
  for (const Line& line : all()) line.add_to(hasher);
  if (count_ == 1) return;  // recordings of levels with one line end here
  hasher.add(static_cast<int>(last_thrown_));
  hasher.add(static_cast<int>(knot_count_));
}

}  // namespace game
