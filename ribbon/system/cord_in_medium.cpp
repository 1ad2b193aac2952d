#include "ribbon/system/cord_in_medium.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ribbon/linear/index.h"

namespace ribbon {
namespace {

constexpr double max_speed = 1e6;            // m/s, in each component, of a medium
constexpr double max_density = 1e6;          // kg/m³
constexpr double min_half_height = 0.02;     // of a link, so that a thin cord has no jump at a surface
constexpr double min_terminal_factor = 2.0;  // of the terminal velocity, by which buoyancy may change the velocity

/// Half a link, or the share of a row of it: what belongs to one of its points.
struct Piece {
  double length = 0.0;  // m
  double share = 1.0;   // of the row
  Vec2 along;           // unit vector; zero if the link has no direction
};

/// The pieces of a point: one or two.
struct Pieces {
  std::array<Piece, 2> all;
  std::size_t count = 0;

  std::span<const Piece> list() const { return std::span(all).first(count); }
  double length() const { return count == 2 ? all[0].length + all[1].length : all[0].length; }
};

Pieces pieces_of(const CordParts& cord, std::span<const Vec2> x, std::size_t point) {
  const auto rows = static_cast<std::size_t>(cord.def.rows);
  const std::size_t column = point / rows;
  const std::size_t row = point % rows;
  const double edge = row == 0 || row == rows - 1 ? 0.5 : 1.0;
  const double share = rows == 1 ? 1.0 : edge / static_cast<double>(rows - 1);
  Pieces pieces;
  const auto add = [&](std::size_t other, std::size_t link) {
    const Vec2 way = x[other] - x[point];
    const double size = length(way);
    pieces.all[pieces.count++] = {0.5 * cord.state.rest[link], share, size > 0.0 ? (1.0 / size) * way : Vec2{}};
  };
  if (column > 0) add(point - rows, column - 1);
  if (column + 1 < static_cast<std::size_t>(cord.def.points)) add(point + rows, column);
  return pieces;
}

bool is_in_range(const MediumSample& sample) {
  return std::abs(sample.velocity.x) <= max_speed && std::abs(sample.velocity.y) <= max_speed &&
         sample.density >= 0.0 && sample.density <= max_density && is_finite(sample.density_gradient);
}

MediumSample sample_pieces(const CordParts& cord, const Surroundings& surroundings, Vec2 place, const Pieces& pieces,
                           double time) {
  double rise = 0.0;
  for (const Piece& piece : pieces.list()) rise = std::max(rise, piece.length * std::abs(piece.along.y));
  const double thickness = std::max(cord.def.radius, 2.0 * min_half_height * pieces.all[0].length);
  const MediumSample sample = surroundings.medium->at(place, thickness + rise, time);
  return is_in_range(sample) ? sample : MediumSample{};
}

/// kg/m: ½·ρ·d times the length of a piece. A ribbon counts as deep as it is wide.
double area_of(const CordDef& def, double length, double density) {
  return 0.5 * density * (2.0 * def.radius + def.width) * length;
}

Block outer(Vec2 d) { return {d.x * d.x, d.x * d.y, d.y * d.y}; }

/// What a medium does to a point in a stage.
struct MediumLoad {
  Vec2& force;
  Block& resistance;
};

/// What else moves a piece.
struct PieceLoad {
  double q;      // s
  double mass;   // kg
  double area;   // kg/m, see area_of
  double limit;  // √(kg/m·N): root of the area times the forces on the piece apart from tensions and drag
};

/// A coefficient of drag, and its root.
struct Coefficient {
  double value;
  double root;
};

/// Adds the drag −k·|s|·s in a direction, with s the component of the velocity. Any factor c ≥ 0 of the linearisation
///
///     −k·|s₀|·s₀ − c·(s − s₀)
///
/// is right where the velocity is steady. Newton's is c = 2·k·|s₀|: of second order, but then a light piece that enters
/// a medium needs many steps to slow down, as each halves its velocity. With σ = q·k·|s₀|/m it is k·|s₀|·(1 + 1/(1 +
/// σ)), which differs only by an order of q. What is at rest and begins to fall or rise would overshoot the velocity at
/// which drag balances it, s∞; so 2·k·s∞ is added, times q·k·s∞/m if that is below 1. `extra` [N·s/m] is added too.
void add_drag(const Coefficient& coefficient, double speed, Vec2 direction, const PieceLoad& piece, double extra,
              const MediumLoad& load) {
  if (coefficient.value == 0.0 && extra == 0.0) return;
  const double rate = coefficient.value * piece.area * std::abs(speed);
  const double limit = coefficient.root * piece.limit;  // k·s∞
  const double newton = rate * (1.0 + piece.mass / (piece.mass + piece.q * rate));
  const double factor = newton + 2.0 * limit * std::min(1.0, piece.q * limit / piece.mass) + extra;
  load.force -= (rate * speed) * direction;
  load.resistance = load.resistance + (factor / piece.q) * outer(direction);
}

/// The coefficients of a cord.
struct Drags {
  Coefficient across;
  Coefficient along;  // of the surface π·d instead of d
};

Drags drags_of(const CordDef& def) {
  const double along = std::numbers::pi * def.drag_along;
  return {{def.drag_across, std::sqrt(def.drag_across)}, {along, std::sqrt(along)}};
}

/// The forces turn with the link, by up to f/l for a force f and a link of length l. That is not linearised: it has no
/// symmetric matrix. Instead the motion across is slowed down by twice what would keep an explicit step stable, which
/// vanishes with q.
void add_drags(const Drags& drags, const Piece& piece, const PieceLoad& of_piece, Vec2 relative,
               const MediumLoad& load) {
  if (piece.along == Vec2{}) {
    const double speed = length(relative);
    if (speed > 0.0) add_drag(drags.across, speed, (1.0 / speed) * relative, of_piece, 0.0, load);
    return;
  }
  const Vec2 across = perp(piece.along);
  const double along_speed = dot(relative, piece.along);
  const double across_speed = dot(relative, across);
  const double turning = of_piece.area *
                         (drags.across.value * std::abs(across_speed) + drags.along.value * std::abs(along_speed)) *
                         std::abs(along_speed) / piece.length;
  add_drag(drags.across, across_speed, across, of_piece, of_piece.q * turning, load);
  add_drag(drags.along, along_speed, piece.along, of_piece, 0.0, load);
}

/// What floats where the density rises downwards is drawn to its level.
void add_buoyancy(const MediumSample& sample, double volume, Vec2 gravity, const MediumLoad& load) {
  load.force -= (sample.density * volume) * gravity;
  const double g2 = dot(gravity, gravity);
  if (g2 == 0.0) return;
  const double stiffness = volume * std::max(0.0, dot(sample.density_gradient, gravity)) / g2;
  load.resistance = load.resistance + stiffness * outer(gravity);
}

}  // namespace

bool is_in_medium(const CordParts& cord, const Surroundings& surroundings) {
  if (surroundings.medium == nullptr || !feels_medium(cord.def)) return false;
  const std::vector<Vec2>& x = cord.state.positions;
  for (std::size_t p = 0; p < x.size(); ++p) {
    if (sample_pieces(cord, surroundings, x[p], pieces_of(cord, x, p), surroundings.time).density > 0.0) return true;
  }
  return false;
}

MediumPush max_medium_push(const CordParts& cord, const Surroundings& surroundings, double dt, Vec2 gravity) {
  MediumPush push;
  if (surroundings.medium == nullptr || !feels_medium(cord.def)) return push;
  const double coefficient = std::max(cord.def.drag_across, std::numbers::pi * cord.def.drag_along);
  double max_relative2 = 0.0;
  for (std::size_t p = 0; p < cord.size(); ++p) {
    const Pieces pieces = pieces_of(cord, cord.state.positions, p);
    const MediumSample sample = sample_pieces(cord, surroundings, cord.state.positions[p], pieces, surroundings.time);
    const double piece = pieces.length() * pieces.all[0].share;
    const double drag = coefficient * area_of(cord.def, piece, sample.density);
    const double mass = cord.state.masses[p];
    const Vec2 relative = cord.state.velocities[p] - sample.velocity;
    const double speed2 = dot(relative, relative);
    const double lift = sample.density * cord.def.displaced_area * piece * length(gravity);
    double rise = dt * lift / mass;
    if (lift > 0.0 && drag > 0.0) rise = std::min(rise, min_terminal_factor * std::sqrt(lift / drag));
    push.delta_v = std::max(push.delta_v, std::min(std::sqrt(speed2), dt * drag * speed2 / mass) + rise);
    push.impulse += dt * (drag * speed2 + lift);
    max_relative2 = std::max(max_relative2, speed2);
  }
  push.relative_speed = std::sqrt(max_relative2);
  return push;
}

void find_medium_loads(const CordParts& cord, const Surroundings& surroundings, const PredictedMotion& motion,
                       std::span<Vec2> forces, std::span<Block> resistances) {
  const Drags drags = drags_of(cord.def);
  for (std::size_t p = 0; p < forces.size(); ++p) {
    const Pieces pieces = pieces_of(cord, motion.x, p);
    const MediumSample sample = sample_pieces(cord, surroundings, motion.x[p], pieces, motion.time);
    MediumLoad load{forces[p], resistances[p]};
    load.force = {};
    load.resistance = {};
    if (sample.density == 0.0) continue;
    const double mass = cord.state.masses[p];
    const double size = pieces.length() * pieces.all[0].share;
    const double volume = cord.def.displaced_area * size;
    Vec2 outside = (cord.def.gravity_scale * mass - sample.density * volume) * motion.gravity;
    if (!cord.state.loads.empty()) outside += cord.state.loads[p];
    const double area = area_of(cord.def, size, sample.density);
    const double limit = std::sqrt(area * length(outside));
    const Vec2 relative = motion.v[p] - sample.velocity;
    for (const Piece& piece : pieces.list()) {
      const double share = piece.length / pieces.length();
      add_drags(drags, piece, {motion.q, share * mass, share * area, share * limit}, relative, load);
    }
    add_buoyancy(sample, volume, motion.gravity, load);
  }
}

}  // namespace ribbon
