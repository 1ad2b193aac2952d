#include "ribbon/system/overstretch.h"

#include <cmath>

namespace ribbon {
namespace {

constexpr double min_strain = 0.05;      // of an overstretched link
constexpr double regained_share = 0.25;  // of what a link is too long by, in a step

bool can_be_overstretched(const CordParts& cord) {
  return cord.def.rows == 1 && std::isinf(cord.def.stretch_stiffness) && cord.state.pulleys.empty();
}

Vec2 vector_of(const CordParts& cord, std::size_t link) {
  return cord.state.positions[link + 1] - cord.state.positions[link];
}

bool is_overstretched(Vec2 link, double rest) {
  constexpr double max_ratio = 1.0 + min_strain;
  return dot(link, link) > max_ratio * max_ratio * rest * rest;
}

/// Returns what a link is too long by, m; 0 if it is not overstretched.
double excess(Vec2 link, double rest) { return is_overstretched(link, rest) ? length(link) - rest : 0.0; }

void set_own_rest_lengths(CordParts& cord, const std::vector<double>& own) {
  cord.state.rest = own;
  cord.elasticity->set_rest_lengths(own);
  if (cord.state.rest_targets.empty()) {
    cord.rest_start.clear();
    cord.rest_end.clear();
  } else {
    cord.rest_start = cord.own_rest_start;
    cord.rest_end = cord.own_rest_end;
  }
  cord.own_rest_start.clear();
  cord.own_rest_end.clear();
}

}  // namespace

double regained_length(const CordParts& cord) {
  if (!can_be_overstretched(cord)) return 0.0;
  const std::vector<double>& rest = cord.is_overstretched() ? cord.own_rest_start : cord.state.rest;
  double sum = 0.0;
  for (std::size_t link = 0; link < rest.size(); ++link) {
    if (const Vec2 along = vector_of(cord, link); is_overstretched(along, rest[link]))
      sum += length(along) - rest[link];
  }
  return regained_share * sum;
}

void load_overstretch(IslandState& state, const Member& member) {
  CordParts& cord = *member.cord;
  if (regained_length(cord) == 0.0) return;
  const bool reels = !cord.state.rest_targets.empty();
  cord.own_rest_start = cord.state.rest;
  cord.own_rest_end = reels ? cord.rest_end : cord.state.rest;
  cord.rest_start = cord.own_rest_start;
  cord.rest_end = cord.own_rest_end;
  for (std::size_t link = 0; link < cord.state.rest.size(); ++link) {
    const double too_long = excess(vector_of(cord, link), cord.own_rest_start[link]);
    if (too_long == 0.0) continue;
    cord.rest_start[link] += too_long;
    cord.rest_end[link] += (1.0 - regained_share) * too_long;
  }
  cord.state.rest = cord.rest_start;
  cord.elasticity->set_rest_lengths(cord.state.rest);
  state.overstretched = state.reeling = state.driven = true;
}

void reset_overstretch(CordParts& cord) {
  if (cord.is_overstretched()) set_own_rest_lengths(cord, cord.own_rest_start);
}

void store_overstretch(CordParts& cord) {
  if (!cord.is_overstretched()) return;
  set_own_rest_lengths(cord, cord.own_rest_end);
  cord.state.restart = true;
}

}  // namespace ribbon
