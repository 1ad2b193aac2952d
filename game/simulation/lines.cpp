#include "game/simulation/lines.h"

#include <algorithm>

#include "ribbon/box2d/convert.h"

namespace game {

using ribbon::Vec2;
using ribbon::box2d::to_double;
using ribbon::box2d::to_float;

namespace {

constexpr double tie_speed = 4.0;  // m/s, of an end that is tied to a place

}  // namespace

Lines::Lines(const LineTuning& tuning, std::size_t count) : lines_{Line(tuning), Line(tuning)}, count_(count) {}

const Line* Lines::held() const {
  if (lines_[last_thrown_].is_held()) return &lines_[last_thrown_];
  const auto held = std::find_if(lines_.begin(), lines_.end(), [](const Line& line) { return line.is_held(); });
  return held == lines_.end() ? nullptr : &*held;
}

void Lines::use(const Command& command, const Targets& targets, Vec2 hand, ribbon::box2d::Coupling& coupling,
                double dt) {
  shared_ = targets.shared;
  for (Line& line : lines_) line.follow(coupling);
  for (std::size_t h = 0; h < most; ++h) {
    if (!command.throws[h]) continue;
    const std::size_t used = std::min(h, count_ - 1);
    if (release(lines_[used], coupling) || !targets.thrown) continue;
    if (is_shared(lines_[used])) hand_over(lines_[used], coupling);  // it was released before
    lines_[used].throw_at(*targets.thrown, hand, dt);
    last_thrown_ = used;
  }
  if (command.ties) tie(targets.at_hand, hand, coupling);
}

bool Lines::arrive() const {
  return std::any_of(lines_.begin(), lines_.end(), [](const Line& line) { return line.arrives(); });
}

void Lines::move(const Command& command, ribbon::box2d::Coupling& coupling, b2Body& body, Vec2 hand, double dt) {
  for (Line& line : lines_) {
    if (line.arrives() && is_shared(line)) hand_over(line, coupling);  // it was caught during the throw
    line.fly(coupling, body, hand);
    line.reel(command.reel, coupling, dt);
  }
  for (Knot& knot : std::span(knots_).first(knot_count_)) tighten(knot, coupling, dt);
}

bool Lines::release(ribbon::box2d::Coupling& coupling) {
  bool released = false;
  for (Line& line : lines_) released = release(line, coupling) || released;
  return released;
}

bool Lines::release(Line& line, ribbon::box2d::Coupling& coupling) {
  if (!line.is_held() || !is_shared(line)) return line.release(coupling);
  hand_over(line, coupling);
  return true;
}

/// Leaves a line to the other player, which hangs from it.
void Lines::hand_over(Line& line, ribbon::box2d::Coupling& coupling) {
  Knot left;
  left.cord = line.hand_over(coupling);
  add_knot(left, coupling);
}

/// Ties the two lines that are held to each other, or the one that is held to the target. The hands are free then.
void Lines::tie(const std::optional<Target>& target, Vec2 hand, ribbon::box2d::Coupling& coupling) {
  const int last = lines_.front().tuning().points - 1;
  const auto leave = [&](Line& line) { return is_shared(line) ? line.hand_over(coupling) : line.leave(coupling); };
  if (lines_[0].is_held() && lines_[1].is_held()) {
    Knot a;
    Knot b;
    a.cord = leave(lines_[0]);
    b.cord = leave(lines_[1]);
    coupling.tie({a.cord, last, b.cord, last});
    add_knot(a, coupling);
    add_knot(b, coupling);
    return;
  }
  const auto line = std::find_if(lines_.begin(), lines_.end(), [](const Line& each) { return each.is_held(); });
  if (line == lines_.end() || !target) return;
  Knot knot{0, hand, target->at, {}, false};
  ribbon::box2d::GripDef grip;
  grip.arc = line->length();
  knot.cord = grip.cord = leave(*line);
  if (target->body != nullptr) {
    grip.local_anchor = target->body->GetLocalPoint(to_float(hand));
    knot.end = to_double(grip.local_anchor);
    knot.place = to_double(target->local);
    knot.grip = coupling.hold(*target->body, grip);
  }
  add_knot(knot, coupling);
}

/// Moves the end of a knot nearer to its place. An end that jumped there would strain its link several times.
void Lines::tighten(Knot& knot, ribbon::box2d::Coupling& coupling, double dt) const {
  const bool is_there = knot.grip ? coupling.grip(*knot.grip).is_valid() : coupling.cord(knot.cord).is_valid();
  if (knot.is_tied || !is_there) return;
  const Vec2 way = knot.place - knot.end;
  const double step = tie_speed * dt;
  knot.is_tied = length(way) <= step;
  knot.end = knot.is_tied ? knot.place : knot.end + (step / length(way)) * way;
  if (knot.grip) return coupling.grip(*knot.grip).move_anchor(to_float(knot.end));
  coupling.cord(knot.cord).pin(lines_.front().tuning().points - 1, knot.end);
}

void Lines::add_knot(const Knot& knot, ribbon::box2d::Coupling& coupling) {
  if (knot_count_ == most_knots) {
    const auto first = std::find_if(knots_.begin(), knots_.end(), [this](const Knot& each) {
      return each.cord != shared_;  // the other player holds one cord at most
    });
    if (coupling.cord(first->cord).is_valid()) coupling.remove(first->cord);
    std::rotate(first, first + 1, knots_.end());
    --knot_count_;
  }
  knots_[knot_count_++] = knot;
}

/// The pieces stay as knots do, so that no run has ever more cords. A piece that the player hung from falls without it.
void Lines::follow_cuts(ribbon::box2d::Coupling& coupling) {
  for (const ribbon::box2d::CutEvent& event : coupling.last_step().cut_events()) {
    if (!forget(event.cord, coupling)) continue;
    for (const std::optional<ribbon::box2d::CordId>& piece : {event.first, event.second}) {
      Knot left;
      left.cord = piece.value_or(-1);
      if (piece) add_knot(left, coupling);
    }
  }
}

/// Forgets a cord that was cut, if it is the one of a line or a knot. Returns whether it was.
bool Lines::forget(ribbon::box2d::CordId cut, ribbon::box2d::Coupling& coupling) {
  for (Line& line : lines_) {
    if (line.cord() != cut) continue;
    line.hand_over(coupling);
    return true;
  }
  const auto end = knots_.begin() + static_cast<std::ptrdiff_t>(knot_count_);
  const auto knot = std::find_if(knots_.begin(), end, [cut](const Knot& each) { return each.cord == cut; });
  if (knot == end) return false;
  std::rotate(knot, knot + 1, end);
  --knot_count_;
  return true;
}

void Lines::add_to(ribbon::box2d::Hasher& hasher) const {
  for (const Line& line : all()) line.add_to(hasher);
  if (count_ > 1) hasher.add(static_cast<int>(last_thrown_));
  for (const Knot& knot : std::span(knots_).first(knot_count_)) {
    hasher.add(knot.cord);
    hasher.add(knot.end);
    hasher.add(knot.place);
    hasher.add(knot.grip.value_or(-1));
    hasher.add(static_cast<int>(knot.is_tied));
  }
}

}  // namespace game
